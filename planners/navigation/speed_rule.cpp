#include "voronaut/planners/navigation/speed_rule.h"

#include <algorithm>

#include "voronaut/dynamics/stopping.h"

namespace voronaut {

namespace {

// Steps of the search for the free way: a fortieth of the range is finer than the points are apart.
constexpr int kBisections = 6;

// The braking law is a fit to the full model: go this much slower than it allows.
constexpr double kMargin = 0.9;

bool in_view(const Scan& scan, const Eigen::Vector2d& towards) {
  if (scan.beams->full_circle()) return true;
  const Eigen::Vector2d right_most = scan.direction_world(0);
  return towards.dot(scan.sensor_world.heading) >= right_most.dot(scan.sensor_world.heading);
}

double free_way_m(const Belief& belief, const Eigen::Vector2d& towards, double clearance_m) {
  const Vec2& p = belief.pose_world.p_world;
  const double range_m = belief.scan->max_range_m;
  const auto is_free = [&](double way_m) {
    return belief.obstacles.swept_disc_is_clear(p, p + way_m * towards, clearance_m);
  };
  if (is_free(range_m)) return range_m;
  double free_m = 0;
  double blocked_m = range_m;
  for (int i = 0; i < kBisections; ++i) {
    const double middle_m = 0.5 * (free_m + blocked_m);
    (is_free(middle_m) ? free_m : blocked_m) = middle_m;
  }
  return free_m;
}

}  // namespace

double speed_limit_m_s(SpeedRule rule, const Belief& belief, const Eigen::Vector2d& towards,
                       const Braking& braking, double reaction_time_s, double max_speed_m_s) {
  if (rule == SpeedRule::unlimited || belief.scan == nullptr) return max_speed_m_s;
  if (!in_view(*belief.scan, towards)) return std::min(max_speed_m_s, kBlindSpeed_m_s);
  // The disc swept has the clearance already, so the whole free way may be used for stopping; one
  // blind step of kBlindSpeed_m_s is always allowed, or a vehicle beside a wall never leaves it.
  const double way_m = free_way_m(belief, towards, braking.clearance_m);
  const double safe_m_s =
      kMargin * safe_speed_m_s(way_m, 0, reaction_time_s, braking.velocity_gain_1_s,
                               braking.deceleration_m_s2);
  return std::clamp(safe_m_s, std::min(max_speed_m_s, kBlindSpeed_m_s), max_speed_m_s);
}

}  // namespace voronaut
