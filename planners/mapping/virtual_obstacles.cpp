#include "voronaut/planners/mapping/virtual_obstacles.h"

namespace voronaut {

namespace {

// A place as the base takes it: the one return of a beam that points at it from the left.
Scan sight_of(const Vec2& p_world) {
  constexpr double kFrom_m = 0.1;
  Scan scan;
  scan.beams = std::make_shared<BeamFan>(BeamFan::spread(0, 1));
  scan.sensor_world.p_world = p_world - Vec2(kFrom_m, 0);
  scan.max_range_m = 1;
  scan.range_m = {kFrom_m};
  return scan;
}

}  // namespace

void VirtualObstacles::clear() {
  places_.clear();
  copy_.reset();
}

ObstacleSnapshot VirtualObstacles::over(const ObstacleSnapshot& known) {
  const auto base = places_.empty() ? nullptr : known.freeze();
  if (base == nullptr) return known;
  if (copy_ == nullptr || copied_version_ != known.version() || copied_places_ != places_.size()) {
    copy_ = std::make_unique<ObstacleBase>(*base);
    for (const Vec2& place : places_) copy_->update(sight_of(place));
    copied_version_ = known.version();
    copied_places_ = places_.size();
  }
  return copy_->snapshot();
}

}  // namespace voronaut
