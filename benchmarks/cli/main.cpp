#include "voronaut/benchmarks/cli/run_cli.h"

int main(int argc, char** argv) {
  return voronaut::run_cli(argc, argv, voronaut::PlannerCatalog::built_in());
}
