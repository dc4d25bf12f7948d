#include <numbers>

#include <gtest/gtest.h>

#include "voronaut/planners/mapping/obstacle_base.h"
#include "voronaut/tests/support/random_scans.h"

namespace voronaut {
namespace {

struct Mapped {
  std::size_t points = 0;
  std::size_t clusters = 0;
  std::size_t invalid = 0;
};

// The same 400 scans of one world, disturbed.
Mapped map_with(double noise_m, double dropout) {
  Random world_random(21);
  const ScanWorld world = random_scan_world(world_random, 20, 20, 6);
  const auto fan = std::make_shared<BeamFan>(BeamFan::spread(std::numbers::pi / 2, 181));
  Random poses(22);
  Random disturbance(23);
  ObstacleBase base({});
  Mapped mapped;
  for (int i = 0; i < 400; ++i) {
    const Pose2 pose = random_pose(poses, 20);
    mapped.invalid +=
        base.update(cast_scan(world, pose, fan, 5, noise_m, dropout, disturbance)).invalid;
  }
  mapped.points = base.snapshot().points().size();
  mapped.clusters = base.snapshot().cluster_count();
  return mapped;
}

TEST(ObstacleBase, ACentimetreOfNoiseAddsFewPointsAndThreeThickenTheRims) {
  const Mapped exact = map_with(0, 0);
  const Mapped fine = map_with(0.01, 0);
  const Mapped coarse = map_with(0.03, 0);
  const auto points = static_cast<double>(exact.points);
  EXPECT_GT(exact.points, 300U);
  EXPECT_LT(static_cast<double>(fine.points), 1.3 * points);
  EXPECT_LT(static_cast<double>(coarse.points), 3 * points);
  EXPECT_NEAR(static_cast<double>(fine.clusters), static_cast<double>(exact.clusters), 3);
  EXPECT_NEAR(static_cast<double>(coarse.clusters), static_cast<double>(exact.clusters), 5);
}

TEST(ObstacleBase, DropsReturnsThatAreNoMeasurementAndKnowsTheSameObstaclesInTheEnd) {
  const Mapped exact = map_with(0, 0);
  const Mapped broken = map_with(0, 0.2);
  EXPECT_EQ(exact.invalid, 0U);
  EXPECT_NEAR(static_cast<double>(broken.invalid), 0.2 * 400 * 181, 500);
  EXPECT_NEAR(static_cast<double>(broken.points), static_cast<double>(exact.points),
              0.05 * static_cast<double>(exact.points));
  EXPECT_NEAR(static_cast<double>(broken.clusters), static_cast<double>(exact.clusters), 3);
}

}  // namespace
}  // namespace voronaut
