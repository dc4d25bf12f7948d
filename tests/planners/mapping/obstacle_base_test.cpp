#include "voronaut/planners/mapping/obstacle_base.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "voronaut/tests/support/plain_obstacle_base.h"
#include "voronaut/tests/support/random_scans.h"

namespace voronaut {
namespace {

constexpr double kQuarterTurnRad = std::numbers::pi / 2;

void expect_same_report(const UpdateReport& fast, const UpdateReport& plain) {
  EXPECT_EQ(fast.returns, plain.returns);
  EXPECT_EQ(fast.invalid, plain.invalid);
  EXPECT_EQ(fast.points_added, plain.points_added);
  EXPECT_EQ(fast.clusters_in_scan, plain.clusters_in_scan);
  EXPECT_EQ(fast.merges, plain.merges);
  EXPECT_LE(fast.pairs_tested, plain.pairs_tested);
}

void expect_same_scan_clusters(const ObstacleBase& fast, const PlainObstacleBase& plain) {
  ASSERT_EQ(fast.scan_clusters().size(), plain.scan_clusters().size());
  for (std::size_t i = 0; i < plain.scan_clusters().size(); ++i) {
    const ScanCluster& a = fast.scan_clusters()[i];
    const ScanCluster& b = plain.scan_clusters()[i];
    EXPECT_TRUE(std::ranges::equal(a.points_world, b.points_world)) << "scan cluster " << i;
    EXPECT_EQ(a.cut_left, b.cut_left) << "scan cluster " << i;
    EXPECT_EQ(a.cut_right, b.cut_right) << "scan cluster " << i;
    EXPECT_EQ(a.cluster, b.cluster) << "scan cluster " << i;
  }
}

void expect_same_base(const ObstacleBase& fast, const PlainObstacleBase& plain) {
  const ObstacleSnapshot known = fast.snapshot();
  ASSERT_EQ(std::vector<Vec2>(known.points().begin(), known.points().end()), plain.points());
  std::vector<ClusterId> living;
  for (ClusterId id = 0; id < plain.clusters().size(); ++id) {
    if (!plain.clusters()[id].members.empty()) living.push_back(id);
  }
  ASSERT_EQ(known.clusters(), living);
  ASSERT_EQ(known.cluster_count(), living.size());
  for (const ClusterId id : living) {
    const PlainObstacleBase::Cluster& cluster = plain.clusters()[id];
    EXPECT_EQ(known.members(id), cluster.members) << "cluster " << id;
    EXPECT_EQ(known.first_stored(id), cluster.members.front());
    EXPECT_EQ(known.last_stored(id), cluster.members.back());
    EXPECT_EQ(known.hull(id), cluster.hull) << "cluster " << id;
  }
  for (PointId id = 0; id < plain.labels().size(); ++id) {
    ASSERT_EQ(known.cluster_of(id), plain.labels()[id]) << "point " << id;
  }
}

// Shows both forms the same scans and compares after each of them.
template <class MakeScan>
void compare(const ObstacleBaseConfig& config, int scans, const MakeScan& make_scan) {
  ObstacleBase fast(config);
  PlainObstacleBase plain(config);
  for (int i = 0; i < scans; ++i) {
    SCOPED_TRACE("scan " + std::to_string(i));
    const Scan scan = make_scan(i);
    expect_same_report(fast.update(scan), plain.update(scan));
    expect_same_scan_clusters(fast, plain);
    expect_same_base(fast, plain);
    if (::testing::Test::HasFailure()) return;
  }
}

TEST(ObstacleBase, EqualsThePlainFullSearchOnRandomWorlds) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const ScanWorld world = random_scan_world(random, 12, 14, 6);
    const double field = random.below(3) == 0 ? 4 * kQuarterTurnRad : kQuarterTurnRad;
    const auto fan = std::make_shared<BeamFan>(BeamFan::spread(field, 40 + random.below(80)));
    ObstacleBaseConfig config;
    config.link_distance_m = random.uniform(0.05, 1.0);
    config.thinning_distance_m = random.uniform(0.03, 0.4);
    config.merge_distance_m = random.uniform(0.0, 2.0);
    const double noise_m = random.below(2) == 0 ? 0 : 0.03;
    compare(config, 30, [&](int) {
      return cast_scan(world, random_pose(random, 12), fan, 5, noise_m, 0.03, random);
    });
    ASSERT_FALSE(HasFailure());
  }
}

TEST(ObstacleBase, EqualsThePlainFullSearchOnALattice) {
  for (std::uint64_t seed = 1; seed <= 150; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    ObstacleBaseConfig config;
    config.link_distance_m = 0.5 + static_cast<double>(random.below(4));
    config.thinning_distance_m = std::array{0.5, 1.0, 1.5}[random.below(3)];
    config.merge_distance_m = static_cast<double>(random.below(4));
    compare(config, 20, [&](int) { return lattice_scan(random, seed % 2 == 0); });
    ASSERT_FALSE(HasFailure());
  }
}

}  // namespace
}  // namespace voronaut
