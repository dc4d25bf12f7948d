#include "voronaut/planners/voronoi/voronoi_router.h"

#include <gmock/gmock.h>

#include "voronoi_worlds.h"

namespace voronaut {
namespace {

using namespace voronoi_test;

constexpr double kClearance_m = 0.4;

Route plan(VoronoiRouter& router, const PointWorld& world,
           Shortening shortening = Shortening::channel) {
  const std::vector<Vec2> places{world.start, world.goal};
  router.observe(world.points, world.bounds, kClearance_m, places);
  RouteQuery query;
  query.start = world.start;
  query.goal = world.goal;
  query.shortening = shortening;
  return router.route(query);
}

TEST(VoronoiRouter, NeverComesCloserThanTheClearance) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Random random(seed);
    const PointWorld worlds[] = {forest(random, 0.15, 14), rooms(random),
                                 scattered(random, 150, 14)};
    for (const PointWorld& world : worlds) {
      for (const Shortening how : {Shortening::none, Shortening::shortcut, Shortening::channel}) {
        VoronoiRouter router;
        const Route route = plan(router, world, how);
        if (route.points.empty()) continue;
        EXPECT_GE(clearance_m(route.points, world.points), kClearance_m) << "seed " << seed;
        EXPECT_EQ(route.points.front(), world.start);
        EXPECT_EQ(route.points.back(), world.goal);
        for (const Vec2& p : route.points) EXPECT_TRUE(world.bounds.contains(p)) << "seed " << seed;
      }
    }
  }
}

}  // namespace
}  // namespace voronaut
