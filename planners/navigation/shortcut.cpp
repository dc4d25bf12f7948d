#include "voronaut/planners/navigation/shortcut.h"

namespace voronaut {

Path shortcut(const Path& path, const KnownGeometry& geometry) {
  std::vector<Eigen::Vector2d> corners{path.front()};
  for (const PathSegment& segment : path.segments()) corners.push_back(segment.end);

  std::vector<Eigen::Vector2d> kept{corners.front()};
  for (std::size_t from = 0; from + 1 < corners.size();) {
    std::size_t to = corners.size() - 1;
    while (to > from + 1 && !geometry.motion_is_clear(corners[from], corners[to])) --to;
    kept.push_back(corners[to]);
    from = to;
  }
  return Path::through(kept);
}

}  // namespace voronaut
