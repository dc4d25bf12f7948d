#include "voronaut/planners/mapping/obstacle_snapshot.h"

#include <algorithm>
#include <cmath>

#include "voronaut/planners/mapping/obstacle_base.h"

namespace voronaut {

std::uint64_t ObstacleSnapshot::version() const { return version_; }

std::span<const Vec2> ObstacleSnapshot::points() const {
  if (base_ == nullptr) return {};
  return base_->points_;
}

std::span<const Vec2> ObstacleSnapshot::points_since(std::uint64_t version) const {
  if (base_ == nullptr) return {};
  return points().subspan(base_->points_at_version_.at(version));
}

std::size_t ObstacleSnapshot::cluster_count() const { return clusters().size(); }

std::vector<ClusterId> ObstacleSnapshot::clusters() const {
  std::vector<ClusterId> living;
  if (base_ == nullptr) return living;
  for (ClusterId id = 0; id < base_->clusters_.size(); ++id) {
    if (!base_->clusters_[id].members.empty()) living.push_back(id);
  }
  return living;
}

ClusterId ObstacleSnapshot::cluster_of(PointId id) const { return base_->label_.at(id); }

std::vector<PointId> ObstacleSnapshot::members(ClusterId id) const {
  return base_->clusters_.at(id).members;
}

PointId ObstacleSnapshot::first_stored(ClusterId id) const {
  return base_->clusters_.at(id).members.front();
}

PointId ObstacleSnapshot::last_stored(ClusterId id) const {
  return base_->clusters_.at(id).members.back();
}

std::span<const Vec2> ObstacleSnapshot::hull(ClusterId id) const {
  return base_->clusters_.at(id).hull;
}

std::optional<PointId> ObstacleSnapshot::nearest(const Vec2& p, double within_m) const {
  std::optional<PointId> nearest;
  double nearest_sq = within_m * within_m;
  const std::span<const Vec2> all = points();
  for (PointId id = 0; id < all.size(); ++id) {
    const double distance_sq = (all[id] - p).squaredNorm();
    if (distance_sq > nearest_sq || (nearest && distance_sq == nearest_sq)) continue;
    nearest = id;
    nearest_sq = distance_sq;
  }
  return nearest;
}

bool ObstacleSnapshot::disc_is_clear(const Vec2& p, double radius_m) const {
  return swept_disc_is_clear(p, p, radius_m);
}

bool ObstacleSnapshot::swept_disc_is_clear(const Vec2& a, const Vec2& b, double radius_m) const {
  return segment_clearance_m(a, b, radius_m) >= radius_m;
}

double ObstacleSnapshot::segment_clearance_m(const Vec2& a, const Vec2& b, double within_m) const {
  double clearance_sq = within_m * within_m;
  for (const Vec2& p : points()) {
    clearance_sq = std::min(clearance_sq, (p - closest_point(p, {a, b})).squaredNorm());
  }
  return clearance_sq < within_m * within_m ? std::sqrt(clearance_sq) : within_m;
}

std::shared_ptr<const ObstacleBase> ObstacleSnapshot::freeze() const {
  return base_ == nullptr ? nullptr : std::make_shared<const ObstacleBase>(*base_);
}

}  // namespace voronaut
