#include "voronaut/planners/mapping/index/clearance_field.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "voronaut/environments/random.h"

namespace voronaut {
namespace {

double distance_m(const std::vector<Vec2>& points, const Vec2& p) {
  double smallest_m = 1e9;
  for (const Vec2& known : points) smallest_m = std::min(smallest_m, (known - p).norm());
  return smallest_m;
}

// Points in heaps over an area wide enough that tiles share places, and far from the origin.
TEST(ClearanceField, NeverClaimsMoreThanThePointsAllow) {
  constexpr int kHeaps = 60;
  constexpr int kPerHeap = 10;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    Random random(seed);
    const Vec2 middle{seed % 2 == 0 ? 1e6 : 0, seed % 4 < 2 ? -1e6 : 3};
    ClearanceField field(seed == 1 ? 0 : random.uniform(0.05, ClearanceField::kLargestRadiusM));
    std::vector<Vec2> points;
    int told = 0;
    int asked = 0;
    for (int heap = 0; heap < kHeaps; ++heap) {
      const Vec2 at = middle + Vec2(random.uniform(-60, 60), random.uniform(-60, 60));
      for (int i = 0; i < kPerHeap; ++i) {
        points.push_back(at + Vec2(random.normal(), random.normal()));
        field.add(points.back());
      }
      for (int query = 0; query < 200; ++query) {
        const Vec2 p = at + 2 * Vec2(random.normal(), random.normal());
        const double nearest_m = distance_m(points, p);
        ASSERT_LE(field.bound_m(p), nearest_m) << "seed " << seed;
        ASSERT_GE(field.bound_m(p), std::min(ClearanceField::kReachM * (1 - 1e-5),
                                             heap < 5 ? nearest_m - 0.54 : 0.0));
        const auto disc = field.disc_at(p);
        if (disc == ClearanceField::Disc::clear) {
          ASSERT_GE(nearest_m, field.radius_m());
        } else if (disc == ClearanceField::Disc::touching) {
          ASSERT_LT(nearest_m, field.radius_m());
        }
        ++asked;
        told += disc != ClearanceField::Disc::undecided;
      }
    }
    EXPECT_EQ(field.points(), points.size());
    EXPECT_GT(told, asked / 2) << "seed " << seed;
  }
}

// Just within the radius of one point, in every direction and wherever the cells lie.
TEST(ClearanceField, CallsNoDiscClearThatAPointReachesByAHairsBreadth) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    Random random(seed);
    ClearanceField field(random.uniform(0.2, ClearanceField::kLargestRadiusM));
    const Vec2 known(random.uniform(-5, 5), random.uniform(-5, 5));
    field.add(known);
    for (int i = 0; i < 200; ++i) {
      const Vec2 away = Vec2(random.normal(), random.normal()).normalized();
      ASSERT_NE(field.disc_at(known + (field.radius_m() - 1e-6) * away),
                ClearanceField::Disc::clear)
          << "seed " << seed;
    }
  }
}

TEST(ClearanceField, KnowsNothingNearWherePointsAreFar) {
  ClearanceField field(0.4);
  EXPECT_EQ(field.disc_at({3, 4}), ClearanceField::Disc::clear);
  EXPECT_NEAR(field.bound_m({3, 4}), ClearanceField::kReachM, 1e-5);
  field.add({3, 4});
  EXPECT_EQ(field.disc_at({3.1, 4}), ClearanceField::Disc::touching);
  EXPECT_EQ(field.disc_at({3.7, 4}), ClearanceField::Disc::clear);
  EXPECT_NEAR(field.bound_m({3, 6.5}), ClearanceField::kReachM, 1e-5);
}

}  // namespace
}  // namespace voronaut
