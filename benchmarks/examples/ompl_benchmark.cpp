#include <iostream>

#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/tools/benchmark/Benchmark.h>

#include "voronaut/planners/catalog/catalog.h"

namespace ob = ompl::base;

// Our planners in OMPL's own benchmark: a disc near the middle of a square, known to all of them
// through a validity checker alone.
int main() {
  auto space = std::make_shared<ob::RealVectorStateSpace>(2);
  space->setBounds(-5, 5);
  ompl::geometric::SimpleSetup setup(space);
  setup.setStateValidityChecker([](const ob::State* state) {
    const auto* p = state->as<ob::RealVectorStateSpace::StateType>();
    const double dx = p->values[0] - 0.5;
    return dx * dx + p->values[1] * p->values[1] > 1;
  });
  ob::ScopedState<> start(space), goal(space);
  start[0] = start[1] = -4;
  goal[0] = goal[1] = 4;
  setup.setStartAndGoalStates(start, goal, 0.2);

  const auto planners = voronaut::PlannerCatalog::built_in();
  ompl::tools::Benchmark benchmark(setup, "disc");
  for (const char* name : {"VoronoiRoadmap", "ReactiveVoronoi", "PotentialField", "RRTConnect"}) {
    const auto planner = planners.find(name)->make(setup.getSpaceInformation());
    if (planner->params().hasParam("preset")) planner->params().setParam("preset", "repaired");
    benchmark.addPlanner(planner);
  }
  benchmark.benchmark(ompl::tools::Benchmark::Request(2.0, 512.0, 1, 0.01, false));
  bool all_solved = true;
  for (const auto& planner : benchmark.getRecordedExperimentData().planners) {
    for (const auto& run : planner.runs) {
      std::cout << planner.name << " solved " << run.at("solved BOOLEAN") << "\n";
      all_solved = all_solved && run.at("solved BOOLEAN") == "1";
    }
  }
  return all_solved ? 0 : 1;
}
