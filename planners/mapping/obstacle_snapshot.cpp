#include "voronaut/planners/mapping/obstacle_snapshot.h"

#include <cmath>

#include "voronaut/planners/mapping/obstacle_base.h"
#include "voronaut/planners/mapping/points/require.h"

namespace voronaut {

std::uint64_t ObstacleSnapshot::version() const { return version_; }

std::span<const Vec2> ObstacleSnapshot::points() const {
  if (base_ == nullptr) return {};
  return base_->points_.points();
}

std::span<const Vec2> ObstacleSnapshot::points_since(std::uint64_t version) const {
  if (base_ == nullptr) return {};
  require(version <= version_, "ObstacleSnapshot::points_since: a version of the future");
  return points().subspan(base_->points_at_version_[version]);
}

std::size_t ObstacleSnapshot::cluster_count() const {
  return base_ == nullptr ? 0 : base_->clusters_.living();
}

std::vector<ClusterId> ObstacleSnapshot::clusters() const {
  if (base_ == nullptr) return {};
  return base_->clusters_.living_ids();
}

ClusterId ObstacleSnapshot::cluster_of(PointId id) const { return base_->clusters_.cluster_of(id); }

std::vector<PointId> ObstacleSnapshot::members(ClusterId id) const {
  return base_->clusters_.members(id);
}

PointId ObstacleSnapshot::first_stored(ClusterId id) const {
  return base_->clusters_.first_stored(id);
}

PointId ObstacleSnapshot::last_stored(ClusterId id) const {
  return base_->clusters_.last_stored(id);
}

std::vector<Vec2> ObstacleSnapshot::hull(ClusterId id) const {
  return base_->clusters_.hull(id, points());
}

std::optional<PointId> ObstacleSnapshot::nearest(const Vec2& p, double within_m) const {
  if (base_ == nullptr) return std::nullopt;
  const PointId id = base_->points_.nearest(p, within_m);
  if (id == PointIndex::kNone) return std::nullopt;
  return id;
}

bool ObstacleSnapshot::disc_is_clear(const Vec2& p, double radius_m) const {
  return base_ == nullptr || base_->points_.is_clear(p, radius_m);
}

bool ObstacleSnapshot::swept_disc_is_clear(const Vec2& a, const Vec2& b, double radius_m) const {
  return base_ == nullptr || base_->points_.is_clear(a, b, radius_m);
}

void ObstacleSnapshot::expect_checks(double radius_m) const {
  if (base_ != nullptr) base_->points_.expect_checks(radius_m);
}

double ObstacleSnapshot::segment_clearance_m(const Vec2& a, const Vec2& b, double within_m) const {
  if (base_ == nullptr) return within_m;
  const double clearance_sq = base_->points_.distance_sq(a, b, within_m);
  return clearance_sq < within_m * within_m ? std::sqrt(clearance_sq) : within_m;
}

std::shared_ptr<const ObstacleBase> ObstacleSnapshot::freeze() const {
  return base_ == nullptr ? nullptr : std::make_shared<const ObstacleBase>(*base_);
}

}  // namespace voronaut
