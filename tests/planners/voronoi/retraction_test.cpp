#include "voronaut/planners/voronoi/retraction.h"

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

#include "voronaut/environments/random.h"
#include "voronaut/tests/planners/voronoi/random_graph.h"

namespace voronaut {
namespace {

using voronoi_test::RandomGraph;

double nearest_site_m(const DelaunayTriangulation& delaunay, const Vec2& p) {
  return (delaunay.site(delaunay.nearest_site(p)) - p).norm();
}

// As far from the two sites of the edge as from the closest one, or on the border of the domain.
TEST(Retraction, LandsWhereTheCellOrTheDomainEnds) {
  int on_edges = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const RandomGraph random(seed, 60);
    Random places(seed + 100);
    for (int i = 0; i < 200; ++i) {
      const Vec2 p(places.uniform(-10, 10), places.uniform(-10, 10));
      const Retraction r = retract(random.delaunay, random.graph, p);
      EXPECT_NEAR(r.clearance_m, nearest_site_m(random.delaunay, p), 1e-9);
      const double closest_m = nearest_site_m(random.delaunay, r.landing);
      EXPECT_GE(closest_m, r.clearance_m - 1e-9) << "the clearance only grows";
      if (r.sites[0] == r.sites[1]) {
        const Vec2 inside = RandomGraph::kDomain.max.cwiseMin(r.landing) -
                            RandomGraph::kDomain.min.cwiseMax(r.landing);
        EXPECT_LE(inside.norm(), 1e-9);
        continue;
      }
      ++on_edges;
      for (const SiteId site : r.sites)
        EXPECT_NEAR((random.delaunay.site(site) - r.landing).norm(), closest_m, 1e-6);
    }
  }
  EXPECT_GT(on_edges, 2000);
}

}  // namespace
}  // namespace voronaut
