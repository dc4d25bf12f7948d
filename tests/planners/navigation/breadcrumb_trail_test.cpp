#include "voronaut/planners/navigation/breadcrumb_trail.h"

#include <gtest/gtest.h>

namespace voronaut {
namespace {

// Along x for 2 m, then along y for 1 m.
BreadcrumbTrail around_a_corner() {
  BreadcrumbTrail trail;
  for (int i = 0; i <= 200; ++i) trail.extend(Vec2(0.01 * i, 0));
  for (int i = 1; i <= 100; ++i) trail.extend(Vec2(2, 0.01 * i));
  return trail;
}

TEST(BreadcrumbTrail, LeadsBackWhereTheVehicleCameFromOneLegAtATime) {
  const BreadcrumbTrail trail = around_a_corner();
  const Path leg = trail.path_back(Vec2(2, 1), 0.5);
  EXPECT_NEAR(leg.length_m(), 0.5, BreadcrumbTrail::kSpacing_m);
  EXPECT_NEAR(leg.back().x(), 2, 1e-9);
  EXPECT_NEAR(leg.back().y(), 0.5, BreadcrumbTrail::kSpacing_m);

  const Path whole = trail.path_back(Vec2(2, 1), 100);
  EXPECT_NEAR(whole.length_m(), 3, 0.1);
  EXPECT_EQ(whole.back(), Vec2(0, 0));
}

TEST(BreadcrumbTrail, ForgetsWhatWasFlownBackEvenWhereACornerWasCut) {
  BreadcrumbTrail trail = around_a_corner();
  for (int i = 100; i >= 50; --i) trail.backtrack(Vec2(2, 0.01 * i));
  for (int i = 0; i <= 50; ++i) trail.backtrack(Vec2(2 - 0.01 * i, 0.5 - 0.01 * i));
  const Path rest = trail.path_back(Vec2(1.5, 0), 100);
  EXPECT_NEAR(rest.length_m(), 1.5, 0.1);
}

TEST(BreadcrumbTrail, HasNothingToOfferWhereItBegan) {
  BreadcrumbTrail trail;
  EXPECT_TRUE(trail.path_back(Vec2(0, 0), 1).empty());
  trail.extend(Vec2(0, 0));
  trail.backtrack(Vec2(0.05, 0));
  EXPECT_TRUE(trail.path_back(Vec2(0.05, 0), 1).empty());
}

}  // namespace
}  // namespace voronaut
