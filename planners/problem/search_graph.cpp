#include "voronaut/planners/problem/search_graph.h"

#include <algorithm>
#include <set>
#include <utility>

#include <ompl/base/PlannerData.h>

#include "voronaut/planners/problem/planar_state.h"

namespace voronaut {
namespace ob = ompl::base;

std::vector<Segment> search_graph(const ob::Planner& planner, const ob::StateSpace& space) {
  ob::PlannerData data(planner.getSpaceInformation());
  planner.getPlannerData(data);
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
      if (from != to && seen.insert(std::minmax(from, to)).second)
        edges.push_back({place(from), place(to)});
    }
  }
  return edges;
}

}  // namespace voronaut
