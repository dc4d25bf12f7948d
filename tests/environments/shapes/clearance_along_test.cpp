#include "voronaut/environments/shapes/clearance_along.h"

#include <gtest/gtest.h>

#include "voronaut/tests/environments/shapes/random_shapes.h"

namespace voronaut {
namespace {

TEST(ClearanceAlong, IsWhatTheIndexSaysOfEachPlaceOfAWay) {
  int inside = 0, outside = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Random rng(seed);
    const ShapeIndex index(random_shapes(rng, 1 + static_cast<int>(rng.below(12)), 10, 1));
    ClearanceAlong along(index);
    Vec2 p = random_point(rng, 10);
    Vec2 step(0, 0);
    for (int i = 0; i < 2000; ++i) {
      if (i % 50 == 0) step = rng.uniform(0, 0.1) * random_direction(rng);
      if (i % 700 == 699) p = random_point(rng, 15);
      p += step;
      const double clearance_m = index.clearance_m(p);
      ASSERT_EQ(along.at(p), clearance_m) << "seed " << seed << " at " << p.transpose();
      (clearance_m < 0 ? inside : outside) += 1;
    }
  }
  EXPECT_GT(inside, 1'000);
  EXPECT_GT(outside, 50'000);
}

TEST(ClearanceAlong, HasNoEndWhereThereAreNoShapes) {
  const ShapeIndex none(Shapes{});
  ClearanceAlong along(none);
  EXPECT_EQ(along.at(Vec2(1, 2)), kInfinity);
  EXPECT_EQ(along.at(Vec2(1, 2.01)), kInfinity);
}

}  // namespace
}  // namespace voronaut
