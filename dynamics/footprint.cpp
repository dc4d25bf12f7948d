#include "voronaut/dynamics/footprint.h"

#include <algorithm>
#include <limits>

namespace voronaut {

double circumscribed_radius_m(std::span<const Eigen::Vector2d> corners_body) {
  double farthest_m = 0;
  for (const Eigen::Vector2d& corner : corners_body)
    farthest_m = std::max(farthest_m, corner.norm());
  return farthest_m;
}

double inscribed_radius_m(std::span<const Eigen::Vector2d> corners_body) {
  double nearest_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < corners_body.size(); ++i) {
    const Eigen::Vector2d& a = corners_body[i];
    const Eigen::Vector2d along = corners_body[(i + 1) % corners_body.size()] - a;
    nearest_m = std::min(nearest_m, (a.x() * along.y() - a.y() * along.x()) / along.norm());
  }
  return nearest_m;
}

void place_corners(std::span<const Eigen::Vector2d> corners_body, const Eigen::Vector2d& p_world,
                   const Eigen::Vector2d& heading_world,
                   std::vector<Eigen::Vector2d>& corners_world) {
  corners_world.clear();
  const Eigen::Vector2d left(-heading_world.y(), heading_world.x());
  for (const Eigen::Vector2d& corner : corners_body)
    corners_world.push_back(p_world + corner.x() * heading_world + corner.y() * left);
}

}  // namespace voronaut
