#include <cstdlib>
#include <new>
#include <numbers>

#include <gtest/gtest.h>
#include <malloc.h>

#include "voronaut/planners/mapping/free_space/free_space.h"
#include "voronaut/planners/mapping/obstacle_base.h"
#include "voronaut/tests/support/random_scans.h"

namespace {

std::size_t allocations = 0;
std::size_t bytes_held = 0;

void release(void* memory) {
  bytes_held -= malloc_usable_size(memory);
  std::free(memory);
}

}  // namespace

void* operator new(std::size_t size) {
  ++allocations;
  void* const memory = std::malloc(size);
  if (memory == nullptr) throw std::bad_alloc();
  bytes_held += malloc_usable_size(memory);
  return memory;
}
void operator delete(void* memory) noexcept { release(memory); }
void operator delete(void* memory, std::size_t) noexcept { release(memory); }

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

// 64 pieces of ground, each 30 m from the one before and of the same kind. Vectors may hold twice
// what they need.
TEST(ObstacleBase, HoldsMemoryInProportionToWhatItHasSeenAndNoneForSeeingItAgain) {
  constexpr int kPieces = 64;
  constexpr double kPieceM = 30;
  const auto fan = std::make_shared<BeamFan>(BeamFan::spread(std::numbers::pi, 181));
  std::vector<std::vector<Scan>> pieces(kPieces);
  for (int piece = 0; piece < kPieces; ++piece) {
    Random random(static_cast<std::uint64_t>(piece) + 1);
    const ScanWorld world = random_scan_world(random, 12, 14, 6);
    for (int i = 0; i < 20; ++i) {
      Scan scan = cast_scan(world, random_pose(random, 12), fan, 5, 0, 0, random);
      scan.sensor_world.p_world.x() += kPieceM * piece;
      pieces[piece].push_back(scan);
    }
  }
  const std::size_t before = bytes_held;
  ObstacleBase base({});
  std::vector<double> bytes_per_point;
  for (int piece = 0; piece < kPieces; ++piece) {
    for (const Scan& scan : pieces[piece]) base.update(scan);
    const auto points = static_cast<double>(base.snapshot().points().size());
    bytes_per_point.push_back(static_cast<double>(bytes_held - before) / points);
  }
  EXPECT_GT(base.snapshot().points().size(), 64U * 100U);
  for (int piece = 4; piece < kPieces; ++piece) {
    EXPECT_LT(bytes_per_point[piece], 400) << "piece " << piece;
    EXPECT_GT(bytes_per_point[piece], bytes_per_point.back() / 2.5) << "piece " << piece;
    EXPECT_LT(bytes_per_point[piece], bytes_per_point.back() * 2.5) << "piece " << piece;
  }
  const std::size_t held = bytes_held;
  for (const std::vector<Scan>& scans : pieces) {
    for (const Scan& scan : scans) base.update(scan);
  }
  EXPECT_EQ(bytes_held, held);
}

// What scans of one place take does not depend on how far the bounds reach.
TEST(FreeSpace, HoldsWhatBeamsReachedWhateverTheBounds) {
  Random random(6);
  const ScanWorld world = random_scan_world(random, 12, 14, 6);
  const auto fan = std::make_shared<BeamFan>(BeamFan::spread(std::numbers::pi / 2, 91));
  std::vector<Scan> scans;
  for (int i = 0; i < 60; ++i)
    scans.push_back(cast_scan(world, random_pose(random, 12), fan, 2.5, 0, 0.02, random));
  std::vector<std::size_t> held;
  std::vector<std::size_t> free_cells;
  for (const double half_m : {25.0, 1'000.0, 10'000.0}) {
    const std::size_t before = bytes_held;
    FreeSpace space({Vec2::Constant(-half_m), Vec2::Constant(half_m)});
    for (const Scan& scan : scans) space.update(scan);
    held.push_back(bytes_held - before);
    free_cells.push_back(space.free_cells());
    const std::size_t allocated = allocations;
    for (const Scan& scan : scans) space.update(scan);
    EXPECT_EQ(allocations, allocated);
  }
  EXPECT_LT(held.front(), 100'000U);
  EXPECT_LE(5 * held[1], 6 * held[0]);
  EXPECT_LE(5 * held[2], 6 * held[0]);
  // The lattice begins at the corner of the bounds: rounded, it is a little different each time.
  EXPECT_NEAR(static_cast<double>(free_cells[2]), static_cast<double>(free_cells[0]), 50);
}

}  // namespace
}  // namespace voronaut
