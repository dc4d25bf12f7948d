#include "voronaut/planners/navigation/state_estimate.h"

#include <cmath>
#include <utility>

#include "voronaut/environments/shapes/geometry.h"

namespace voronaut {

namespace {

// A small angle's turn by its series, to 1e-7 at 0.1 rad.
Vec2 turned_a_little(const Vec2& direction, double angle_rad) {
  const double square = angle_rad * angle_rad;
  return (1 - square / 2) * direction + angle_rad * (1 - square / 6) * left_of(direction);
}

// `state` seen from elsewhere: with this heading (unit vector), its velocities turned along.
VehicleState with_heading(VehicleState state, const Vec2& heading) {
  const Vec2 told = state.heading_world();
  const double c = told.dot(heading), s = cross(told, heading);
  const double half_c = std::sqrt(0.5 * (1 + c));
  const Eigen::Quaterniond turn(half_c, 0, 0, 0.5 * s / half_c);
  const Vec2 v = state.v_world.head<2>();
  state.v_world.head<2>() = c * v + s * left_of(v);
  state.q_world_body = turn * state.q_world_body;
  return state;
}

}  // namespace

StateEstimate::StateEstimate(const DeclaredErrors& errors, Step step, const Command& hold,
                             double period_s)
    : gain_(errors.pose_gain),
      period_s_(period_s),
      step_(std::move(step)),
      under_way_(static_cast<std::size_t>(std::lround(errors.latency_s / period_s)), hold) {}

void StateEstimate::take(const VehicleState& told) {
  if (gain_ == 1) {
    here_ = &told;
  } else {
    if (begun_)
      observe(told);
    else
      now_ = told;
    begun_ = true;
    here_ = &now_;
  }
  if (under_way_.empty()) return;
  then_ = *here_;
  for (const Command& each : under_way_) then_ = step_(then_, each);
}

void StateEstimate::command(const Command& given) {
  if (under_way_.empty()) return;
  under_way_.push_back(given);
  under_way_.pop_front();
}

void StateEstimate::observe(const VehicleState& told) {
  const double turn_rad = 0.5 * period_s_ * (now_.w_body.z() + told.w_body.z());
  const Vec2 reckoned_heading = turned_a_little(now_.heading_world(), turn_rad);
  const Vec2 heading = ((1 - gain_) * reckoned_heading + gain_ * told.heading_world()).normalized();
  const Vec2 p_before = now_.p_world.head<2>(), v_before = now_.v_world.head<2>();
  now_ = with_heading(told, heading);
  const Vec2 reckoned_p = p_before + 0.5 * period_s_ * (v_before + now_.v_world.head<2>());
  now_.p_world.head<2>() = (1 - gain_) * reckoned_p + gain_ * told.p_world.head<2>();
}

}  // namespace voronaut
