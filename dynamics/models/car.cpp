#include "voronaut/dynamics/models/car.h"

#include <algorithm>

#include <sleef.h>

#include "voronaut/dynamics/attitude.h"
#include "voronaut/dynamics/integrate.h"

namespace voronaut {
namespace {

// x, y, cosine and sine of the heading, speed, steering angle.
using Steered = std::array<double, 6>;

double curvature_1_m(double steering_rad, double wheelbase_m) {
  return Sleef_cinz_tand1_u10purec(steering_rad) / wheelbase_m;
}

}  // namespace

VehicleState Car::at_rest(const Vec3& p_world, const Eigen::Vector2d& heading_world) const {
  VehicleState state;
  state.p_world = p_world;
  state.q_world_body = level_attitude(heading_world);
  return state;
}

VehicleState Car::step(const VehicleState& state, const Command& command, double period_s) const {
  const CarConfig& c = config_;
  const double steering_rad = state.actuators[0];
  const double acceleration =
      std::clamp(command.u[0], -c.max_acceleration_m_s2, c.max_acceleration_m_s2);
  const double rate =
      std::clamp(std::clamp(command.u[1], -c.max_steering_rate_rad_s, c.max_steering_rate_rad_s),
                 (-c.max_steering_rad - steering_rad) / period_s,
                 (c.max_steering_rad - steering_rad) / period_s);
  const auto derivative = [&](const Steered& x) -> Steered {
    const double w = x[4] * curvature_1_m(x[5], c.wheelbase_m);
    return {x[4] * x[2], x[4] * x[3], -w * x[3], w * x[2], acceleration, rate};
  };
  const Eigen::Vector2d ahead = state.heading_world();
  const Steered start{state.p_world.x(),
                      state.p_world.y(),
                      ahead.x(),
                      ahead.y(),
                      ahead.dot(state.v_world.head<2>()),
                      steering_rad};
  const Steered x = rk4_step(start, period_s, derivative);

  const Eigen::Vector2d heading = Eigen::Vector2d(x[2], x[3]).normalized();
  VehicleState next;
  next.p_world = {x[0], x[1], state.p_world.z()};
  next.v_world = {x[4] * heading.x(), x[4] * heading.y(), 0};
  next.q_world_body = level_attitude(heading);
  next.w_body = {0, 0, x[4] * curvature_1_m(x[5], c.wheelbase_m)};
  next.actuators = {x[5], 0, 0, 0};
  return next;
}

}  // namespace voronaut
