#include "voronaut/environments/shapes/robot_body.h"

#include <stdexcept>

#include "voronaut/environments/shapes/shapes.h"

namespace voronaut {

std::string body_problem(std::vector<Vec2>& corners_body) {
  constexpr std::size_t kPolygon = std::string_view("polygon 0 ").size();
  try {
    corners_body = validated({{}, {}, {{corners_body}}}).polygons.front().vertices;
  } catch (const std::invalid_argument& error) {
    return std::string(error.what()).substr(kPolygon);
  }
  const std::size_t n = corners_body.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2& a = corners_body[i];
    const Vec2& b = corners_body[(i + 1) % n];
    if (cross(b - a, corners_body[(i + 2) % n] - b) <= 0)
      return "is not strictly convex at its corner " + std::to_string((i + 1) % n);
    if (cross(b - a, -a) <= 0) return "does not hold the origin, about which the body turns";
  }
  return "";
}

}  // namespace voronaut
