#pragma once

#include "voronaut/dynamics/catalog.h"

// How a vehicle under its regulator answers steps of what it is asked for: the figures by which
// regulators are compared. Flown with the model, along +x at 1 m of height, each command applied
// one period late as in a trial. NaN where the vehicle lies on its side before the end.
namespace voronaut {

// From rest to a speed.
struct VelocityStep {
  double rise_s;         // to 90 % of it
  double settling_s;     // within 2 % of it for good
  double overshoot_m_s;  // beyond it
  double max_tilt_rad;
  double height_error_m;  // the largest
};
VelocityStep velocity_step(const VehicleSpec& vehicle, const RegulatorConfig& regulator,
                           double speed_m_s, double period_s);

// To rest at a point ahead.
struct PositionStep {
  double settling_s;   // within 5 cm for good
  double overshoot_m;  // beyond it
};
PositionStep position_step(const VehicleSpec& vehicle, const RegulatorConfig& regulator,
                           double distance_m, double period_s);

// From steady flight at a speed until it stands: the farthest that it comes.
double flown_stop_m(const VehicleSpec& vehicle, const RegulatorConfig& regulator, double speed_m_s,
                    double period_s);

// What records say of a vehicle under its regulator: the step to a point kAnswerStep_m ahead, and
// the stop from the vehicle's largest speed. NaN for what never settles or tips over.
inline constexpr double kAnswerStep_m = 5;
struct StepAnswer {
  double settling_s;
  double overshoot_m;
  double stopping_distance_m;
};
StepAnswer step_answer(const VehicleSpec& vehicle, const RegulatorConfig& regulator,
                       double period_s);

}  // namespace voronaut
