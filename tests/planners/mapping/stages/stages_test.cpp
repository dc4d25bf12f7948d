#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

#include "voronaut/planners/mapping/obstacle_base.h"
#include "voronaut/planners/mapping/points/convex_polygon.h"
#include "voronaut/tests/support/made_scans.h"
#include "voronaut/tests/support/random_scans.h"

namespace voronaut {
namespace {

std::vector<Vec2> joined(std::vector<Vec2> a, const std::vector<Vec2>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

TEST(ScanStage, APostInFrontOfAWallDoesNotCutTheWallInTwo) {
  ObstacleBase base({.link_distance_m = 0.5, .thinning_distance_m = 0.08, .merge_distance_m = 0});
  // The post at 1 m hides 0.4 m of the wall at 3 m.
  const auto right = along({3, -1}, {3, -0.2}, 0.05);
  const auto post = along({1, -0.06}, {1, 0.06}, 0.03);
  const auto left = along({3, 0.2}, {3, 1}, 0.05);
  base.update(scan_of(joined(joined(right, post), left)));
  ASSERT_EQ(base.scan_clusters().size(), 2U);
  EXPECT_EQ(base.scan_clusters()[0].points_world.front(), right.front());
  EXPECT_NEAR(base.scan_clusters()[0].points_world.back().y(), 1, 0.08);
  EXPECT_EQ(base.scan_clusters()[1].points_world.front(), post.front());
}

TEST(ScanStage, LinksReturnsThatAreCloserThanTheLinkDistanceOnly) {
  const ObstacleBaseConfig config{
      .link_distance_m = 0.5, .thinning_distance_m = 0.08, .merge_distance_m = 0};
  ObstacleBase at_the_distance(config);
  at_the_distance.update(scan_of({{2, 0}, {2, 0.5}}));
  EXPECT_EQ(at_the_distance.scan_clusters().size(), 2U);
  ObstacleBase closer(config);
  closer.update(scan_of({{2, 0}, {2, std::nextafter(0.5, 0)}}));
  EXPECT_EQ(closer.scan_clusters().size(), 1U);
}

TEST(ScanStage, DropsAndCountsWhatIsNoMeasurement) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  Scan scan = scan_of(along({3, -0.3}, {3, 0.3}, 0.05));
  const std::size_t returns = scan.size() - 2;
  const std::array<double, 6> broken{nan, infinity, -infinity, 0, -1, 100.5};
  for (std::size_t i = 0; i < broken.size(); ++i) scan.range_m[2 + i] = broken[i];
  ObstacleBase base({});
  const UpdateReport& report = base.update(scan);
  EXPECT_EQ(report.invalid, broken.size());
  EXPECT_EQ(report.returns, returns - broken.size());
  for (const Vec2& p : base.snapshot().points()) EXPECT_TRUE(p.allFinite());
}

TEST(ScanStage, SaysWhichClustersTheFieldOfViewCuts) {
  Scan scan = scan_of(joined({{3, -2}}, {{3, 0}, {3, 2}}));
  ObstacleBase base({});
  base.update(scan);
  for (const ScanCluster& cluster : base.scan_clusters()) {
    EXPECT_FALSE(cluster.cut_left || cluster.cut_right);
  }
  // The outermost beams measured nothing at all, so the next ones are the edges.
  scan.range_m.front() = 0;
  scan.range_m.back() = std::numeric_limits<double>::quiet_NaN();
  base.update(scan);
  ASSERT_EQ(base.scan_clusters().size(), 3U);
  EXPECT_TRUE(base.scan_clusters()[0].cut_right && !base.scan_clusters()[0].cut_left);
  EXPECT_FALSE(base.scan_clusters()[1].cut_right || base.scan_clusters()[1].cut_left);
  EXPECT_TRUE(base.scan_clusters()[2].cut_left && !base.scan_clusters()[2].cut_right);
}

TEST(ThinningStage, KeepsNoTwoPointsCloserAndCoversEveryReturn) {
  Random random(5);
  const ScanWorld world = random_scan_world(random, 12, 12, 5);
  const auto fan = std::make_shared<BeamFan>(BeamFan::spread(std::numbers::pi, 240));
  ObstacleBase base({});
  const double delta_m = base.config().thinning_distance_m;
  std::vector<Vec2> seen;
  for (int i = 0; i < 20; ++i) {
    const Scan scan = cast_scan(world, random_pose(random, 12), fan, 5, 0.01, 0, random);
    base.update(scan);
    for (std::size_t k = 0; k < scan.size(); ++k) {
      if (scan.is_return(k)) seen.push_back(scan.point_world(k));
    }
  }
  const std::span<const Vec2> kept = base.snapshot().points();
  for (std::size_t i = 0; i < kept.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) ASSERT_GE((kept[i] - kept[j]).norm(), delta_m);
  }
  for (const Vec2& p : seen) ASSERT_TRUE(base.snapshot().nearest(p, delta_m).has_value());
}

TEST(ThinningStage, DependsOnNoClusterDistance) {
  const auto points_with = [](double link_m, double merge_m) {
    Random random(6);
    const ScanWorld world = random_scan_world(random, 12, 12, 5);
    const auto fan = std::make_shared<BeamFan>(BeamFan::spread(std::numbers::pi, 120));
    ObstacleBase base({.link_distance_m = link_m, .merge_distance_m = merge_m});
    for (int i = 0; i < 20; ++i) {
      base.update(cast_scan(world, random_pose(random, 12), fan, 5, 0.01, 0, random));
    }
    const std::span<const Vec2> points = base.snapshot().points();
    return std::vector<Vec2>(points.begin(), points.end());
  };
  EXPECT_EQ(points_with(0.2, 0), points_with(2, 3));
}

TEST(JoiningStage, KnownReturnsStoreNothing) {
  ObstacleBase base({});
  const Scan scan = scan_of(along({3, -1}, {3, 1}, 0.05));
  EXPECT_GT(base.update(scan).points_added, 10U);
  const std::uint64_t version = base.snapshot().version();
  EXPECT_EQ(base.update(scan).points_added, 0U);
  EXPECT_EQ(base.snapshot().version(), version);
  EXPECT_EQ(base.snapshot().cluster_count(), 1U);
}

// Figure 4(a) of the quadrotor paper: what is seen now crosses what is known.
TEST(MergingStage, MergesClustersWhosePolygonsCross) {
  ObstacleBase base({.link_distance_m = 1, .merge_distance_m = 0});
  base.update(scan_of(along({4, -1}, {4, 1}, 0.3)));
  base.update(scan_of(along({3.05, 0.1}, {4.95, -0.1}, 0.43)));
  EXPECT_EQ(base.snapshot().cluster_count(), 1U);
  EXPECT_EQ(base.report().merges, 1U);
  EXPECT_EQ(base.report().pairs_tested, 1U);
}

// Figure 4(b): they do not cross, but an extreme point of one is near an extreme point of the
// other.
TEST(MergingStage, MergesClustersWhoseExtremePointsAreNear) {
  const auto first = along({4, -1}, {4, 0}, 0.3);
  const auto second = along({4, 0.79}, {4, 2}, 0.3);
  ObstacleBase base({.merge_distance_m = 0.8});
  base.update(scan_of(first));
  base.update(scan_of(second));
  EXPECT_EQ(base.snapshot().cluster_count(), 1U);
  ObstacleBase narrow({.merge_distance_m = 0.79});
  narrow.update(scan_of(first));
  narrow.update(scan_of(second));
  EXPECT_EQ(narrow.snapshot().cluster_count(), 2U);
}

TEST(MergingStage, LooksAtExtremePointsOnlyNotAtMembers) {
  // The second wall ends 0.3 m from the middle of the first, and neither polygon crosses.
  ObstacleBase base({.merge_distance_m = 0.8});
  base.update(scan_of(along({4, -2}, {4, 2}, 0.3)));
  base.update(scan_of(along({3.7, 0}, {2, 0}, 0.3)));
  EXPECT_EQ(base.snapshot().cluster_count(), 2U);
}

TEST(MergingStage, OlderClustersKeepTheirIdAndComeFirst) {
  ObstacleBase base({.merge_distance_m = 0.5});
  base.update(scan_of({{4, 0}}));
  base.update(scan_of({{4, 0.8}}));
  EXPECT_EQ(base.snapshot().clusters(), (std::vector<ClusterId>{0, 1}));
  base.update(scan_of({{4, 0.4}}));
  EXPECT_EQ(base.snapshot().clusters(), (std::vector<ClusterId>{0}));
  EXPECT_EQ(base.snapshot().members(0), (std::vector<PointId>{0, 1, 2}));
  EXPECT_EQ(base.snapshot().cluster_of(1), ClusterId{0});
  EXPECT_EQ(base.snapshot().first_stored(2), PointId{0});
  EXPECT_EQ(base.snapshot().last_stored(1), PointId{2});
}

// The order in which the obstacles were seen decides ids, not what belongs together, as long as
// no extreme point is lost on the way.
TEST(MergingStage, TheOrderOfScansDoesNotChangeWhatBelongsTogether) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    Random random(seed);
    std::vector<Vec2> posts;
    for (int i = 0; i < 12; ++i) posts.push_back({random.uniform(0, 6), random.uniform(0, 6)});
    const auto partition = [&](const std::vector<Vec2>& order) {
      ObstacleBase base({.thinning_distance_m = 0.001, .merge_distance_m = 0});
      for (const Vec2& p : order) base.update(scan_of(along(p, p + Vec2{0.9, 0.4}, 0.3)));
      std::vector<std::vector<double>> groups;
      for (const ClusterId id : base.snapshot().clusters()) {
        std::vector<double>& group = groups.emplace_back();
        for (const PointId p : base.snapshot().members(id)) {
          group.push_back(base.snapshot().points()[p].x());
        }
        std::ranges::sort(group);
      }
      std::ranges::sort(groups);
      return groups;
    };
    std::vector<Vec2> shuffled = posts;
    for (std::size_t i = shuffled.size(); i > 1; --i) {
      std::swap(shuffled[i - 1], shuffled[random.below(i)]);
    }
    ASSERT_EQ(partition(posts), partition(shuffled)) << "seed " << seed;
  }
}

TEST(ObstacleBaseConfig, RefusesDistancesThatMakeNoSense) {
  EXPECT_THROW(ObstacleBase({.link_distance_m = 0}), std::invalid_argument);
  EXPECT_THROW(ObstacleBase({.thinning_distance_m = std::nan("")}), std::invalid_argument);
  EXPECT_THROW(ObstacleBase({.merge_distance_m = -1}), std::invalid_argument);
}

TEST(ObstacleSnapshot, TellsWhatIsNewSinceAVersion) {
  ObstacleBase base({});
  EXPECT_EQ(base.snapshot().version(), 0U);
  base.update(scan_of(along({3, -1}, {3, 0}, 0.1)));
  const std::uint64_t version = base.snapshot().version();
  const std::size_t known = base.snapshot().points().size();
  EXPECT_EQ(version, 1U);
  base.update(scan_of(along({3, -1}, {3, 1}, 0.1)));
  EXPECT_EQ(base.snapshot().version(), 2U);
  const std::span<const Vec2> fresh = base.snapshot().points_since(version);
  EXPECT_EQ(fresh.size(), base.snapshot().points().size() - known);
  EXPECT_EQ(fresh.front(), base.snapshot().points()[known]);
  EXPECT_TRUE(base.snapshot().points_since(2).empty());
  EXPECT_EQ(base.snapshot().points_since(0).size(), base.snapshot().points().size());
}

TEST(ObstacleSnapshot, AFrozenOneOutlivesUpdates) {
  ObstacleBase base({});
  base.update(scan_of(along({3, -1}, {3, 0}, 0.1)));
  const auto frozen = base.snapshot().freeze();
  const std::size_t known = frozen->snapshot().points().size();
  base.update(scan_of(along({5, 2}, {5, 3}, 0.1)));
  EXPECT_EQ(frozen->snapshot().points().size(), known);
  EXPECT_EQ(frozen->snapshot().cluster_count(), 1U);
  EXPECT_TRUE(frozen->snapshot().disc_is_clear({5, 2.5}, 0.3));
  EXPECT_FALSE(base.snapshot().disc_is_clear({5, 2.5}, 0.3));
}

TEST(ObstacleSnapshot, OfNothingIsClearEverywhere) {
  const ObstacleSnapshot nothing;
  EXPECT_EQ(nothing.version(), 0U);
  EXPECT_TRUE(nothing.points().empty() && nothing.clusters().empty());
  EXPECT_TRUE(nothing.disc_is_clear({0, 0}, 10));
  EXPECT_TRUE(nothing.swept_disc_is_clear({0, 0}, {1, 1}, 10));
  EXPECT_EQ(nothing.segment_clearance_m({0, 0}, {1, 1}, 2.5), 2.5);
  EXPECT_FALSE(nothing.nearest({0, 0}, 10).has_value());
  EXPECT_EQ(nothing.freeze(), nullptr);
}

// Merging is labelling only. In a dense forest (0.2 circles per m2) and with a vehicle 2 m wide
// hulls cover much free space; what is clear is decided by member points alone, so every answer is
// the same as without any merging, and as a search through the points gives.
TEST(ObstacleSnapshot, LabelsDecideNoClearance) {
  Random random(9);
  const ScanWorld world = random_scan_world(random, 20, 80, 0);
  const auto fan = std::make_shared<BeamFan>(BeamFan::spread(std::numbers::pi, 180));
  ObstacleBase wide({.merge_distance_m = 2});
  ObstacleBase none({.merge_distance_m = 0});
  for (int i = 0; i < 60; ++i) {
    const Scan scan = cast_scan(world, random_pose(random, 20), fan, 5, 0, 0, random);
    wide.update(scan);
    none.update(scan);
  }
  const ObstacleSnapshot labelled = wide.snapshot();
  const ObstacleSnapshot plain = none.snapshot();
  double widest_m = 0;
  for (const ClusterId id : labelled.clusters()) {
    const Bounds box = bounding_box(labelled.hull(id));
    widest_m = std::max(widest_m, (box.max - box.min).norm());
  }
  EXPECT_GT(widest_m, 15);
  EXPECT_LT(labelled.cluster_count(), plain.cluster_count() / 2);
  int clear_inside_a_hull = 0;
  for (int i = 0; i < 5'000; ++i) {
    const Vec2 a{random.uniform(-10, 10), random.uniform(-10, 10)};
    const Vec2 b = a + Vec2{random.uniform(-2, 2), random.uniform(-2, 2)};
    double clearance_m = 3;
    for (const Vec2& p : labelled.points())
      clearance_m = std::min(clearance_m, distance(p, {a, b}));
    ASSERT_EQ(labelled.disc_is_clear(a, 0.4), plain.disc_is_clear(a, 0.4));
    ASSERT_EQ(labelled.swept_disc_is_clear(a, b, 0.4), clearance_m >= 0.4);
    ASSERT_EQ(labelled.swept_disc_is_clear(a, b, 0.4), plain.swept_disc_is_clear(a, b, 0.4));
    ASSERT_EQ(labelled.nearest(a, 3), plain.nearest(a, 3));
    ASSERT_NEAR(labelled.segment_clearance_m(a, b, 3), clearance_m, 1e-9);
    for (const ClusterId id : labelled.clusters()) {
      clear_inside_a_hull +=
          clearance_m >= 0.4 && convex_polygons_touch(labelled.hull(id), std::array<Vec2, 1>{a});
    }
  }
  EXPECT_GT(clear_inside_a_hull, 100) << "no hull covers free space: the test shows nothing";
}

}  // namespace
}  // namespace voronaut
