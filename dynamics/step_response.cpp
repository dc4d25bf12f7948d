#include "voronaut/dynamics/step_response.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <sleef.h>

namespace voronaut {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kHeight_m = 1;
constexpr double kFar_m = 1e6;
// Long enough for every step to settle; what has not by then never does.
constexpr double kDuration_s = 15;
constexpr double kSteady_s = 10;

double cosine_of_tilt(const VehicleState& state) {
  return (state.q_world_body * Vec3::UnitZ()).z();
}

Setpoint along_x(double speed_m_s) {
  return {.motion = PassTarget{{kFar_m, 0}, speed_m_s}, .height_m = kHeight_m};
}

// A vehicle at rest at x = 0, and its flight so far.
class SteppedFlight {
 public:
  SteppedFlight(const VehicleSpec& vehicle, const RegulatorConfig& regulator, double period_s)
      : period_s_(period_s),
        model_(make_model(vehicle.model)),
        regulator_(make_regulator(regulator, vehicle, period_s)),
        pending_(model_->hold()),
        states_{model_->at_rest({0, 0, kHeight_m}, {1, 0})} {
    regulator_->reset(states_.front());
  }

  void fly(const Setpoint& setpoint, double duration_s) {
    const auto steps = std::lround(duration_s / period_s_);
    for (long i = 0; i < steps; ++i) {
      const VehicleState& state = states_.back();
      const Command next = regulator_->regulate(setpoint, state);
      states_.push_back(model_->step(state, pending_, period_s_));
      pending_ = next;
    }
  }

  bool stayed_upright() const {
    return std::ranges::all_of(states_,
                               [](const VehicleState& s) { return cosine_of_tilt(s) > 0; });
  }
  const std::vector<VehicleState>& states() const { return states_; }

 private:
  double period_s_;
  std::unique_ptr<Model> model_;
  std::unique_ptr<Regulator> regulator_;
  Command pending_;
  std::vector<VehicleState> states_;
};

}  // namespace

VelocityStep velocity_step(const VehicleSpec& vehicle, const RegulatorConfig& regulator,
                           double speed_m_s, double period_s) {
  SteppedFlight flight(vehicle, regulator, period_s);
  flight.fly(along_x(speed_m_s), kDuration_s);
  if (!flight.stayed_upright()) return {kNone, kNone, kNone, kNone, kNone};
  VelocityStep step{};
  double least_cosine = 1;
  for (std::size_t i = 0; i < flight.states().size(); ++i) {
    const VehicleState& s = flight.states()[i];
    const double next_s = static_cast<double>(i + 1) * period_s;
    const double error_m_s = s.v_world.x() - speed_m_s;
    if (error_m_s < -0.1 * speed_m_s) step.rise_s = next_s;
    if (std::abs(error_m_s) > 0.02 * speed_m_s) step.settling_s = next_s;
    step.overshoot_m_s = std::max(step.overshoot_m_s, error_m_s);
    step.height_error_m = std::max(step.height_error_m, std::abs(s.p_world.z() - kHeight_m));
    least_cosine = std::min(least_cosine, cosine_of_tilt(s));
  }
  step.max_tilt_rad = Sleef_cinz_acosd1_u10purec(least_cosine);
  return step;
}

PositionStep position_step(const VehicleSpec& vehicle, const RegulatorConfig& regulator,
                           double distance_m, double period_s) {
  SteppedFlight flight(vehicle, regulator, period_s);
  flight.fly({.motion = RestAtTarget{{distance_m, 0}, vehicle.limits.max_speed_m_s},
              .height_m = kHeight_m},
             2 * kDuration_s);
  if (!flight.stayed_upright()) return {kNone, kNone};
  PositionStep step{};
  for (std::size_t i = 0; i < flight.states().size(); ++i) {
    const double error_m = flight.states()[i].p_world.x() - distance_m;
    if (std::abs(error_m) > 0.05) step.settling_s = static_cast<double>(i + 1) * period_s;
    step.overshoot_m = std::max(step.overshoot_m, error_m);
  }
  return step;
}

double flown_stop_m(const VehicleSpec& vehicle, const RegulatorConfig& regulator, double speed_m_s,
                    double period_s) {
  SteppedFlight flight(vehicle, regulator, period_s);
  flight.fly(along_x(speed_m_s), kSteady_s);
  const double from_m = flight.states().back().p_world.x();
  flight.fly(along_x(0), kDuration_s);
  if (!flight.stayed_upright()) return kNone;
  double farthest_m = from_m;
  for (const VehicleState& s : flight.states()) farthest_m = std::max(farthest_m, s.p_world.x());
  return farthest_m - from_m;
}

StepAnswer step_answer(const VehicleSpec& vehicle, const RegulatorConfig& regulator,
                       double period_s) {
  const PositionStep step = position_step(vehicle, regulator, kAnswerStep_m, period_s);
  const bool settles = step.settling_s < 2 * kDuration_s;
  return {settles ? step.settling_s : kNone, step.overshoot_m,
          flown_stop_m(vehicle, regulator, vehicle.limits.max_speed_m_s, period_s)};
}

}  // namespace voronaut
