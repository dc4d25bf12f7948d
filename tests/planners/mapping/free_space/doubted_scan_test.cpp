#include "voronaut/planners/mapping/free_space/doubted_scan.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "voronaut/environments/sensing/range_finder.h"
#include "voronaut/environments/world.h"
#include "voronaut/planners/mapping/free_space/free_space.h"

namespace voronaut {
namespace {

constexpr double kBody_m = 0.3;
const Bounds kBounds{Vec2(-4, -4), Vec2(4, 4)};

World any_world(Random& random) {
  Shapes shapes;
  for (int i = 0; i < 25; ++i) {
    const Vec2 p(random.uniform(-3, 3), random.uniform(-3, 3));
    const double radius_m = random.uniform(0.02, 0.3);
    if (p.norm() > kBody_m + radius_m) shapes.circles.push_back({p, radius_m});
  }
  return World(kBounds, shapes);
}

// A number at one end of [-bound, bound], or anywhere within.
double off_by(double bound, Random& random) {
  const double where = random.uniform(-2, 2);
  return bound * std::min(1.0, std::max(-1.0, where));
}

// The deepest that a cell taken for free reaches into an obstacle, over many scans that are as far
// off as `real` allows and of which `declared` is told; below 0: none does.
double deepest_m(const SensingErrors& real, const SensingErrors& declared, double field_rad,
                 double dropouts) {
  Random random(11);
  RangeFinderConfig config;
  config.field_of_view_rad = field_rad;
  config.rays = 360;
  const RangeFinder finder(config);
  DoubtedScan doubted(declared, kBody_m);
  double deepest_m = -1;
  for (int round = 0; round < 60; ++round) {
    const World world = any_world(random);
    const double bearing_rad = random.uniform(-3, 3);
    const Pose2 truth{Vec2(0, 0), Vec2(std::cos(bearing_rad), std::sin(bearing_rad))};
    Scan scan;
    finder.sense(world, truth, 0, random, scan);
    const double turn_rad = bearing_rad + off_by(real.heading_rad, random);
    const double way_rad = random.uniform(-3, 3);
    scan.sensor_world = {
        off_by(real.position_m, random) * Vec2(std::cos(way_rad), std::sin(way_rad)),
        Vec2(std::cos(turn_rad), std::sin(turn_rad))};
    for (std::size_t i = 0; i < scan.size(); ++i) {
      if (scan.is_return(i)) scan.range_m[i] += off_by(real.range_m, random);
      if (random.uniform() < dropouts) scan.range_m[i] = std::numeric_limits<double>::quiet_NaN();
    }
    FreeSpace free(kBounds, {.cell_m = 0.02});
    free.update(declared.none() ? scan : doubted.of(scan));
    for (const Circle& circle : world.shapes().circles) {
      for (double depth_m = 0.001; depth_m < circle.radius_m; depth_m += 0.005) {
        for (double at_rad = 0; at_rad < 6.28; at_rad += 0.1) {
          const Vec2 out(std::cos(at_rad), std::sin(at_rad));
          const Vec2 p = circle.center + (circle.radius_m - depth_m) * out;
          if (free.is_free(p)) deepest_m = std::max(deepest_m, -world.clearance_m(p));
        }
      }
    }
  }
  return deepest_m;
}

constexpr double kChord_m = 0.001;  // of two beams, beside what bends between them

TEST(DoubtedScan, ProvesNothingThatIsNotEmptyAsLongAsTheErrorsAreDeclared) {
  for (const SensingErrors& errors : {SensingErrors{0.05, 0, 0}, SensingErrors{0, 0.05, 0},
                                      SensingErrors{0, 0, 0.05}, SensingErrors{0.02, 0.03, 0.03}}) {
    for (const double field_rad : {1.6, 4.7, 6.283185307179586}) {
      EXPECT_LE(deepest_m(errors, errors, field_rad, 0), kChord_m) << field_rad;
      EXPECT_LE(deepest_m(errors, errors, field_rad, 0.02), kChord_m) << field_rad;
      EXPECT_GT(deepest_m(errors, {}, field_rad, 0), 0.01) << "nothing is shown";
    }
  }
}

TEST(DoubtedScan, TakesAwayNoMoreThanARim) {
  RangeFinderConfig config;
  config.rays = 181;
  config.field_of_view_rad = 3.14159265;
  Random random(1);
  Shapes wall;
  wall.segments.push_back({Vec2(2, -4), Vec2(2, 4)});
  Scan scan;
  RangeFinder(config).sense(World(kBounds, wall), {Vec2(0, 0), Vec2(1, 0)}, 0, random, scan);
  DoubtedScan doubted({0.01, 0.02, 0.02}, kBody_m);
  FreeSpace free(kBounds, {.cell_m = 0.01});
  free.update(doubted.of(scan));
  EXPECT_TRUE(free.is_free(Vec2(1.94, 0)));
  EXPECT_TRUE(free.is_free(Vec2(1.92, 0.5)));
  EXPECT_FALSE(free.is_free(Vec2(1.98, 0)));
  EXPECT_TRUE(free.is_free(Vec2(0.2, 1.8)));  // 6.3 deg within the edge of the view
  EXPECT_FALSE(free.is_free(Vec2(0.05, 1.8)));
}

TEST(DoubtedScan, LeavesAnExactScanAsItIs) {
  RangeFinderConfig config;
  Random random(1);
  Scan scan;
  RangeFinder(config).sense(World(kBounds, {}), {Vec2(0, 0), Vec2(1, 0)}, 0, random, scan);
  EXPECT_TRUE(SensingErrors{}.none());
  EXPECT_FALSE((SensingErrors{.position_m = 0.01}.none()));
  scan.range_m[45] = 0.01;
  DoubtedScan doubted({.position_m = 0.02}, kBody_m);
  EXPECT_EQ(doubted.of(scan).range_m[45], 0);
}

}  // namespace
}  // namespace voronaut
