#include "voronaut/planners/navigation/way_flown.h"

#include <gtest/gtest.h>

namespace voronaut {
namespace {

// Along x for 2 m, then along y for 1 m.
WayFlown around_a_corner() {
  WayFlown way;
  for (int i = 0; i <= 200; ++i) way.go_on(Vec2(0.01 * i, 0));
  for (int i = 1; i <= 100; ++i) way.go_on(Vec2(2, 0.01 * i));
  return way;
}

TEST(WayFlown, LeadsBackWhereTheVehicleCameFromOneLegAtATime) {
  const WayFlown way = around_a_corner();
  const Path leg = way.back_from(Vec2(2, 1), 0.5);
  EXPECT_NEAR(leg.length_m(), 0.5, WayFlown::kSpacing_m);
  EXPECT_NEAR(leg.back().x(), 2, 1e-9);
  EXPECT_NEAR(leg.back().y(), 0.5, WayFlown::kSpacing_m);

  const Path whole = way.back_from(Vec2(2, 1), 100);
  EXPECT_NEAR(whole.length_m(), 3, 0.1);
  EXPECT_EQ(whole.back(), Vec2(0, 0));
}

TEST(WayFlown, ForgetsWhatWasFlownBackEvenWhereACornerWasCut) {
  WayFlown way = around_a_corner();
  for (int i = 100; i >= 50; --i) way.go_back(Vec2(2, 0.01 * i));
  for (int i = 0; i <= 50; ++i) way.go_back(Vec2(2 - 0.01 * i, 0.5 - 0.01 * i));
  const Path rest = way.back_from(Vec2(1.5, 0), 100);
  EXPECT_NEAR(rest.length_m(), 1.5, 0.1);
}

TEST(WayFlown, HasNothingToOfferWhereItBegan) {
  WayFlown way;
  EXPECT_TRUE(way.back_from(Vec2(0, 0), 1).empty());
  way.go_on(Vec2(0, 0));
  way.go_back(Vec2(0.05, 0));
  EXPECT_TRUE(way.back_from(Vec2(0.05, 0), 1).empty());
}

}  // namespace
}  // namespace voronaut
