#pragma once

#include <memory>
#include <vector>

#include "voronaut/planners/mapping/obstacle_base.h"

namespace voronaut {

// Places that recovery has declared impassable although no beam found anything there: a layer of
// its own over the obstacle base, for planners only, dropped when planning with it fails. Nothing
// that is proved with it in force is proved.
class VirtualObstacles {
 public:
  void add(const Vec2& p_world) { places_.push_back(p_world); }
  void clear();
  bool empty() const { return places_.empty(); }

  // What planners see: `known` itself while there is no virtual obstacle, else a copy of it with
  // the places as further points. Valid until the next call. O(base) when either has changed.
  ObstacleSnapshot over(const ObstacleSnapshot& known);

 private:
  std::vector<Vec2> places_;
  std::unique_ptr<ObstacleBase> copy_;
  std::uint64_t copied_version_ = 0;
  std::size_t copied_places_ = 0;
};

}  // namespace voronaut
