#pragma once

#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "voronaut/dynamics/footprint.h"
#include "voronaut/dynamics/limits.h"
#include "voronaut/dynamics/model.h"
#include "voronaut/dynamics/models/car.h"
#include "voronaut/dynamics/models/cart.h"
#include "voronaut/dynamics/models/ideal.h"
#include "voronaut/dynamics/models/quadrotor.h"
#include "voronaut/dynamics/models/unicycle.h"
#include "voronaut/dynamics/regulator.h"
#include "voronaut/dynamics/regulators/arc_tracker.h"
#include "voronaut/dynamics/regulators/car_tracker.h"
#include "voronaut/dynamics/regulators/cascade_pid.h"
#include "voronaut/dynamics/regulators/ideal.h"
#include "voronaut/dynamics/regulators/lqr.h"
#include "voronaut/dynamics/regulators/paper_literal.h"
#include "voronaut/dynamics/regulators/pd_rate.h"
#include "voronaut/dynamics/regulators/position_trajectory.h"
#include "voronaut/dynamics/regulators/se3.h"

// Models, regulators and vehicles by name. What each can do is told by the virtuals of Model and
// Regulator: nothing outside of this folder asks which one it is.
//
// To add one: a model or regulator is a file and one entry in its variant below, a vehicle is one
// row in catalog.cpp.
namespace voronaut {

// A model's config has kName, a visit list and `Body`, the class that is made from it.
using ModelConfig =
    std::variant<IdealConfig, QuadrotorConfig, CartConfig, UnicycleConfig, CarConfig>;

// A regulator's config has kName, a visit list and `Law`, the class that is made from it. A law
// drives each model from whose config it can be made: Law(config, model's config, limits, period).
using RegulatorConfig =
    std::variant<IdealRegulatorConfig, PaperLiteralConfig, PdRateConfig, PositionTrajectoryConfig,
                 ArcTrackerConfig, CarTrackerConfig, CascadePidConfig, Se3Config, LqrConfig>;

struct VehicleSpec {
  std::string name;
  double body_radius_m = 0.25;  // of the disc about the centre of mass that holds the footprint
  Footprint footprint = {};
  double planning_clearance_m = 0.40;
  MotionLimits limits;
  ModelConfig model;
  std::string regulator;  // the one it flies with unless another is asked for

  // Of the disc that planners keep free of obstacles; and of the largest one that is wholly body.
  double planned_radius_m() const;
  double inscribed_radius_m() const;

  // The model's own parameters are visited apart, on `model`, and the footprint's keys by who reads
  // them (benchmarks/suite/entry_keys.h).
  template <class Visitor>
  void visit(Visitor& v) {
    v.number("body_radius_m", body_radius_m, 0.001, 10,
             "Upright cylinder about the centre of mass, which must touch nothing");
    v.number("planning_clearance_m", planning_clearance_m, 0.001, 20,
             "Centre of mass to obstacle, as planners and governor keep it");
    limits.visit(v);
  }
};

// In alphabetical order.
std::vector<std::string> vehicle_names();
std::vector<std::string> regulator_names();

// With their default parameters. Throw std::invalid_argument that lists the known names.
VehicleSpec find_vehicle(const std::string& name);
RegulatorConfig find_regulator(const std::string& name);

// Throws std::invalid_argument if the parameters make no vehicle (see the models' constructors).
std::unique_ptr<Model> make_model(const ModelConfig& config);

Mobility mobility_of(const VehicleSpec& vehicle);

// Throws std::invalid_argument if the regulator does not drive the vehicle's model. `period_s` is
// the time between two calls of regulate().
std::unique_ptr<Regulator> make_regulator(const RegulatorConfig& config, const VehicleSpec& vehicle,
                                          double period_s);

// Of the regulator that make_regulator makes; throw as it and as Regulator's virtuals do, the
// response also where the period is above its kLongestPeriod_s.
StoppingLaw stopping_law(const RegulatorConfig& config, const VehicleSpec& vehicle);
MotionResponse motion_response(const RegulatorConfig& config, const VehicleSpec& vehicle,
                               double period_s);
// Of what moves in every direction; others throw.
VelocityResponse velocity_response(const RegulatorConfig& config, const VehicleSpec& vehicle,
                                   double period_s);

}  // namespace voronaut
