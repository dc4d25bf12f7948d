#include "voronaut/environments/generators/placement.h"

#include <gtest/gtest.h>

namespace voronaut {
namespace {

bool fits_by_all_pairs(const std::vector<Circle>& circles, double gap_m, const Circle& candidate) {
  for (const Circle& c : circles)
    if ((candidate.center - c.center).norm() < candidate.radius_m + c.radius_m + gap_m)
      return false;
  return true;
}

TEST(CirclePlacer, RefusesWhatIsTooCloseToAnyCircle) {
  int refused = 0;
  int placed = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Random random(seed);
    std::vector<Circle> circles;
    const double gap_m = seed % 3 == 0 ? 0 : random.uniform(0, 1);
    CirclePlacer placer(circles, gap_m);
    const double largest_m = random.uniform(0.1, 2);
    for (int i = 0; i < 200; ++i) {
      const Vec2 p = point_in({{-8, -8}, {8, 8}}, random);
      const Circle candidate{p, random.uniform(0.01, largest_m)};
      const bool fits = fits_by_all_pairs(circles, gap_m, candidate);
      ASSERT_EQ(placer.fits(candidate), fits) << "seed " << seed << ", candidate " << i;
      ++(fits ? placed : refused);
      if (fits && i % 2 == 0) circles.push_back(candidate);  // not through the placer
      if (fits && i % 2 == 1) placer.place([&] { return candidate; });
    }
  }
  EXPECT_GT(refused, 1000);
  EXPECT_GT(placed, 1000);
}

}  // namespace
}  // namespace voronaut
