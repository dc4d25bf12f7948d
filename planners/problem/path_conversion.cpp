#include "voronaut/planners/problem/path_conversion.h"

#include <ompl/base/SpaceInformation.h>

#include "voronaut/planners/problem/planar_state.h"

namespace voronaut {

std::vector<Vec2> positions_of(const ompl::geometric::PathGeometric& path,
                               const ompl::base::StateSpace& space) {
  std::vector<Vec2> points;
  points.reserve(path.getStateCount());
  for (std::size_t i = 0; i < path.getStateCount(); ++i)
    points.push_back(position_of(space, path.getState(static_cast<unsigned>(i))));
  return points;
}

Path to_path(const ompl::geometric::PathGeometric& path, const ompl::base::StateSpace& space) {
  return Path::through(positions_of(path, space));
}

Path to_path(const ompl::geometric::PathGeometric& path) {
  return to_path(path, *path.getSpaceInformation()->getStateSpace());
}

}  // namespace voronaut
