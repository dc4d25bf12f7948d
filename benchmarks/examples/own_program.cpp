#include "straight_line.h"
#include "voronaut/benchmarks/cli/run_cli.h"

// The program `voronaut` with one planner more: `own_program run straight-line.yaml`.
int main(int argc, char** argv) {
  auto planners = voronaut::PlannerCatalog::built_in();
  planners.add({"StraightLine", "straight to the goal", {}, [](const auto& si) {
                  return std::make_shared<StraightLine>(si);
                }});
  return voronaut::run_cli(argc, argv, planners);
}
