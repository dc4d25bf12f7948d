#include "voronaut/planners/navigation/replan_policy.h"

namespace voronaut {

namespace {

// A request that found nothing is repeated after this long on an unchanged map: a sampling planner
// may have better luck.
constexpr double kRetryAfter_s = 0.5;

}  // namespace

std::string_view to_string(ReplanReason reason) {
  switch (reason) {
    case ReplanReason::none:
      return "none";
    case ReplanReason::every_scan:
      return "every_scan";
    case ReplanReason::no_plan:
      return "no_plan";
    case ReplanReason::invalidated:
      return "invalidated";
    case ReplanReason::off_path:
      return "off_path";
  }
  return "none";
}

ReplanReason ReplanPolicy::reason(const PathTracker& tracker, const KnownGeometry& geometry,
                                  const Eigen::Vector2d& p_world, double now_s) {
  if (traits_.plans_on_every_scan) return ReplanReason::every_scan;

  const std::uint64_t version = geometry.known_obstacles().version();
  const bool map_changed = version != checked_version_;
  checked_version_ = version;

  if (!tracker.has_path()) {
    if (!map_changed && now_s - asked_s_ < kRetryAfter_s) return ReplanReason::none;
    asked_s_ = now_s;
    return ReplanReason::no_plan;
  }
  if (tracker.distance_off_path_m() > config_.off_path_m) return ReplanReason::off_path;
  if (map_changed && !rest_is_clear(tracker, geometry, p_world)) return ReplanReason::invalidated;
  return ReplanReason::none;
}

bool rest_is_clear(const PathTracker& tracker, const KnownGeometry& geometry,
                   const Eigen::Vector2d& p_world) {
  const Path& path = tracker.path();
  Eigen::Vector2d from = path.point_at(tracker.station_m());
  if (!geometry.motion_is_clear(p_world, from)) return false;
  double end_m = 0;
  for (const PathSegment& segment : path.segments()) {
    end_m += segment.length_m;
    if (end_m <= tracker.station_m()) continue;
    if (!geometry.motion_is_clear(from, segment.end)) return false;
    from = segment.end;
  }
  return true;
}

}  // namespace voronaut
