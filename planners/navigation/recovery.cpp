#include "voronaut/planners/navigation/recovery.h"

namespace voronaut {

namespace {

constexpr double kStanding_m_s = 0.05;
// Farther than this from the place of the last stall, the vehicle has got away from it.
constexpr double kAway_m = 0.5;
// Virtual obstacles are dropped this often; then a stall is final, and the referee's to judge.
constexpr int kDropsMax = 3;
// Steps from the mildest to the harshest.
constexpr int kRound = 4;

}  // namespace

std::string_view to_string(ExecutiveState state) {
  switch (state) {
    case ExecutiveState::rising:
      return "rising";
    case ExecutiveState::looking_around:
      return "looking_around";
    case ExecutiveState::under_way:
      return "under_way";
    case ExecutiveState::backing_off:
      return "backing_off";
    case ExecutiveState::retracing:
      return "retracing";
    case ExecutiveState::without_path:
      return "without_path";
  }
  return "under_way";
}

RecoveryAction RecoveryPolicy::advise(const Headway& headway) {
  if (steps_taken_ > 0 && (headway.p_world - place_).norm() > kAway_m) steps_taken_ = 0;
  if (headway.wants_to_move && headway.speed_m_s > kStanding_m_s) {
    standing_since_s_.reset();
    return RecoveryAction::none;
  }
  if (!standing_since_s_) standing_since_s_ = headway.now_s;
  if (headway.now_s - *standing_since_s_ < stall_timeout_s_) return RecoveryAction::none;
  standing_since_s_ = headway.now_s;
  if (steps_taken_ == 0) place_ = headway.p_world;
  ++steps_taken_;
  return next_step(headway);
}

RecoveryAction RecoveryPolicy::next_step(const Headway& headway) {
  if (!headway.wants_to_move) {
    if (!headway.virtual_in_force) {
      if (!headway.too_close || steps_taken_ % 3 == 2) return RecoveryAction::look_around;
      // Between what is too close on both sides there is no backing off.
      return steps_taken_ % 3 == 1 ? RecoveryAction::back_off : RecoveryAction::retrace;
    }
    return drops_++ < kDropsMax ? RecoveryAction::drop_virtual_obstacles : RecoveryAction::none;
  }
  // Over and over: what did not help at first may do so from where the other steps led.
  switch ((steps_taken_ - 1) % kRound) {
    case 0:
      if (steps_taken_ > kRound && headway.virtual_in_force)
        return RecoveryAction::drop_virtual_obstacles;
      return headway.too_close ? RecoveryAction::back_off : RecoveryAction::look_around;
    case 1:
      return headway.hemmed_in && !headway.too_close ? RecoveryAction::back_off
                                                     : RecoveryAction::look_around;
    case 2:
      // In a passage that turned out narrower than planners plan for, any way out is as narrow.
      if (headway.too_close || headway.hemmed_in) return RecoveryAction::squeeze;
      [[fallthrough]];
    default:
      return RecoveryAction::add_virtual_obstacle;
  }
}

}  // namespace voronaut
