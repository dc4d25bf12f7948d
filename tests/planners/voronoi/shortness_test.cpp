#include <algorithm>
#include <cstdio>

#include <gmock/gmock.h>

#include "voronaut/environments/generators/world_generators.h"
#include "voronaut/environments/shortest_path/shortest_path.h"
#include "voronaut/planners/voronoi/voronoi_router.h"
#include "voronaut/tests/planners/voronoi/voronoi_worlds.h"

namespace voronaut {
namespace {

using namespace voronoi_test;

constexpr double kClearance_m = 0.4;

std::vector<Vec2> surface_points(const Shapes& shapes) {
  std::vector<Vec2> points;
  for (const Circle& c : shapes.circles) add_circle(points, c.center, c.radius_m);
  for (const Segment& s : shapes.segments) add_wall(points, s.a, s.b);
  for (const Polygon& p : shapes.polygons)
    for (std::size_t i = 0; i < p.vertices.size(); ++i) {
      const Segment side = edge(p, i);
      add_wall(points, side.a, side.b);
    }
  return points;
}

class Shortness : public testing::TestWithParam<const char*> {};

// The reference searches the tangent graph of the true shapes: nothing is shared but the worlds.
// Points 8 cm apart leave dents of 1 mm in a wall, so a ratio may be a little below one.
TEST_P(Shortness, IsWithinTwoPercentOnAverageAndFiveInNinetyFiveOfAHundred) {
  const WorldGenerator generator = WorldGenerator::named(GetParam());
  std::vector<double> ratios;
  for (std::uint64_t seed = 1; seed <= 120; ++seed) {
    const GeneratedWorld world = generator.generate(seed);
    VoronoiRouter router;
    const std::vector<Vec2> places{world.start, world.goal};
    router.observe(surface_points(world.shapes), world.bounds, kClearance_m, places);
    RouteQuery query;
    query.start = world.start;
    query.goal = world.goal;
    const Route route = router.route(query);
    const auto shortest =
        shortest_path(World(world.bounds, world.shapes), world.start, world.goal, kClearance_m);
    ASSERT_EQ(route.verdict == Route::Verdict::found, shortest.has_value()) << "seed " << seed;
    if (shortest) ratios.push_back(route.length_m / shortest->length_m);
  }
  ASSERT_GE(ratios.size(), 100u);
  std::sort(ratios.begin(), ratios.end());
  double mean = 0;
  for (const double ratio : ratios) mean += ratio / static_cast<double>(ratios.size());
  std::printf("%s: %zu worlds, ratio to the shortest path: mean %.4f, 95%% %.4f, worst %.4f\n",
              GetParam(), ratios.size(), mean, ratios[ratios.size() * 95 / 100], ratios.back());
  EXPECT_LE(mean, 1.002);
  EXPECT_LE(ratios[ratios.size() * 95 / 100], 1.005);
  EXPECT_LE(ratios.back(), 1.02);
  EXPECT_GE(ratios.front(), 0.99);
}

INSTANTIATE_TEST_SUITE_P(VoronoiRouter, Shortness,
                         testing::Values("forest", "rooms", "maze", "braided_maze", "walls"));

}  // namespace
}  // namespace voronaut
