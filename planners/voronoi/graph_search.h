#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "voronaut/planners/voronoi/voronoi_graph.h"

namespace voronaut {

// A vertex from which a search may begin or with which it may end, and what the way between it and
// the start or the goal costs.
struct Terminal {
  VertexId vertex;
  double cost_m;
};

// A* (Hart, Nilsson and Raphael, https://doi.org/10.1109/TSSC.1968.300136) with the straight
// distance to the goal as its estimate. Buffers are kept between searches. Of equal entries the one
// with the lower vertex number goes first, so the same graph gives the same path.
class GraphSearch {
 public:
  struct Result {
    std::size_t start = 0;  // index into starts
    std::size_t goal = 0;   // index into goals
    double cost_m = 0;
    std::vector<VertexId> vertices;  // from starts[start] to goals[goal], both included
  };

  // False if no start is connected with any goal; then every vertex connected with a start was
  // expanded. O(edges log edges).
  bool run(const VoronoiGraph& graph, std::span<const Terminal> starts,
           std::span<const Terminal> goals, const Vec2& goal, Result& result);

  std::size_t expanded() const { return expanded_; }
  // Whether the latest run reached a vertex.
  bool reached(VertexId v) const { return parent_[v] != kUnseen; }

 private:
  static constexpr std::int32_t kUnseen = -2;
  struct Entry {
    double estimate_m;
    double cost_m;
    VertexId vertex;
  };

  // A way to v, the goal itself if v is one more than the last vertex.
  void offer(const VoronoiGraph& graph, const Vec2& goal, VertexId v, double cost_m,
             VertexId parent);
  void trace(VertexId end, std::vector<VertexId>& vertices) const;
  void push(double estimate_m, double cost_m, VertexId v);
  Entry pop();

  std::vector<Entry> heap_;
  std::vector<double> cost_m_;
  std::vector<std::int32_t> parent_;  // -1 at a start
  std::size_t expanded_ = 0;
};

}  // namespace voronaut
