#include "voronaut/planners/voronoi/graph_search.h"

#include <algorithm>

namespace voronaut {

namespace {

// Of the terminals at this vertex.
std::size_t cheapest(std::span<const Terminal> terminals, VertexId v) {
  std::size_t best = terminals.size();
  for (std::size_t i = 0; i < terminals.size(); ++i)
    if (terminals[i].vertex == v &&
        (best == terminals.size() || terminals[i].cost_m < terminals[best].cost_m))
      best = i;
  return best;
}

}  // namespace

bool GraphSearch::run(const VoronoiGraph& graph, std::span<const Terminal> starts,
                      std::span<const Terminal> goals, const Vec2& goal, Result& result) {
  const auto end = static_cast<VertexId>(graph.vertices().size());  // stands for the goal itself
  cost_m_.resize(end + 1);
  parent_.assign(end + 1, kUnseen);
  heap_.clear();
  expanded_ = 0;
  for (const Terminal& start : starts) offer(graph, goal, start.vertex, start.cost_m, -1);
  while (!heap_.empty()) {
    const Entry top = pop();
    if (top.cost_m > cost_m_[top.vertex]) continue;
    if (top.vertex == end) break;
    ++expanded_;
    for (const auto& [v, length_m] : graph.neighbours(top.vertex))
      offer(graph, goal, v, top.cost_m + length_m, top.vertex);
    for (const Terminal& each : goals)
      if (each.vertex == top.vertex) offer(graph, goal, end, top.cost_m + each.cost_m, top.vertex);
  }
  if (!reached(end)) return false;

  result.cost_m = cost_m_[end];
  trace(end, result.vertices);
  result.start = cheapest(starts, result.vertices.front());
  result.goal = cheapest(goals, result.vertices.back());
  return true;
}

void GraphSearch::offer(const VoronoiGraph& graph, const Vec2& goal, VertexId v, double cost_m,
                        VertexId parent) {
  if (reached(v) && cost_m >= cost_m_[v]) return;
  parent_[v] = parent;
  cost_m_[v] = cost_m;
  const bool at_goal = static_cast<std::size_t>(v) == graph.vertices().size();
  push(cost_m + (at_goal ? 0 : (graph.vertices()[v] - goal).norm()), cost_m, v);
}

void GraphSearch::trace(VertexId end, std::vector<VertexId>& vertices) const {
  vertices.clear();
  for (VertexId v = parent_[end]; v >= 0; v = parent_[v]) vertices.push_back(v);
  std::reverse(vertices.begin(), vertices.end());
}

void GraphSearch::push(double estimate_m, double cost_m, VertexId v) {
  heap_.push_back({estimate_m, cost_m, v});
  std::push_heap(heap_.begin(), heap_.end(), [](const Entry& a, const Entry& b) {
    return a.estimate_m != b.estimate_m ? a.estimate_m > b.estimate_m : a.vertex > b.vertex;
  });
}

GraphSearch::Entry GraphSearch::pop() {
  std::pop_heap(heap_.begin(), heap_.end(), [](const Entry& a, const Entry& b) {
    return a.estimate_m != b.estimate_m ? a.estimate_m > b.estimate_m : a.vertex > b.vertex;
  });
  const Entry top = heap_.back();
  heap_.pop_back();
  return top;
}

}  // namespace voronaut
