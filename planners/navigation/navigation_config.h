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

// The executive's policies; the same for every planner of a suite. The defaults are careful: what
// has no other reason flies so.
struct NavigationConfig {
  YawReference yaw_policy = YawReference::path;
  SpeedRule speed_rule = SpeedRule::unlimited;
  bool governor = true;
  bool look_around = true;
  bool recovery = true;
  double stall_timeout_s = 1.5;
  bool shortcut = true;
  double reaction_time_s = 0.06;
  double lookahead_base_m = 0.25;
  double lookahead_per_speed_s = 0.35;
  double off_path_m = 0.5;
  double corner_deceleration_m_s2 = 1.0;

  // As the two papers fly: towards the goal with a fixed yaw, whatever is seen; nothing is vetoed.
  static NavigationConfig paper() {
    NavigationConfig config;
    config.yaw_policy = YawReference::fixed;
    config.governor = config.look_around = config.recovery = false;
    return config;
  }

  template <class Visitor>
  void visit(Visitor& v) {
    v.presets(*this, {{"careful", {}}, {"paper", paper()}},
              "What the other keys are unless they are said; alone: `navigation: paper`");
    v.choice(
        "yaw_policy", yaw_policy, {{"fixed", YawReference::fixed}, {"path", YawReference::path}},
        "Look at the goal as seen from the start (the papers), or along the path, a little ahead");
    v.choice(
        "speed_rule", speed_rule,
        {{"unlimited", SpeedRule::unlimited}, {"stopping_distance", SpeedRule::stopping_distance}},
        "Up to the vehicle's limit (the papers), or only so fast that it can stop in what beams "
        "showed free");
    v.flag("governor", governor, "Let only such courses pass from which a stop is safe");
    v.flag("look_around", look_around, "Turn once around before setting off");
    v.flag("recovery", recovery, "Do something about it when the vehicle stands still");
    v.number("stall_timeout_s", stall_timeout_s, 0.1, 60,
             "recovery: standing still for so long is a stall");
    v.flag("shortcut", shortcut, "Drop the corners that a planner's path does not need");
    v.number("reaction_time_s", reaction_time_s, 0, 5,
             "Sensing period plus command delay, as speed_rule assumes them");
    v.number("lookahead_base_m", lookahead_base_m, 0.01, 10,
             "How far ahead of its projection onto the path the vehicle aims at rest");
    v.number("lookahead_per_speed_s", lookahead_per_speed_s, 0, 10,
             "And how much farther per speed");
    v.number("off_path_m", off_path_m, 0.05, 100, "Farther from its path than this: plan again");
    v.number("corner_deceleration_m_s2", corner_deceleration_m_s2, 0.05, 100,
             "A corner ahead is taken at a speed to which this brakes");
  }
};

}  // namespace voronaut
