#pragma once

#include <cstdint>

#include "voronaut/environments/random.h"
#include "voronaut/planners/voronoi/voronoi_graph.h"

namespace voronaut::voronoi_test {

// The diagram of random sites, with nearly every edge kept.
struct RandomGraph {
  static inline const Bounds kDomain{Vec2(-10, -10), Vec2(10, 10)};

  RandomGraph(std::uint64_t seed, int sites) {
    delaunay.reset({Vec2(-20, -20), Vec2(20, 20)});
    Random random(seed);
    for (int i = 0; i < sites; ++i)
      delaunay.insert({random.uniform(-10, 10), random.uniform(-10, 10)});
    graph.build(delaunay, kDomain, 0.01);
  }

  DelaunayTriangulation delaunay;
  VoronoiGraph graph;
};

}  // namespace voronaut::voronoi_test
