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

Vec2 nearest_of(std::span<const Vec2> convex, const Vec2& p) {
  Vec2 nearest = convex.front();
  for (std::size_t i = 0; i < convex.size(); ++i) {
    const Vec2 q = closest_point(p, Segment{convex[i], convex[(i + 1) % convex.size()]});
    if ((q - p).squaredNorm() < (nearest - p).squaredNorm()) nearest = q;
  }
  return nearest;
}

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
  rim_moved_m_.clear();
  for (const Vec2& heading : headings)
    rim_moved_m_.push_back(radius_m_ * (heading - headings.front()).norm());
  face(track.front(), headings.front(), touched_);
  return leads_away(stop.v_command_world, track, touched_, rim_moved_m_);
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

void FootprintSweep::places_faced(const Vec2& p_world, const Vec2& heading, double grown_m,
                                  const FreeSpace& free, std::vector<Vec2>& places) {
  place_corners(corners_body_, p_world, heading, placed_);
  free.unknown_cells_in_convex(placed_, grown_m, places);
  face(p_world, heading, places);
}

// From cells to places as leads_away() asks for them: away from such a place is away from the cell,
// whatever part of the body it is nearest to. A cell under the body becomes the centre itself, from
// which nothing leads away.
void FootprintSweep::face(const Vec2& p_world, const Vec2& heading, std::vector<Vec2>& places) {
  place_corners(corners_body_, p_world, heading, placed_);
  for (Vec2& place : places) {
    const bool under = distance(std::span<const Vec2>(placed_), place) == 0;
    const Vec2 from_cell = nearest_of(placed_, place) - place;
    place = under ? p_world : Vec2(p_world - from_cell.normalized());
  }
}

}  // namespace voronaut
