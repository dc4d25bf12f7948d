#include "voronaut/planners/navigation/stop_tube.h"

#include <algorithm>
#include <cmath>

#include "voronaut/planners/navigation/departure.h"

namespace voronaut {

namespace {

template <class IsWell>
bool all_segments(const std::vector<Vec2>& corners, const IsWell& is_well) {
  for (std::size_t i = 0; i + 1 < corners.size(); ++i)
    if (!is_well(corners[i], corners[i + 1])) return false;
  return true;
}

}  // namespace

bool StopTube::keeps_clear(const PredictedStop& stop, const std::vector<Vec2>& corners,
                           const ObstacleSnapshot& known, double keep_m) {
  return keeps_to_bounds(stop, corners) && keeps_from(corners, known, keep_m);
}

bool StopTube::keeps_from(const std::vector<Vec2>& corners, const ObstacleSnapshot& known,
                          double keep_m) {
  return all_segments(corners, [&](const Vec2& a, const Vec2& b) {
    return known.swept_disc_is_clear(a, b, keep_m);
  });
}

bool StopTube::is_safe(const PredictedStop& stop, const std::vector<Vec2>& corners,
                       const FreeSpace& free, const ObstacleSnapshot& known, double keep_m) {
  if (!keeps_to_bounds(stop, corners)) return false;
  const double tube_m = radius_m(stop);
  // What is not known refuses more often than what is.
  const bool is_free = all_segments(
      corners, [&](const Vec2& a, const Vec2& b) { return free.swept_disc_is_free(a, b, tube_m); });
  if (!is_free && stop.fastest_m_s > kDepartureSpeed_m_s) return false;
  return keeps_from(corners, known, keep_m) && (is_free || departs(stop, corners, free));
}

bool StopTube::departs(const PredictedStop& stop, const std::vector<Vec2>& corners,
                       const FreeSpace& free) {
  free.unknown_cells_in_tube(corners, radius_m(stop), unknown_cells_);
  return leads_away(stop.v_command_world, corners, unknown_cells_);
}

bool StopTube::keeps_to_bounds(const PredictedStop& stop, const std::vector<Vec2>& corners) {
  const Bounds& bounds = centre_bounds_world_;
  const double room_m = radius_m(stop) - body_radius_m_;
  const Vec2& now = corners.front();
  outside_.clear();
  for (const int axis : {0, 1}) {
    const auto [lowest, highest] =
        std::ranges::minmax(corners, {}, [axis](const Vec2& corner) { return corner[axis]; });
    if (lowest[axis] < bounds.min[axis] + room_m) outside_.emplace_back(now - Vec2::Unit(axis));
    if (highest[axis] > bounds.max[axis] - room_m) outside_.emplace_back(now + Vec2::Unit(axis));
  }
  if (outside_.empty()) return true;
  return stop.fastest_m_s <= kDepartureSpeed_m_s &&
         leads_away(stop.v_command_world, corners, outside_);
}

// Sleeve fitting: a segment goes on as long as its end is seen from its start between both sides of
// every sample passed, each kStraight_m beside it, and lies farther than all of them.
void StopTube::straighten(const std::vector<Vec2>& track, std::vector<Vec2>& corners) {
  corners.assign(1, track.front());
  Vec2 right(0, 0), left(0, 0);  // the sleeve, as seen from the start of the segment; zero: open
  double farthest_sq = 0;
  for (std::size_t i = 1; i < track.size(); ++i) {
    const Vec2 to = track[i] - corners.back();
    const double reach_sq = to.squaredNorm();
    const bool in_sleeve = reach_sq >= farthest_sq && cross(right, to) >= 0 && cross(to, left) >= 0;
    if (!in_sleeve) {
      corners.push_back(track[i - 1]);
      right = left = Vec2(0, 0);
      farthest_sq = 0;
      --i;
      continue;
    }
    if (reach_sq <= kStraight_m * kStraight_m) continue;
    farthest_sq = reach_sq;
    const Vec2 side = left_of(to) * (kStraight_m / std::sqrt(reach_sq));
    if (right == Vec2(0, 0) || cross(right, to - side) > 0) right = to - side;
    if (left == Vec2(0, 0) || cross(to + side, left) > 0) left = to + side;
  }
  corners.push_back(track.back());
}

}  // namespace voronaut
