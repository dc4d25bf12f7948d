#include "voronaut/environments/shortest_path/sight_cone.h"

#include <cmath>

#include <gtest/gtest.h>

#include "voronaut/tests/environments/shapes/random_shapes.h"

namespace voronaut {
namespace {

constexpr double kUnlimited = std::numeric_limits<double>::infinity();

TEST(SightCone, EndsAtAShapeThatShutsIt) {
  const SightCone cone{Vec2(0, 0), Vec2(1, 0), 0.1, 0.05};
  Shapes shapes;
  EXPECT_EQ(sight_range_m(ShapeIndex(shapes), cone, 0.2, 50), kUnlimited);
  shapes.segments = {{Vec2(4, -5), Vec2(4, 5)}};
  EXPECT_DOUBLE_EQ(sight_range_m(ShapeIndex(shapes), cone, 0.2, 50), 4);
  EXPECT_EQ(sight_range_m(ShapeIndex(shapes), cone, 0.2, 3), kUnlimited);
  shapes.circles = {{Vec2(2, 0.1), 0.3}};  // the cone is 0.2 wide on each side there
  EXPECT_DOUBLE_EQ(sight_range_m(ShapeIndex(shapes), cone, 0.2, 50), 2);
  shapes.circles = {{Vec2(2, 0.1), 0.05}};  // a slit remains on its right
  EXPECT_DOUBLE_EQ(sight_range_m(ShapeIndex(shapes), cone, 0.2, 50), 4);
}

TEST(SightCone, NoClearLineOfTheConeGoesBeyondItsRange) {
  int shut = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    Random rng(seed);
    const Shapes shapes = random_shapes(rng, 8, 6, 1);
    const ShapeIndex index(shapes);
    const SightCone cone{random_point(rng, 5), random_direction(rng), rng.uniform(0, 0.2),
                         rng.uniform(0, 0.1)};
    const double radius_m = rng.uniform(0.05, 0.5);
    const double range_m = sight_range_m(index, cone, radius_m, 20);
    if (range_m == kUnlimited) continue;
    ++shut;
    for (int i = 0; i < 100; ++i) {
      const double offset_m = rng.uniform(-1, 1) * cone.half_width_m;
      const double slope = rng.uniform(-1, 1) * cone.half_slope;
      const auto on_line = [&](double ahead_m) -> Vec2 {
        return cone.apex + ahead_m * cone.axis + (offset_m + slope * ahead_m) * left_of(cone.axis);
      };
      EXPECT_FALSE(
          index.segment_is_clear(on_line(cone.half_width_m), on_line(range_m + 1e-6), radius_m))
          << "seed " << seed;
    }
  }
  EXPECT_GT(shut, 100);
}

}  // namespace
}  // namespace voronaut
