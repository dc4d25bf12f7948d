#pragma once

#include <cstdint>
#include <string_view>

#include "voronaut/planners/catalog/catalog.h"
#include "voronaut/planners/navigation/navigation_config.h"
#include "voronaut/planners/navigation/path_tracker.h"
#include "voronaut/planners/problem/known_geometry.h"

namespace voronaut {

enum class ReplanReason {
  none,         // the plan still holds
  every_scan,   // a reactive planner is asked after each scan
  no_plan,      // there is none yet, or the last request found none and something has changed
  invalidated,  // a newly seen point comes too close to what remains of the path
  off_path,     // the vehicle is too far from its path
};

std::string_view to_string(ReplanReason reason);

// Decides when to ask the planner again. With unknown counted as free, a newly seen point can only
// make paths longer, so a path that still holds is still the planner's best answer.
class ReplanPolicy {
 public:
  ReplanPolicy(const NavigationConfig& config, const PlannerTraits& traits)
      : config_(config), traits_(traits) {}

  // `geometry` must already look at the current belief, relaxed around the vehicle.
  ReplanReason reason(const PathTracker& tracker, const KnownGeometry& geometry,
                      const Eigen::Vector2d& p_world, double now_s);

 private:
  NavigationConfig config_;
  PlannerTraits traits_;
  std::uint64_t checked_version_ = 0;
  double asked_s_ = -1e9;
};

// True if the rest of the path, from the vehicle on, keeps its clearance to all known points.
bool rest_is_clear(const PathTracker& tracker, const KnownGeometry& geometry,
                   const Eigen::Vector2d& p_world);

}  // namespace voronaut
