#pragma once

#include <vector>

#include "voronaut/environments/random.h"
#include "voronaut/environments/shapes/geometry.h"

// Point worlds for the Voronoi planner's tests: surfaces sampled every kSpacing_m.
namespace voronaut::voronoi_test {

inline constexpr double kSpacing_m = 0.08;

struct PointWorld {
  std::vector<Vec2> points;
  Bounds bounds;
  Vec2 start;
  Vec2 goal;
};

void add_circle(std::vector<Vec2>& points, const Vec2& center, double radius_m);
void add_wall(std::vector<Vec2>& points, const Vec2& a, const Vec2& b);

// Circles of radius 0.3 to 0.6 m at `per_m2`, none within 1 m of start or goal; the free area
// reaches 3 m beyond the trees.
PointWorld forest(Random& random, double per_m2, double side_m);
// 3 x 3 rooms of 5 m with doors of 1.3 m at random places, start and goal in opposite corners.
PointWorld rooms(Random& random);
// Loose points, no surfaces: every gap is possible.
PointWorld scattered(Random& random, std::size_t n, double side_m);

// Smallest distance of a path to a point, by brute force.
double clearance_m(const std::vector<Vec2>& path, const std::vector<Vec2>& points);

}  // namespace voronaut::voronoi_test
