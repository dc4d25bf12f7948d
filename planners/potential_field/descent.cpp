#include "voronaut/planners/potential_field/descent.h"

#include <algorithm>
#include <memory>
#include <numbers>

#include "voronaut/planners/problem/known_geometry.h"
#include "voronaut/planners/problem/planar_state.h"

namespace voronaut {

namespace ob = ompl::base;

namespace {

// A step must gain at least this part of what the slope promises (Armijo's condition), or a descent
// across a narrow valley would take for ever.
constexpr double kLeastGain = 1e-3;

}  // namespace

Descent::Descent(const ob::SpaceInformationPtr& si, const PotentialConfig& potential,
                 const DescentConfig& config, const ob::State* start, const ob::State* goal)
    : Rollout(si, start, goal),
      potential_(potential),
      config_(config),
      sensed_(ObstacleBaseConfig{}) {
  const auto* known = dynamic_cast<const KnownGeometry*>(si->getStateValidityChecker().get());
  if (known) {
    obstacles_ = known->known_obstacles();
    return;
  }
  ray_range_ = ray_range(si, start, config.ray_resolution_m);
  scan_.max_range_m = potential.influence_distance_m;
  scan_.beams = std::make_shared<BeamFan>(
      BeamFan::spread(2 * std::numbers::pi, static_cast<std::size_t>(config.sensing_rays)));
}

void Descent::look_around() {
  scan_.sensor_world.p_world = p_world();
  sense(ray_range_, scan_);
  sensed_.update(scan_);
  obstacles_ = sensed_.snapshot();
}

void Descent::find_closest(const Vec2& p) {
  closest_.clear();
  closest_cluster_.clear();
  const double influence_sq = potential_.influence_distance_m * potential_.influence_distance_m;
  const std::span<const Vec2> points = obstacles_.points();
  for (PointId id = 0; id < points.size(); ++id) {
    const double distance_sq = (points[id] - p).squaredNorm();
    if (distance_sq > influence_sq) continue;
    const ClusterId cluster = obstacles_.cluster_of(id);
    const auto found = std::find(closest_cluster_.begin(), closest_cluster_.end(), cluster);
    if (found == closest_cluster_.end()) {
      closest_cluster_.push_back(cluster);
      closest_.push_back(points[id]);
      continue;
    }
    Vec2& closest = closest_[static_cast<std::size_t>(found - closest_cluster_.begin())];
    if (distance_sq < (closest - p).squaredNorm()) closest = points[id];
  }
}

double Descent::potential_at(const Vec2& p) {
  find_closest(p);
  return total_potential(p, goal_world(), closest_, potential_);
}

bool Descent::step() {
  if (steps_without_progress() >= static_cast<std::size_t>(config_.stall_steps)) return false;
  if (ray_range_) look_around();
  if ((goal_world() - p_world()).norm() <= config_.step_m && arrive()) return true;
  const double here = potential_at(p_world());
  const Vec2 force = total_force(p_world(), goal_world(), closest_, potential_);
  const double slope = force.norm();
  if (slope == 0) return false;
  const Bounds bounds = position_bounds(*space_information()->getStateSpace());
  for (double step_m = config_.step_m; step_m >= config_.smallest_step_m; step_m *= 0.5) {
    const Vec2 next = clamped(p_world() + force * (step_m / slope), bounds);
    if (potential_at(next) <= here - kLeastGain * slope * step_m && move_to(next)) return true;
  }
  return false;
}

}  // namespace voronaut
