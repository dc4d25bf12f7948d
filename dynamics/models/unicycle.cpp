#include "voronaut/dynamics/models/unicycle.h"

#include <algorithm>
#include <cmath>

#include <sleef.h>

#include "voronaut/dynamics/attitude.h"

namespace voronaut {
namespace {

using Eigen::Vector2d;

// How one of the two velocities follows what is asked for: at its limit first, then with its lag.
class DriveAnswer {
 public:
  DriveAnswer(double from, double asked, double rate_max, double lag_s)
      : from_(from), asked_(asked), lag_s_(lag_s) {
    const double error = asked - from;
    const double settles_from = std::min(std::abs(error), rate_max * lag_s);
    ramp_s_ = (std::abs(error) - settles_from) / rate_max;
    rate_ = std::copysign(rate_max, error);
    settling_ = std::copysign(settles_from, error);
  }

  double ramp_s() const { return ramp_s_; }

  double at(double t_s) const {
    if (t_s < ramp_s_) return from_ + rate_ * t_s;
    return asked_ - settling_ * decay(t_s - ramp_s_);
  }
  // Of the velocity, from the start of the step on.
  double integral(double t_s) const {
    const double ramp_s = std::min(t_s, ramp_s_);
    const double ramped = (from_ + 0.5 * rate_ * ramp_s) * ramp_s;
    if (t_s <= ramp_s_) return ramped;
    const double rest_s = t_s - ramp_s_;
    return ramped + asked_ * rest_s - settling_ * lag_s_ * (1 - decay(rest_s));
  }

 private:
  double decay(double t_s) const {
    return lag_s_ > 0 ? Sleef_cinz_expd1_u10purec(-t_s / lag_s_) : 0;
  }

  double from_, asked_, lag_s_;
  double ramp_s_, rate_, settling_;
};

Vector2d turned(const Vector2d& heading, double angle_rad) {
  const Sleef_double_2 turn = Sleef_cinz_sincosd1_u10purec(angle_rad);
  return {turn.y * heading.x() - turn.x * heading.y(), turn.x * heading.x() + turn.y * heading.y()};
}

}  // namespace

VehicleState Unicycle::at_rest(const Vec3& p_world, const Vector2d& heading_world) const {
  VehicleState state;
  state.p_world = p_world;
  state.q_world_body = level_attitude(heading_world);
  return state;
}

VehicleState Unicycle::step(const VehicleState& state, const Command& command,
                            double period_s) const {
  const UnicycleConfig& c = config_;
  const Vector2d ahead = state.heading_world();
  const DriveAnswer drive(ahead.dot(state.v_world.head<2>()),
                          std::clamp(command.u[0], -c.max_speed_m_s, c.max_speed_m_s),
                          c.max_acceleration_m_s2, c.drive_lag_s);
  const DriveAnswer turn(state.w_body.z(),
                         std::clamp(command.u[1], -c.max_yaw_rate_rad_s, c.max_yaw_rate_rad_s),
                         c.max_yaw_acceleration_rad_s2, c.drive_lag_s);
  const auto heading_at = [&](double t_s) { return turned(ahead, turn.integral(t_s)); };
  const auto velocity_at = [&](double t_s) { return Vector2d(drive.at(t_s) * heading_at(t_s)); };

  // A ramp that ends within the step is a kink there.
  std::array kinks_s{std::min(drive.ramp_s(), period_s), std::min(turn.ramp_s(), period_s)};
  std::sort(kinks_s.begin(), kinks_s.end());
  Vector2d way = Vector2d::Zero();
  double from_s = 0;
  for (const double to_s : {kinks_s[0], kinks_s[1], period_s}) {
    if (to_s <= from_s) continue;
    const Vector2d middle = velocity_at(0.5 * (from_s + to_s));
    way += (to_s - from_s) / 6 * (velocity_at(from_s) + 4 * middle + velocity_at(to_s));
    from_s = to_s;
  }

  const Vector2d heading = heading_at(period_s).normalized();
  const double speed_m_s = drive.at(period_s);
  VehicleState next;
  next.p_world = {state.p_world.x() + way.x(), state.p_world.y() + way.y(), state.p_world.z()};
  next.v_world = {speed_m_s * heading.x(), speed_m_s * heading.y(), 0};
  next.q_world_body = level_attitude(heading);
  next.w_body = {0, 0, turn.at(period_s)};
  return next;
}

}  // namespace voronaut
