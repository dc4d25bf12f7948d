#include "voronaut/planners/navigation/breadcrumb_trail.h"

namespace voronaut {

void BreadcrumbTrail::extend(const Vec2& p_world) {
  if (crumbs_world_.empty() || (p_world - crumbs_world_.back()).norm() >= kSpacing_m)
    crumbs_world_.push_back(p_world);
}

void BreadcrumbTrail::backtrack(const Vec2& p_world) {
  // A crumb at a corner that was cut is passed once the one before it is closer.
  while (!crumbs_world_.empty()) {
    const double distance_m = (p_world - crumbs_world_.back()).norm();
    const bool passed = crumbs_world_.size() > 1 &&
                        (p_world - crumbs_world_[crumbs_world_.size() - 2]).norm() <= distance_m;
    if (distance_m >= kSpacing_m && !passed) return;
    crumbs_world_.pop_back();
  }
}

Path BreadcrumbTrail::path_back(const Vec2& p_world, double length_m) const {
  std::vector<Vec2> points = {p_world};
  double so_far_m = 0;
  for (auto crumb = crumbs_world_.rbegin(); crumb != crumbs_world_.rend() && so_far_m < length_m;
       ++crumb) {
    so_far_m += (*crumb - points.back()).norm();
    points.push_back(*crumb);
  }
  return Path::through(points);
}

}  // namespace voronaut
