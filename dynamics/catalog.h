#pragma once

#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "voronaut/dynamics/limits.h"
#include "voronaut/dynamics/model.h"
#include "voronaut/dynamics/models/cart.h"
#include "voronaut/dynamics/models/ideal.h"
#include "voronaut/dynamics/models/quadrotor.h"
#include "voronaut/dynamics/regulator.h"
#include "voronaut/dynamics/regulators/ideal.h"
#include "voronaut/dynamics/regulators/paper_literal.h"
#include "voronaut/dynamics/regulators/pd_rate.h"
#include "voronaut/dynamics/regulators/position_trajectory.h"
#include "voronaut/dynamics/velocity_response.h"

// Vehicles and regulators by name. Every config in the variants has a visit list:
// std::visit([&](auto& config) { config.visit(v); }, spec.model).
namespace voronaut {

using ModelConfig = std::variant<IdealConfig, QuadrotorConfig, CartConfig>;
using RegulatorConfig =
    std::variant<IdealRegulatorConfig, PdRateConfig, PaperLiteralConfig, PositionTrajectoryConfig>;

struct VehicleSpec {
  std::string name;
  double body_radius_m = 0.25;    // upright cylinder about the centre of mass
  double clearance_min_m = 0.40;  // planning: centre of mass to obstacle
  MotionLimits limits;
  ModelConfig model;
  std::string regulator;  // the one it flies with unless another is asked for

  // The model's own parameters are visited apart, on `model`.
  template <class Visitor>
  void visit(Visitor& v) {
    v.number("body_radius_m", body_radius_m, 0.001, 10);
    v.number("clearance_min_m", clearance_min_m, 0.001, 20);
    limits.visit(v);
  }
};

// Rolls on the ground and only where it is heading: it keeps its height, looks where it drives and
// cannot be promised to stop along a course in any direction (velocity_response throws).
bool is_wheeled(const VehicleSpec& vehicle);

std::vector<std::string> vehicle_names();
std::vector<std::string> regulator_names();

// Throw std::invalid_argument that lists the known names.
VehicleSpec vehicle(const std::string& name);
RegulatorConfig regulator(const std::string& name);

// Throws std::invalid_argument if the parameters make no vehicle (see the models' constructors).
std::unique_ptr<Model> make_model(const ModelConfig& config);

// Throws std::invalid_argument if the regulator does not fit the vehicle's model. `period_s` is the
// time between two calls of regulate().
std::unique_ptr<Regulator> make_regulator(const RegulatorConfig& config, const VehicleSpec& vehicle,
                                          double period_s);

// The law by which a vehicle under a regulator stops: what stopping_distance_m and safe_speed_m_s
// of stopping.h take.
struct StoppingLaw {
  double k_1_s;
  double a_m_s2;
};

// Throws like make_regulator. For paper_literal, which does not stop, kp/kd and the tilt limit.
StoppingLaw stopping_law(const RegulatorConfig& config, const VehicleSpec& vehicle);

// How velocity answers a command under a regulator. Throws like make_regulator, for paper_literal,
// whose loop is unstable: no stop can be promised for it, and for wheeled vehicles.
VelocityResponse velocity_response(const RegulatorConfig& config, const VehicleSpec& vehicle,
                                   double period_s);

}  // namespace voronaut
