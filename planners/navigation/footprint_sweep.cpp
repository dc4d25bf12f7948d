#include "voronaut/planners/navigation/footprint_sweep.h"

#include <algorithm>

#include "voronaut/environments/shapes/convex_distance.h"
#include "voronaut/planners/mapping/points/convex_polygon.h"
#include "voronaut/planners/navigation/departure.h"

namespace voronaut {

namespace {

// Between samples a corner leaves its chord by up to (a + alpha r + w^2 r + v w) dt^2 / 8: 2 mm at
// 0.02 s for all that the fastest of the wheeled vehicles can do at once.
constexpr double kChord_m = 0.004;
// Of a predicted heading, times the body's radius.
constexpr double kHeadingError_rad = 0.01;
// Turned by less than this, samples are taken for a straight way.
constexpr double kSameHeading = 1e-6;
// Ten seconds of scans at 20 Hz would take it closer by 2 mm.
constexpr double kNoCloser_m = 1e-5;
// So far ahead a way out is looked at.
constexpr double kWayOut_m = 0.03;

}  // namespace

FootprintSweep::FootprintSweep(const Footprint& footprint)
    : corners_body_(footprint.corners_body),
      radius_m_(circumscribed_radius_m(footprint.corners_body)),
      slack_m_(kChord_m + kHeadingError_rad * radius_m_) {}

template <class Visit>
bool FootprintSweep::each_hull(const std::vector<Vec2>& track, const std::vector<Vec2>& headings,
                               Visit&& visit) {
  for (std::size_t i = 0; i + 1 < track.size();) {
    std::size_t next = i + 1;
    while (next + 1 < track.size() && (headings[next] - headings[i]).norm() < kSameHeading &&
           (headings[next + 1] - headings[i]).norm() < kSameHeading)
      ++next;
    place_corners(corners_body_, track[i], headings[i], hull_);
    place_corners(corners_body_, track[next], headings[next], placed_);
    hull_.insert(hull_.end(), placed_.begin(), placed_.end());
    reduce_to_convex_hull(hull_);
    if (!visit(std::span<const Vec2>(hull_))) return false;
    i = next;
  }
  return true;
}

bool FootprintSweep::is_safe(const PredictedStop& stop, const std::vector<Vec2>& track,
                             const std::vector<Vec2>& headings, const FreeSpace& free) {
  const double grown_m = stop.stray_m + slack_m_;
  const bool is_free = each_hull(track, headings, [&](std::span<const Vec2> hull) {
    return free.convex_is_free(hull, grown_m);
  });
  return is_free || departs(stop, track, headings, free);
}

bool FootprintSweep::departs(const PredictedStop& stop, const std::vector<Vec2>& track,
                             const std::vector<Vec2>& headings, const FreeSpace& free) {
  if (stop.fastest_m_s > kDepartureSpeed_m_s) return false;
  const double grown_m = stop.stray_m + slack_m_;
  touched_.clear();
  each_hull(track, headings, [&](std::span<const Vec2> hull) {
    free.unknown_cells_in_convex(hull, grown_m, cells_);
    touched_.insert(touched_.end(), cells_.begin(), cells_.end());
    return true;
  });
  note_corners(track.front(), headings.front(), free);
  for (std::size_t i = 1; i < track.size(); ++i)
    if (!comes_no_closer(track[i], headings[i])) return false;
  return true;
}

void FootprintSweep::note_corners(const Vec2& p_world, const Vec2& heading, const FreeSpace& free) {
  const auto before = [](const Vec2& a, const Vec2& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  };
  std::ranges::sort(touched_, before);
  touched_.erase(std::unique(touched_.begin(), touched_.end()), touched_.end());
  place_corners(corners_body_, p_world, heading, placed_);
  const double half_m = 0.5 * free.cell_m();
  cell_corners_.clear();
  for (const Vec2& middle : touched_) {
    for (const Vec2& corner : {Vec2(half_m, half_m), Vec2(-half_m, half_m), Vec2(-half_m, -half_m),
                               Vec2(half_m, -half_m)}) {
      const Vec2 p = middle + corner;
      const double distance_m = distance(std::span<const Vec2>(placed_), p);
      if (distance_m > 0) cell_corners_.push_back({p, distance_m});
    }
  }
}

bool FootprintSweep::comes_no_closer(const Vec2& p_world, const Vec2& heading) {
  place_corners(corners_body_, p_world, heading, placed_);
  return std::ranges::all_of(cell_corners_, [&](const Corner& corner) {
    return distance(std::span<const Vec2>(placed_), corner.p_world) >=
           corner.distance_m - kNoCloser_m;
  });
}

std::optional<Vec2> FootprintSweep::first_unknown(const PredictedStop& stop,
                                                  const std::vector<Vec2>& track,
                                                  const std::vector<Vec2>& headings,
                                                  const FreeSpace& free) {
  std::optional<Vec2> first;
  each_hull(track, headings, [&](std::span<const Vec2> hull) {
    if (free.convex_is_free(hull, stop.stray_m + slack_m_)) return true;
    free.unknown_cells_in_convex(hull, stop.stray_m + slack_m_, cells_);
    if (!cells_.empty()) first = cells_.front();
    return cells_.empty();
  });
  return first;
}

std::optional<Vec2> FootprintSweep::way_out(const Vec2& towards, const Vec2& p_world,
                                            const Vec2& heading, double near_m,
                                            const FreeSpace& free) {
  place_corners(corners_body_, p_world, heading, placed_);
  free.unknown_cells_in_convex(placed_, slack_m_ + near_m, touched_);
  if (touched_.empty()) return std::nullopt;
  note_corners(p_world, heading, free);
  const Vec2 nearer = heading.dot(towards) >= 0 ? heading : Vec2(-heading);
  for (const Vec2& way : {nearer, Vec2(-nearer)})
    if (comes_no_closer(p_world + kWayOut_m * way, heading)) return way;
  return std::nullopt;
}

}  // namespace voronaut
