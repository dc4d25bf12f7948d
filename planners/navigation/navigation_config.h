#pragma once

namespace voronaut {

// What the heading follows.
enum class YawReference {
  fixed,  // towards the goal as seen from the start (the papers: yaw does not change)
  path,   // along the path, a little ahead of the vehicle
};

// How fast a vehicle may go towards what it has not seen.
enum class SpeedRule {
  unlimited,          // always up to the vehicle's limit (the papers)
  stopping_distance,  // only so fast that it can stop within what the beams have shown free
};

// The executive's policies; the same for every planner of a suite.
struct NavigationConfig {
  YawReference yaw_policy = YawReference::fixed;
  SpeedRule speed_rule = SpeedRule::unlimited;
  bool governor = false;           // let only such commands pass from which a stop is safe
  bool look_around = false;        // turn once around before setting off
  bool recovery = false;           // do something about it when the vehicle stands still
  double stall_timeout_s = 1.5;    // recovery: standing still for so long is a stall
  bool shortcut = true;            // drop the corners that a planner's path does not need
  double reaction_time_s = 0.06;   // sensing period plus command delay
  double lookahead_base_m = 0.25;  // tracker: how far ahead of the projection it aims at rest
  double lookahead_per_speed_s = 0.35;
  double off_path_m = 0.5;                // farther from its path than this: plan again
  double corner_deceleration_m_s2 = 1.0;  // a corner ahead is taken at a speed it can brake to

  template <class Visitor>
  void visit(Visitor& v) {
    v.choice("yaw_policy", yaw_policy,
             {{"fixed", YawReference::fixed}, {"path", YawReference::path}});
    v.choice(
        "speed_rule", speed_rule,
        {{"unlimited", SpeedRule::unlimited}, {"stopping_distance", SpeedRule::stopping_distance}});
    v.flag("governor", governor);
    v.flag("look_around", look_around);
    v.flag("recovery", recovery);
    v.number("stall_timeout_s", stall_timeout_s, 0.1, 60);
    v.flag("shortcut", shortcut);
    v.number("reaction_time_s", reaction_time_s, 0, 5);
    v.number("lookahead_base_m", lookahead_base_m, 0.01, 10);
    v.number("lookahead_per_speed_s", lookahead_per_speed_s, 0, 10);
    v.number("off_path_m", off_path_m, 0.05, 100);
    v.number("corner_deceleration_m_s2", corner_deceleration_m_s2, 0.05, 100);
  }
};

}  // namespace voronaut
