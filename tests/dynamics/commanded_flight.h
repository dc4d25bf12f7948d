#pragma once

#include <cmath>
#include <memory>
#include <random>
#include <utility>

#include "voronaut/dynamics/catalog.h"
#include "voronaut/dynamics/velocity_response.h"
#include "voronaut/tests/dynamics/closed_loop.h"

namespace voronaut::testing {

// A vehicle that flies one commanded velocity after the other at 1 m of height, turning as it
// likes.
class CommandedFlight {
 public:
  CommandedFlight(VehicleSpec spec, const RegulatorConfig& config, unsigned seed,
                  double period_s = kPeriod_s)
      : spec_(std::move(spec)),
        config_(config),
        period_s_(period_s),
        model_(make_model(spec_.model)),
        response_(velocity_response(config, spec_, period_s)),
        random_(seed) {}

  // Begins anew, at rest.
  void begin() {
    regulator_ = make_regulator(config_, spec_, period_s_);
    state_ = model_->at_rest({0, 0, 1}, {1, 0});
    regulator_->reset(state_);
    pending_ = model_->hold();
    turns_on_ = uniform(0, 1) < 0.5;
    yaw_rate_rad_s_ = uniform(-2, 2);
  }
  void step(const Eigen::Vector2d& v_command_m_s, double yaw_rate_rad_s) {
    Setpoint setpoint;
    setpoint.height_m = 1;
    setpoint.motion = VelocityCommand{v_command_m_s};
    if (turns_on_) setpoint.heading_world = state_.heading_world();
    setpoint.yaw_rate_rad_s = yaw_rate_rad_s;
    const Command next = regulator_->regulate(setpoint, state_);
    state_ = model_->step(state_, pending_, period_s_);
    pending_ = next;
  }
  void fly(const Eigen::Vector2d& v_command_m_s, double duration_s) {
    if (!turns_on_) yaw_rate_rad_s_ = uniform(-2, 2);
    const long steps = std::lround(duration_s / period_s_);
    for (long i = 0; i < steps; ++i) step(v_command_m_s, yaw_rate_rad_s_);
  }

  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  Eigen::Vector2d direction() {
    const double angle = uniform(-3.2, 3.2);
    return {std::cos(angle), std::sin(angle)};
  }

  const VehicleSpec& spec() const { return spec_; }
  double period_s() const { return period_s_; }
  const VehicleState& state() const { return state_; }
  const VelocityResponse& response() const { return response_; }
  PlanarMotion motion() const { return response_.motion_of(state_); }

 private:
  VehicleSpec spec_;
  RegulatorConfig config_;
  double period_s_;
  std::unique_ptr<Model> model_;
  VelocityResponse response_;
  std::mt19937 random_;
  std::unique_ptr<Regulator> regulator_;
  VehicleState state_;
  Command pending_;
  bool turns_on_ = false;  // all through the flight; else another rate for every command
  double yaw_rate_rad_s_ = 0;
};

inline VehicleSpec quadrotor_with_printed_inertia() {
  VehicleSpec spec = find_vehicle("quadrotor");
  std::get<QuadrotorConfig>(spec.model).inertia = QuadrotorConfig::InertiaSet::printed;
  return spec;
}

}  // namespace voronaut::testing
