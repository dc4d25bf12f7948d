#include <algorithm>
#include <array>
#include <cmath>

#include "voronaut/environments/shapes/convex_distance.h"
#include "voronaut/planners/mapping/free_space/free_space.h"

// What is not known free around a tube: asked only once a course has been refused.
namespace voronaut {

// What is swept up to a place is free up to the first that is looked for: by bisection.
std::optional<Vec2> FreeSpace::first_unknown_in_tube(std::span<const Vec2> corners,
                                                     double radius_m) const {
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
    const Vec2& from = corners[i];
    const Vec2 way = corners[i + 1] - from;
    const int steps = static_cast<int>(way.norm() / part_m()) + 1;
    const auto place = [&](int step) -> Vec2 {
      return from + (static_cast<double>(step) / steps) * way;
    };
    if (swept_disc_is_free(from, corners[i + 1], radius_m)) continue;
    int free = -1, unknown = steps;
    while (unknown - free > 1) {
      const int middle = (free + unknown) / 2;
      (swept_disc_is_free(from, place(middle), radius_m) ? free : unknown) = middle;
    }
    return unknown_in_disc(place(unknown), radius_m);
  }
  return std::nullopt;
}

std::optional<Vec2> FreeSpace::unknown_in_disc(const Vec2& p_world, double radius_m) const {
  std::vector<Vec2> middles;
  unknown_cells_in_tube(std::array{p_world, p_world}, radius_m, middles);
  const auto nearest_to_rim = std::ranges::max_element(
      middles, {}, [&](const Vec2& middle) { return (middle - p_world).squaredNorm(); });
  return nearest_to_rim == middles.end() ? std::nullopt : std::optional(*nearest_to_rim);
}

void FreeSpace::unknown_cells_in_tube(std::span<const Vec2> corners, double radius_m,
                                      std::vector<Vec2>& middles) const {
  const double reach_m = radius_m + part_radius_m();
  unknown_parts(corners, reach_m, middles, [&](const Vec2& middle) {
    for (std::size_t i = 0; i + 1 < corners.size(); ++i)
      if (distance(middle, Segment{corners[i], corners[i + 1]}) <= reach_m) return true;
    return false;
  });
}

void FreeSpace::unknown_cells_in_convex(std::span<const Vec2> corners_world, double grown_m,
                                        std::vector<Vec2>& middles) const {
  const double reach_m = grown_m + part_radius_m();
  unknown_parts(corners_world, reach_m, middles,
                [&](const Vec2& middle) { return distance(corners_world, middle) <= reach_m; });
}

template <class IsNear>
void FreeSpace::unknown_parts(std::span<const Vec2> corners, double reach_m,
                              std::vector<Vec2>& middles, const IsNear& is_near) const {
  middles.clear();
  const Bounds box = grown(bounds_of(corners), reach_m);
  const Vec2 first = in(cells_, box.min).array().floor();
  const Vec2 last = in(cells_, box.max).array().floor();
  for (double row = first.y(); row <= last.y(); ++row) {
    for (double column = first.x(); column <= last.x(); ++column) {
      if (cells_.is_free(Vec2(column + 0.5, row + 0.5))) continue;
      const Vec2 corner = origin_ + cell_m() * Vec2(column, row);
      for (int y = 0; y < splits_; ++y) {
        for (int x = 0; x < splits_; ++x) {
          const Vec2 middle = corner + part_m() * Vec2(x + 0.5, y + 0.5);
          if (!(has_parts() && parts_.is_free(in(parts_, middle))) && is_near(middle))
            middles.push_back(middle);
        }
      }
    }
  }
}

}  // namespace voronaut
