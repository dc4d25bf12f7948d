#pragma once

#include "voronaut/benchmarks/trial/disturbance_config.h"
#include "voronaut/benchmarks/trial/loop_config.h"
#include "voronaut/environments/sensing/range_finder.h"
#include "voronaut/planners/mapping/obstacle_base.h"
#include "voronaut/planners/navigation/declared_errors.h"
#include "voronaut/planners/navigation/navigation_config.h"
#include "voronaut/planners/problem/planning_budget.h"

namespace voronaut {

// How a trial is flown, whoever plans and whatever flies: the sections that a suite sets for all
// of its trials. A new section is one member and one line.
struct FlightConfig {
  RangeFinderConfig range_finder;
  ObstacleBaseConfig mapping;
  NavigationConfig navigation;
  LoopConfig loop;
  PlanningBudget budget;
  DisturbanceConfig disturbances;
  DeclaredErrors declared_errors;

  template <class Visitor>
  void visit(Visitor& v) {
    v.section("range_finder", range_finder, "What the vehicle sees by");
    v.section("mapping", mapping, "How returns become obstacles");
    v.section("navigation", navigation, "The executive's policies; a planner may have its own");
    v.section("loop", loop, "Clocks and verdicts, in simulated time");
    v.section("budget", budget, "What one solve may spend");
    v.section("disturbances", disturbances, "What happens otherwise than navigation assumes");
    v.section("declared_errors", declared_errors, "What navigation is told of that");
  }
};

}  // namespace voronaut
