#pragma once

#include <vector>

#include <ompl/base/Planner.h>

#include "voronaut/environments/shapes/geometry.h"

namespace voronaut {

// What a planner's latest solve looked at, in the plane: the edges of its roadmap or of its trees,
// each once, in the planner's order. For pictures; nothing decides on it. `space` is the problem's.
// Empty for a planner that tells nothing, or throws when it is asked; without edges to what is no
// place. O(edges log edges).
std::vector<Segment> search_graph(const ompl::base::Planner& planner,
                                  const ompl::base::StateSpace& space);

}  // namespace voronaut
