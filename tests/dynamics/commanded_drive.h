#pragma once

#include <cmath>
#include <memory>
#include <random>
#include <utility>
#include <variant>
#include <vector>

#include "voronaut/dynamics/catalog.h"
#include "voronaut/dynamics/drive_response.h"
#include "voronaut/tests/dynamics/closed_loop.h"

namespace voronaut::testing {

// A vehicle on wheels that drives one commanded arc after the other.
class CommandedDrive {
 public:
  CommandedDrive(VehicleSpec spec, unsigned seed)
      : spec_(std::move(spec)),
        config_(find_regulator(spec_.regulator)),
        model_(make_model(spec_.model)),
        response_(std::get<DriveResponse>(motion_response(config_, spec_, kPeriod_s))),
        random_(seed) {}

  // Begins anew, at rest.
  void begin() {
    regulator_ = make_regulator(config_, spec_, kPeriod_s);
    state_ = model_->at_rest({0, 0, 0}, {1, 0});
    regulator_->reset(state_);
    pending_ = model_->hold();
  }
  void step(const ArcCommand& arc) {
    Setpoint setpoint;
    setpoint.motion = arc;
    const Command next = regulator_->regulate(setpoint, state_);
    state_ = model_->step(state_, pending_, kPeriod_s);
    pending_ = next;
  }
  void drive(const ArcCommand& arc, double duration_s) {
    const long steps = std::lround(duration_s / kPeriod_s);
    for (long i = 0; i < steps; ++i) step(arc);
  }

  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  // Any arc within the limits, forwards or backwards, a turn on the spot, or one straight ahead.
  ArcCommand any_arc() {
    const ArcLimits& limits = response_.limits;
    const double what = uniform(0, 1);
    if (what < 0.2) return {0, uniform(-1, 1) * limits.max_yaw_rate_rad_s};
    const double angle = what < 0.4 ? 0 : uniform(-1, 1);
    const Eigen::Vector2d way(std::cos(angle), std::sin(angle));
    const double length_m = uniform(0.1, 2);
    const double speed_m_s = uniform(0, limits.max_speed_m_s);
    const double now_m_s = motion().v_m_s;
    return what < 0.8 ? arc_towards({1, 0}, length_m * way, speed_m_s, now_m_s, limits)
                      : arc_back_towards({1, 0}, -length_m * way, speed_m_s, now_m_s, limits);
  }
  // Any arc, slowed down to this speed with its curvature kept.
  ArcCommand slow_arc(double speed_max_m_s) {
    ArcCommand arc = any_arc();
    const double speed_m_s = std::abs(arc.v_m_s);
    const double scale = speed_m_s > speed_max_m_s ? speed_max_m_s / speed_m_s : 1;
    return {scale * arc.v_m_s, scale * arc.w_rad_s};
  }
  // Mostly the same again; or none, backwards, or another.
  ArcCommand next_command(const ArcCommand& before) {
    const double what = uniform(0, 1);
    if (what < 0.7) return before;
    if (what < 0.8) return {};
    if (what < 0.85) return {-before.v_m_s, before.w_rad_s};
    return any_arc();
  }

  const VehicleSpec& spec() const { return spec_; }
  const VehicleState& state() const { return state_; }
  const DriveResponse& response() const { return response_; }
  DriveMotion motion() const { return response_.motion_of(state_); }

 private:
  VehicleSpec spec_;
  RegulatorConfig config_;
  std::unique_ptr<Model> model_;
  DriveResponse response_;
  std::mt19937 random_;
  std::unique_ptr<Regulator> regulator_;
  VehicleState state_;
  Command pending_;
};

// Every vehicle of the catalogue that drives along its heading and turns on the spot, and one with
// a slow drive.
inline std::vector<VehicleSpec> wheeled() {
  std::vector<VehicleSpec> specs;
  for (const std::string& name : vehicle_names()) {
    const VehicleSpec spec = find_vehicle(name);
    if (mobility_of(spec).moves_sideways) continue;
    const MotionResponse response =
        motion_response(find_regulator(spec.regulator), spec, kPeriod_s);
    if (std::holds_alternative<DriveResponse>(response)) specs.push_back(spec);
  }
  VehicleSpec slow = find_vehicle("unicycle");
  slow.name = "unicycle_with_lag";
  std::get<UnicycleConfig>(slow.model).drive_lag_s = 0.1;
  specs.push_back(slow);
  return specs;
}

}  // namespace voronaut::testing
