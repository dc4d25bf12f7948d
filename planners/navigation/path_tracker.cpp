#include "voronaut/planners/navigation/path_tracker.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace voronaut {

namespace {

// The projection looks this far ahead of where it was: more than a vehicle covers between two
// calls, less than what would let it jump over a hairpin.
constexpr double kProjectionWindow_m = 1.0;

}  // namespace

void PathTracker::follow(Path path, PathEnd end) {
  path_ = std::move(path);
  end_ = end;
  station_m_ = 0;
  distance_off_path_m_ = 0;
}

void PathTracker::advance(const Eigen::Vector2d& p_world) {
  if (path_.empty()) return;
  const PathProjection projection =
      path_.project(p_world, station_m_, station_m_ + kProjectionWindow_m);
  station_m_ = projection.station_m;
  distance_off_path_m_ = projection.distance_m;
}

LookaheadPoint PathTracker::lookahead(const Eigen::Vector2d& p_world, double speed_m_s,
                                      const ObstacleSnapshot& known, double clearance_m) const {
  LookaheadPoint point;
  if (path_.empty()) {
    point.p_world = p_world;
    return point;
  }
  double lookahead_m = config_.lookahead_base_m + config_.lookahead_per_speed_s * speed_m_s;
  // Cutting a corner is fine as long as the cut is clear; a quarter of the base always remains.
  while (
      lookahead_m > 0.25 * config_.lookahead_base_m &&
      !known.swept_disc_is_clear(p_world, path_.point_at(station_m_ + lookahead_m), clearance_m)) {
    lookahead_m *= 0.7;
  }
  const double target_m = station_m_ + lookahead_m;
  point.p_world = path_.point_at(target_m);
  if (target_m < path_.length_m())
    point.segment = path_.segment_at(target_m);
  else
    point.end = end_;
  point.speed_limit_m_s =
      corner_speed_limit_m_s(path_, station_m_, max_speed_m_s_, config_.corner_deceleration_m_s2);
  if (end_ == PathEnd::goal) {
    const double to_go_m = remaining_m() + distance_off_path_m_;
    point.speed_limit_m_s =
        std::min(point.speed_limit_m_s, goal_profile_.speed_m_s(to_go_m, max_speed_m_s_));
  }
  return point;
}

double corner_speed_limit_m_s(const Path& path, double station_m, double max_speed_m_s,
                              double deceleration_m_s2) {
  double limit_m_s = max_speed_m_s;
  double corner_m = 0;
  const auto& segments = path.segments();
  for (std::size_t i = 0; i + 1 < segments.size(); ++i) {
    corner_m += segments[i].length_m;
    const double ahead_m = corner_m - station_m;
    if (ahead_m < 0) continue;
    if (2 * deceleration_m_s2 * ahead_m > max_speed_m_s * max_speed_m_s) break;
    const Eigen::Vector2d in = (segments[i].end - segments[i].start).normalized();
    const Eigen::Vector2d out = (segments[i + 1].end - segments[i + 1].start).normalized();
    const double at_corner_m_s = max_speed_m_s * std::max(0.1, 0.5 * (1 + in.dot(out)));
    limit_m_s = std::min(
        limit_m_s, std::sqrt(at_corner_m_s * at_corner_m_s + 2 * deceleration_m_s2 * ahead_m));
  }
  return limit_m_s;
}

}  // namespace voronaut
