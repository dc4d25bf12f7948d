#include "voronaut/planners/voronoi/graph_search.h"

#include <limits>

#include <gtest/gtest.h>

#include "voronaut/tests/planners/voronoi/random_graph.h"

namespace voronaut {
namespace {

using voronoi_test::RandomGraph;

constexpr double kFar_m = std::numeric_limits<double>::infinity();

// Of every vertex from one, by relaxing all edges until nothing changes (Bellman and Ford).
std::vector<double> costs_from(const VoronoiGraph& graph, VertexId start) {
  std::vector<double> cost_m(graph.vertices().size(), kFar_m);
  cost_m[start] = 0;
  for (bool changed = true; changed;) {
    changed = false;
    for (const auto& [u, v, length_m] : graph.edges()) {
      for (const auto& [from, to] : {std::pair(u, v), std::pair(v, u)}) {
        if (cost_m[from] + length_m >= cost_m[to]) continue;
        cost_m[to] = cost_m[from] + length_m;
        changed = true;
      }
    }
  }
  return cost_m;
}

TEST(GraphSearch, FindsWhatRelaxingEveryEdgeFinds) {
  GraphSearch search;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const RandomGraph random(seed, 80);
    const auto vertices = static_cast<VertexId>(random.graph.vertices().size());
    const VertexId start = static_cast<VertexId>(seed) % vertices;
    const std::vector<double> cost_m = costs_from(random.graph, start);
    for (VertexId goal = 0; goal < vertices; ++goal) {
      const Terminal from{start, 0}, to{goal, 0};
      GraphSearch::Result result;
      const bool found =
          search.run(random.graph, {&from, 1}, {&to, 1}, random.graph.vertices()[goal], result);
      ASSERT_EQ(found, cost_m[goal] < kFar_m) << seed << " " << goal;
      if (found) {
        ASSERT_NEAR(result.cost_m, cost_m[goal], 1e-9) << seed << " " << goal;
      }
    }
  }
}

}  // namespace
}  // namespace voronaut
