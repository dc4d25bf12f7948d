#pragma once

#include <optional>

#include "voronaut/environments/shapes/geometry.h"

namespace voronaut {

// How the mission gets on, as recovery sees it, once per scan.
struct MissionProgress {
  double now_s = 0;
  Vec2 p_world = Vec2::Zero();
  double speed_m_s = 0;
  bool wants_to_move = false;              // there is a path and it is not yet flown
  bool obstacle_within_clearance = false;  // nearer to a known point than planners plan
  bool unknown_within_clearance = false;   // refused for an unknown place as near as that
  bool virtual_in_force = false;           // planners see virtual obstacles
};

enum class RecoveryAction {
  none,
  back_off,                // away from the nearest known point for a while
  look_around,             // then plan anew
  reduce_clearance,        // for a while go closer to known points than planners plan
  retrace,                 // back the way it came for a while, at reduced clearance, then plan anew
  add_virtual_obstacle,    // where the governor refused, then plan anew
  drop_virtual_obstacles,  // planning failed with them: look around, plan anew
};

// Backing off: 0.6 m, more than the clearance of any vehicle here (0.5 m), at a speed from which
// the slowest of them stops within 0.2 m.
inline constexpr double kBackOff_s = 2;
inline constexpr double kBackOff_m_s = 0.3;
// What looks where it drives turns round before: half a turn at 2 rad/s and its beginning and end.
inline constexpr double kTurnRound_s = 2;
// At reduced clearance a governed vehicle creeps: at 0.3 m/s it is out of a doorway in this time.
inline constexpr double kReducedClearance_s = 4;
// Out of a pocket in legs as long as a body; after each the planner is asked again.
inline constexpr double kRetraceLeg_m = 0.5;
// The governor holds a vehicle back, and does not just slow it down before a corner, if it allows
// less than this of the speed asked for and the vehicle is as slow as that.
inline constexpr double kHeldBackScale = 0.2;
inline constexpr double kHeldBack_m_s = 0.3;

// What to do when the vehicle stands although it should move, or has no path: one step after
// another, from the mildest on, until it has got away from the place. Asks only what navigation
// knows; the same for every planner.
class RecoveryPolicy {
 public:
  explicit RecoveryPolicy(double stall_timeout_s) : stall_timeout_s_(stall_timeout_s) {}

  RecoveryAction advise(const MissionProgress& progress);

  // A manoeuvre is over: what stood still for its sake was no stall.
  void resume() { standing_since_s_.reset(); }

 private:
  RecoveryAction next_step(const MissionProgress& progress);
  RecoveryAction step_without_path(const MissionProgress& progress);
  RecoveryAction step_under_way(const MissionProgress& progress) const;

  double stall_timeout_s_;
  std::optional<double> standing_since_s_;
  Vec2 place_ = Vec2::Zero();  // where it stalled last
  int steps_taken_ = 0;        // at this place
  int drops_ = 0;
};

}  // namespace voronaut
