#pragma once

#include <functional>
#include <vector>

#include "voronaut/environments/random.h"
#include "voronaut/environments/scenario/scenario_spec.h"
#include "voronaut/environments/sensing/range_finder.h"
#include "voronaut/planners/catalog/catalog.h"
#include "voronaut/planners/mapping/obstacle_base.h"
#include "voronaut/planners/problem/problem.h"

namespace voronaut::micro {

// The replans of a flight without dynamics: a point moves along VoronoiRoadmap's paths through a
// world it discovers, one scan every 0.125 m (2.5 m/s at 20 Hz), looking where it goes, and plans
// anew when a newly seen point makes the rest of its path too narrow. Whoever is measured is asked
// the same questions on the same map.
class ReplanCourse {
 public:
  // The world of generator `family` (YAML, as in a suite) for this seed.
  ReplanCourse(const std::string& family, std::uint64_t seed);

  // Calls `asked(obstacles, p)` at every replan until the goal is reached or no path is left; false
  // in the latter case.
  using Asked = std::function<void(const ObstacleSnapshot& obstacles, const Vec2& p)>;
  bool fly(const PlannerCatalog& planners, const Asked& asked) const;

  const ProblemConfig& problem() const { return problem_; }

 private:
  void sense(const Vec2& p, const Vec2& heading, ObstacleBase& map) const;

  Scenario scenario_;
  ProblemConfig problem_;
  RangeFinder range_finder_{RangeFinderConfig{}};
};

}  // namespace voronaut::micro
