#include "voronaut/benchmarks/episode/cluster_history.h"

#include <map>

#include <gtest/gtest.h>

#include "voronaut/environments/random.h"
#include "voronaut/environments/sensing/range_finder.h"
#include "voronaut/environments/world.h"
#include "voronaut/planners/mapping/obstacle_base.h"

namespace voronaut {
namespace {

World random_circles(std::uint64_t seed) {
  Random random(seed);
  Shapes shapes;
  for (int i = 0; i < 60; ++i) {
    const Vec2 center(1 + random.uniform() * 18, random.uniform() * 8 - 4);
    if (std::abs(center.y()) > 0.6) shapes.circles.push_back({center, 0.3});
  }
  return {{Vec2(-1, -6), Vec2(21, 6)}, shapes};
}

// As a reader of a log does it: the label a point was born with, through the merges by then.
ClusterId label_of(const ClusterHistory& history, PointId point, std::size_t scan) {
  ClusterId label = history.labels()[point];
  for (const auto& merge : history.merges()) {
    if (merge.scan <= scan && merge.from == label) label = merge.into;
  }
  return label;
}

TEST(ClusterHistory, TellsTheGroupingOfEveryScan) {
  std::size_t merges = 0;
  for (const std::uint64_t seed : {1, 2, 3, 4, 5, 6}) {
    const World world = random_circles(seed);
    const RangeFinder range_finder(RangeFinderConfig{});
    ObstacleBase map(ObstacleBaseConfig{});
    ClusterHistory history;
    Random noise(seed);
    Scan scan;
    std::vector<std::vector<ClusterId>> labels_then;
    for (std::size_t i = 0; i < 100; ++i) {
      const auto step = static_cast<double>(i);
      range_finder.sense(world, {Vec2(0.2 * step, 0), Vec2(1, 0)}, 0.05 * step, noise, scan);
      map.update(scan);
      history.note(i, map.snapshot());
      auto& labels = labels_then.emplace_back();
      for (PointId p = 0; p < map.snapshot().points().size(); ++p) {
        labels.push_back(map.snapshot().cluster_of(p));
      }
    }
    for (std::size_t i = 0; i < labels_then.size(); ++i) {
      for (PointId p = 0; p < labels_then[i].size(); ++p) {
        ASSERT_EQ(label_of(history, p, i), labels_then[i][p]) << "scan " << i << ", point " << p;
      }
    }
    merges += history.merges().size();
  }
  EXPECT_GE(merges, 5U);
}

}  // namespace
}  // namespace voronaut
