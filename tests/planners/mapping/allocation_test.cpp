#include <cstdlib>
#include <new>
#include <numbers>

#include <gtest/gtest.h>

#include "voronaut/planners/mapping/obstacle_base.h"
#include "voronaut/tests/support/random_scans.h"

namespace {

std::size_t allocations = 0;

}  // namespace

void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace voronaut {
namespace {

TEST(ObstacleBase, AllocatesNothingOnAScanThatShowsNothingNew) {
  Random random(4);
  const ScanWorld world = random_scan_world(random, 12, 14, 6);
  for (const double field : {std::numbers::pi / 2, 2 * std::numbers::pi}) {
    const auto fan = std::make_shared<BeamFan>(BeamFan::spread(field, 360));
    std::vector<Scan> scans;
    for (int i = 0; i < 40; ++i) {
      scans.push_back(cast_scan(world, random_pose(random, 12), fan, 5, 0, 0.02, random));
    }
    ObstacleBase base({});
    for (const Scan& scan : scans) base.update(scan);
    const std::size_t points = base.snapshot().points().size();
    const std::size_t before = allocations;
    for (const Scan& scan : scans) base.update(scan);
    const std::size_t during = allocations - before;
    EXPECT_EQ(during, 0U);
    EXPECT_EQ(base.snapshot().points().size(), points);
    EXPECT_GT(before, 0U);
  }
}

}  // namespace
}  // namespace voronaut
