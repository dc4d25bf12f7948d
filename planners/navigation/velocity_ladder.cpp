#include "voronaut/planners/navigation/velocity_ladder.h"

#include <algorithm>
#include <array>

namespace voronaut {

namespace {

// Level 0 is braking.
constexpr std::array kVelocityScales = {0.0, 0.05, 0.12, 0.25, 0.4, 0.6, 0.8, 1.0};

}  // namespace

void VelocityLadder::set_up(const WantedMotion& wanted, const VehicleState& state) {
  v_wanted_ = v_set_up_ = wanted.v_world;
  now_ = response_.motion_of(state);
}

std::size_t VelocityLadder::top() const {
  return v_wanted_.squaredNorm() > 0 ? kVelocityScales.size() - 1 : 0;
}

void VelocityLadder::turn_aside(const Vec2& rotation) {
  v_wanted_ = rotation.x() * v_set_up_ + rotation.y() * left_of(v_set_up_);
}

double VelocityLadder::speed_scale(std::size_t level) const { return kVelocityScales[level]; }

Vec2 VelocityLadder::v_command(std::size_t level) const {
  if (level == 0) return Vec2(0, 0);
  return now_.v_m_s + kVelocityGain * (kVelocityScales[level] * v_wanted_ - now_.v_m_s);
}

MotionCommand VelocityLadder::command(std::size_t level) const {
  return VelocityCommand{v_command(level)};
}

PredictedStop VelocityLadder::predict(std::size_t level, double hold_s, double sample_s,
                                      std::vector<Vec2>& track, std::vector<Vec2>*) const {
  const Vec2 command = v_command(level);
  response_.predict_stop(now_, v_before_, command, hold_s, sample_s, track);
  return {command, std::max(command.norm(), now_.v_m_s.norm()),
          response_.error_m(now_, kVelocityScales[level] * v_wanted_)};
}

double VelocityLadder::stray_m(const VehicleState& state) const {
  const PlanarMotion now = response_.motion_of(state);
  return response_.error_m(now, now.v_m_s);
}

}  // namespace voronaut
