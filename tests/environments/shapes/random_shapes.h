#pragma once

#include <numbers>

#include <sleef.h>

#include "voronaut/environments/random.h"
#include "voronaut/environments/shapes/shapes.h"

// Seeded random shapes for property tests.
namespace voronaut {

inline Vec2 random_direction(Random& rng) {
  const auto sin_cos =
      Sleef_cinz_sincosd1_u10purec(rng.uniform(-std::numbers::pi, std::numbers::pi));
  return {sin_cos.y, sin_cos.x};
}

inline Vec2 random_point(Random& rng, double half_m) {
  const double x = rng.uniform(-half_m, half_m);
  return {x, rng.uniform(-half_m, half_m)};
}

// Star-shaped around its centre, so always simple; mostly not convex.
inline Polygon random_polygon(Random& rng, const Vec2& center, double radius_m) {
  const int corners = 3 + static_cast<int>(rng.below(6));
  Polygon polygon;
  for (int i = 0; i < corners; ++i) {
    const double bearing_rad = 2 * std::numbers::pi * (i + rng.uniform(0.1, 0.9)) / corners;
    const auto sin_cos = Sleef_cinz_sincosd1_u10purec(bearing_rad);
    polygon.vertices.push_back(center +
                               radius_m * rng.uniform(0.3, 1) * Vec2(sin_cos.y, sin_cos.x));
  }
  return polygon;
}

// `count` of each kind in a square of 2 half_m; they overlap and touch as they fall.
inline Shapes random_shapes(Random& rng, int count, double half_m, double size_m) {
  Shapes shapes;
  for (int i = 0; i < count; ++i) {
    shapes.circles.push_back({random_point(rng, half_m), rng.uniform(0.1, 1) * size_m});
    const Vec2 a = random_point(rng, half_m);
    shapes.segments.push_back({a, a + 2 * size_m * rng.uniform(0.1, 1) * random_direction(rng)});
    shapes.polygons.push_back(random_polygon(rng, random_point(rng, half_m), size_m));
  }
  return validated(shapes);
}

}  // namespace voronaut
