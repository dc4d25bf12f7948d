#include "voronaut/planners/problem/search_graph.h"

#include <algorithm>
#include <exception>
#include <set>
#include <utility>

#include <ompl/base/PlannerData.h>

#include "voronaut/planners/problem/planar_state.h"

namespace voronaut {
namespace ob = ompl::base;

std::vector<Segment> search_graph(const ob::Planner& planner, const ob::StateSpace& space) {
  ob::PlannerData data(planner.getSpaceInformation());
  try {
    planner.getPlannerData(data);
  } catch (const std::exception&) {
    return {};
  }
  const auto place = [&](unsigned vertex) {
    return position_of(space, data.getVertex(vertex).getState());
  };
  std::set<std::pair<unsigned, unsigned>> seen;  // a roadmap tells each edge in both directions
  std::vector<Segment> edges;
  std::vector<unsigned> neighbours;
  for (unsigned from = 0; from < data.numVertices(); ++from) {
    data.getEdges(from, neighbours);
    std::sort(neighbours.begin(), neighbours.end());
    for (const unsigned to : neighbours) {
      if (from == to || !seen.insert(std::minmax(from, to)).second) continue;
      const Segment edge{place(from), place(to)};
      if (edge.a.allFinite() && edge.b.allFinite()) edges.push_back(edge);
    }
  }
  return edges;
}

}  // namespace voronaut
