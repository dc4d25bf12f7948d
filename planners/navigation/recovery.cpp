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

RecoveryAction RecoveryPolicy::advise(const MissionProgress& progress) {
  if (steps_taken_ > 0 && (progress.p_world - place_).norm() > kAway_m) steps_taken_ = 0;
  if (progress.wants_to_move && progress.speed_m_s > kStanding_m_s) {
    standing_since_s_.reset();
    return RecoveryAction::none;
  }
  if (!standing_since_s_) standing_since_s_ = progress.now_s;
  if (progress.now_s - *standing_since_s_ < stall_timeout_s_) return RecoveryAction::none;
  standing_since_s_ = progress.now_s;
  if (steps_taken_ == 0) place_ = progress.p_world;
  ++steps_taken_;
  return next_step(progress);
}

RecoveryAction RecoveryPolicy::next_step(const MissionProgress& progress) {
  return progress.wants_to_move ? step_under_way(progress) : step_without_path(progress);
}

RecoveryAction RecoveryPolicy::step_without_path(const MissionProgress& progress) {
  if (progress.virtual_in_force)
    return drops_++ < kDropsMax ? RecoveryAction::drop_virtual_obstacles : RecoveryAction::none;
  if (!progress.obstacle_within_clearance || steps_taken_ % 3 == 2)
    return RecoveryAction::look_around;
  // Between what is too close on both sides there is no backing off.
  return steps_taken_ % 3 == 1 ? RecoveryAction::back_off : RecoveryAction::retrace;
}

RecoveryAction RecoveryPolicy::step_under_way(const MissionProgress& progress) const {
  // Over and over: what did not help at first may do so from where the other steps led.
  switch ((steps_taken_ - 1) % kRound) {
    case 0:
      if (steps_taken_ > kRound && progress.virtual_in_force)
        return RecoveryAction::drop_virtual_obstacles;
      return progress.obstacle_within_clearance ? RecoveryAction::back_off
                                                : RecoveryAction::look_around;
    case 1:
      return progress.unknown_within_clearance && !progress.obstacle_within_clearance
                 ? RecoveryAction::back_off
                 : RecoveryAction::look_around;
    case 2:
      // In a passage that turned out narrower than planners plan for, any way out is as narrow.
      if (progress.obstacle_within_clearance || progress.unknown_within_clearance)
        return RecoveryAction::reduce_clearance;
      [[fallthrough]];
    default:
      return RecoveryAction::add_virtual_obstacle;
  }
}

}  // namespace voronaut
