#include "voronaut/planners/rollout/ray_range.h"

#include <memory>

#include "voronaut/planners/problem/known_geometry.h"
#include "voronaut/planners/problem/planar_state.h"

namespace voronaut {

namespace ob = ompl::base;

namespace {

constexpr double kSeenPointRadius_m = 0.05;
constexpr double kExactness_m = 0.01;

// A longer ray never meets less, so the first contact is where bisection ends.
double range_over_points(const ObstacleSnapshot& points, const Vec2& from, const Vec2& direction,
                         double max_range_m) {
  const auto is_free = [&](double range_m) {
    return points.swept_disc_is_clear(from, from + range_m * direction, kSeenPointRadius_m);
  };
  if (is_free(max_range_m)) return max_range_m;
  double free_m = 0;
  double blocked_m = max_range_m;
  while (blocked_m - free_m > kExactness_m) {
    const double middle_m = 0.5 * (free_m + blocked_m);
    (is_free(middle_m) ? free_m : blocked_m) = middle_m;
  }
  return free_m;
}

double range_through_validity(const ob::SpaceInformation& si, ob::State* probe, const Vec2& from,
                              const Vec2& direction, double max_range_m, double resolution_m) {
  for (int i = 1; i * resolution_m < max_range_m; ++i) {
    set_position(*si.getStateSpace(), probe, from + i * resolution_m * direction);
    // Bounds first: a checker may read a table that ends there.
    if (!si.satisfiesBounds(probe)) return max_range_m;
    if (!si.isValid(probe)) return i * resolution_m;
  }
  return max_range_m;
}

}  // namespace

RayRange ray_range(const ob::SpaceInformationPtr& si, const ob::State* reference,
                   double resolution_m) {
  const auto* geometry = dynamic_cast<const KnownGeometry*>(si->getStateValidityChecker().get());
  if (geometry) {
    return [geometry](const Vec2& from, const Vec2& direction, double max_range_m) {
      return range_over_points(geometry->known_obstacles(), from, direction, max_range_m);
    };
  }
  const std::shared_ptr<ob::State> probe(si->cloneState(reference),
                                         [si](ob::State* state) { si->freeState(state); });
  return [si, probe, resolution_m](const Vec2& from, const Vec2& direction, double max_range_m) {
    return range_through_validity(*si, probe.get(), from, direction, max_range_m, resolution_m);
  };
}

void sense(const RayRange& range, Scan& scan) {
  scan.range_m.resize(scan.beams->direction_sensor.size());
  for (std::size_t i = 0; i < scan.size(); ++i)
    scan.range_m[i] = range(scan.sensor_world.p_world, scan.direction_world(i), scan.max_range_m);
}

}  // namespace voronaut
