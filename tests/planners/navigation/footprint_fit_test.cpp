#include "voronaut/planners/navigation/footprint_fit.h"

#include <gtest/gtest.h>

#include "voronaut/environments/shapes/shapes.h"
#include "voronaut/tests/planners/mapping/known_points.h"

namespace voronaut {
namespace {

const Footprint kRectangle{.corners_body = box(Vec2(0, 0), 0.6, 0.4).vertices};

std::optional<Vec2> misfit(const std::vector<Vec2>& waypoints, const std::vector<Vec2>& known) {
  const auto base = test::base_of(known);
  return first_misfit(kRectangle, Path::through(waypoints), base->snapshot());
}

TEST(FootprintFit, IsAsWideAsTheBodyAlongALine) {
  EXPECT_FALSE(misfit({{0, 0}, {3, 0}}, {{1, 0.201}, {2, -0.201}}));
  const auto place = misfit({{0, 0}, {3, 0}}, {{1, 0.199}});
  ASSERT_TRUE(place);
  EXPECT_EQ(*place, Vec2(1, 0));
  EXPECT_TRUE(misfit({{0, 0}, {3, 0}}, {{3.29, 0}})) << "its front reaches beyond the end";
}

// At a right angle its corners come 0.36 m from the middle.
TEST(FootprintFit, NeedsRoomForCornersWhereAPathBends) {
  const std::vector<Vec2> bend{{0, 0}, {1, 0}, {1, 2}};
  EXPECT_FALSE(misfit(bend, {Vec2(1.37, 0)}));
  EXPECT_FALSE(misfit({{0, 0}, {1, 0}}, {Vec2(1.33, 0)})) << "straight on it fits";
  const auto place = misfit(bend, {Vec2(1.33, 0)});
  ASSERT_TRUE(place);
  EXPECT_EQ(*place, Vec2(1, 0));
}

TEST(FootprintFit, FitsWhereNothingIsKnown) { EXPECT_FALSE(misfit({{0, 0}, {1, 0}, {0, 0}}, {})); }

}  // namespace
}  // namespace voronaut
