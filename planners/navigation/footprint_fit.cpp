#include "voronaut/planners/navigation/footprint_fit.h"

#include <algorithm>
#include <cmath>

#include "voronaut/environments/shapes/convex_distance.h"
#include "voronaut/planners/mapping/points/convex_polygon.h"

namespace voronaut {

namespace {

// Of a turn: between two headings so far apart a corner at 0.4 m leaves its chord by 2 mm.
constexpr double kTurnStep_rad = 0.2;

class FitAlong {
 public:
  FitAlong(const Footprint& footprint, const ObstacleSnapshot& known)
      : corners_body_(footprint.corners_body),
        radius_m_(circumscribed_radius_m(footprint.corners_body)),
        known_(known) {}

  // The known point that it touches first found; none: it fits.
  std::optional<Vec2> touched_along(const Vec2& a, const Vec2& b, const Vec2& heading) {
    if (known_.swept_disc_is_clear(a, b, radius_m_)) return std::nullopt;
    return touched_between(a, heading, b, heading);
  }

  std::optional<Vec2> touched_turning(const Vec2& p, const Vec2& from, const Vec2& to) {
    if (known_.disc_is_clear(p, radius_m_)) return std::nullopt;
    const double turn_rad = 2 * std::asin(std::min(1.0, 0.5 * (to - from).norm()));
    const int steps = 1 + static_cast<int>(turn_rad / kTurnStep_rad);
    Vec2 before = from;
    for (int i = 1; i <= steps; ++i) {
      // Chords of the turn; right about turns are as good to either side.
      const double share = static_cast<double>(i) / steps;
      Vec2 heading = (1 - share) * from + share * to;
      heading = heading.norm() > 1e-6 ? Vec2(heading.normalized()) : left_of(from);
      if (const auto touched = touched_between(p, before, p, heading)) return touched;
      before = heading;
    }
    return std::nullopt;
  }

 private:
  std::optional<Vec2> touched_between(const Vec2& a, const Vec2& heading_a, const Vec2& b,
                                      const Vec2& heading_b) {
    place_corners(corners_body_, a, heading_a, hull_);
    place_corners(corners_body_, b, heading_b, placed_);
    hull_.insert(hull_.end(), placed_.begin(), placed_.end());
    reduce_to_convex_hull(hull_);
    const Bounds box = bounding_box(hull_);
    const auto touched = std::ranges::find_if(known_.points(), [&](const Vec2& p) {
      return box.contains(p) && distance(std::span<const Vec2>(hull_), p) == 0;
    });
    return touched == known_.points().end() ? std::nullopt : std::optional<Vec2>(*touched);
  }

  const std::vector<Vec2>& corners_body_;
  double radius_m_;
  const ObstacleSnapshot& known_;
  std::vector<Vec2> hull_, placed_;
};

}  // namespace

std::optional<Vec2> first_misfit(const Footprint& footprint, const Path& path,
                                 const ObstacleSnapshot& known) {
  FitAlong body(footprint, known);
  std::optional<Vec2> before;
  for (const PathSegment& segment : path.segments()) {
    const Vec2 way = segment.end - segment.start;
    if (way.norm() == 0) continue;
    const Vec2 heading = way.normalized();
    if (before && body.touched_turning(segment.start, *before, heading)) return segment.start;
    if (const auto touched = body.touched_along(segment.start, segment.end, heading))
      return closest_point(*touched, Segment{segment.start, segment.end});
    before = heading;
  }
  return std::nullopt;
}

}  // namespace voronaut
