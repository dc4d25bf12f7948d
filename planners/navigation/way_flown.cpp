#include "voronaut/planners/navigation/way_flown.h"

namespace voronaut {

void WayFlown::go_on(const Vec2& p_world) {
  if (marks_world_.empty() || (p_world - marks_world_.back()).norm() >= kSpacing_m)
    marks_world_.push_back(p_world);
}

void WayFlown::go_back(const Vec2& p_world) {
  // A mark at a corner that was cut is passed once the one before it is closer.
  while (!marks_world_.empty()) {
    const double distance_m = (p_world - marks_world_.back()).norm();
    const bool passed = marks_world_.size() > 1 &&
                        (p_world - marks_world_[marks_world_.size() - 2]).norm() <= distance_m;
    if (distance_m >= kSpacing_m && !passed) return;
    marks_world_.pop_back();
  }
}

Path WayFlown::back_from(const Vec2& p_world, double leg_m) const {
  std::vector<Vec2> points = {p_world};
  double length_m = 0;
  for (auto mark = marks_world_.rbegin(); mark != marks_world_.rend() && length_m < leg_m; ++mark) {
    length_m += (*mark - points.back()).norm();
    points.push_back(*mark);
  }
  return Path::through(points);
}

}  // namespace voronaut
