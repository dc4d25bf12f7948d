#include <cmath>

#include "voronaut/environments/shapes/convex_distance.h"
#include "voronaut/planners/mapping/free_space/free_space.h"

// What is not known free around a tube: asked only once a course has been refused.
namespace voronaut {

std::optional<Vec2> FreeSpace::first_unknown_in_tube(std::span<const Vec2> corners,
                                                     double radius_m) const {
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
    const Vec2 way = corners[i + 1] - corners[i];
    const int steps = static_cast<int>(way.norm() / cell_m_) + 1;
    for (int step = 0; step <= steps; ++step) {
      const Vec2 p = corners[i] + (static_cast<double>(step) / steps) * way;
      if (swept_disc_is_free(p, p, radius_m)) continue;
      return unknown_in_disc(p, radius_m);
    }
  }
  return std::nullopt;
}

std::optional<Vec2> FreeSpace::unknown_in_disc(const Vec2& p_world, double radius_m) const {
  const int reach = static_cast<int>(radius_m / cell_m_) + 1;
  const Vec2 center = to_cells(p_world);
  std::optional<Vec2> nearest_to_rim;
  double farthest_sq = -1;
  for (int dy = -reach; dy <= reach; ++dy) {
    for (int dx = -reach; dx <= reach; ++dx) {
      const Vec2 cell(std::floor(center.x()) + dx + 0.5, std::floor(center.y()) + dy + 0.5);
      const Vec2 middle = origin_ + cell_m_ * cell;
      const double distance_sq = (middle - p_world).squaredNorm();
      const double within_m = radius_m + cell_m_;
      if (distance_sq > within_m * within_m || distance_sq <= farthest_sq) continue;
      if (is_free(middle)) continue;
      farthest_sq = distance_sq;
      nearest_to_rim = middle;
    }
  }
  return nearest_to_rim;
}

void FreeSpace::unknown_cells_in_tube(std::span<const Vec2> corners, double radius_m,
                                      std::vector<Vec2>& middles) const {
  middles.clear();
  const double reach_m = radius_m + cell_radius_m();
  Vec2 low = corners.front(), high = corners.front();
  for (const Vec2& corner : corners) {
    low = low.cwiseMin(corner);
    high = high.cwiseMax(corner);
  }
  const Vec2 first = to_cells(low - Vec2(reach_m, reach_m)).array().floor();
  const Vec2 last = to_cells(high + Vec2(reach_m, reach_m)).array().floor();
  for (double row = first.y(); row <= last.y(); ++row) {
    for (double column = first.x(); column <= last.x(); ++column) {
      const Vec2 middle = origin_ + cell_m_ * Vec2(column + 0.5, row + 0.5);
      if (is_free(middle)) continue;
      bool near = false;
      for (std::size_t i = 0; i + 1 < corners.size() && !near; ++i)
        near = distance(middle, Segment{corners[i], corners[i + 1]}) <= reach_m;
      if (near) middles.push_back(middle);
    }
  }
}

void FreeSpace::unknown_cells_in_convex(std::span<const Vec2> corners_world, double grown_m,
                                        std::vector<Vec2>& middles) const {
  middles.clear();
  const double reach_m = grown_m + cell_radius_m();
  Vec2 low = corners_world.front(), high = low;
  for (const Vec2& corner : corners_world) {
    low = low.cwiseMin(corner);
    high = high.cwiseMax(corner);
  }
  const Vec2 first = to_cells(low - Vec2(reach_m, reach_m)).array().floor();
  const Vec2 last = to_cells(high + Vec2(reach_m, reach_m)).array().floor();
  for (double row = first.y(); row <= last.y(); ++row) {
    for (double column = first.x(); column <= last.x(); ++column) {
      const Vec2 middle = origin_ + cell_m_ * Vec2(column + 0.5, row + 0.5);
      if (!is_free(middle) && distance(corners_world, middle) <= reach_m) middles.push_back(middle);
    }
  }
}

}  // namespace voronaut
