#pragma once

#include <string>
#include <vector>

#include "voronaut/environments/config/key_facts.h"
#include "voronaut/planners/catalog/catalog.h"

// Everything that suite and scenario files may say, gathered from the visit lists, the catalogues
// and what planners declare.
namespace voronaut {

// Keys that come with a name: of a planner, a regulator, a family of worlds.
struct NamedKeys {
  std::string name;
  std::vector<KeyFact> keys;
};

struct FileKeys {
  std::vector<KeyFact> suite;
  // One entry of each list of a suite.
  std::vector<KeyFact> vehicle, regulator, planner, criterion, sweep_range;
  std::vector<NamedKeys> vehicle_params, vehicle_models, regulators, planners;

  // A scenario, by what its world comes from; each but `file` takes the keys of `task` beside.
  std::vector<KeyFact> task, file, world, world_file, generator, data_set;
  std::vector<NamedKeys> generators;
  std::vector<KeyFact> foreign_options;  // beside world_file and dataset, as the format uses them
  std::vector<KeyFact> query_file;       // of `queries` as a map, beside query_selection
  std::vector<KeyFact> query_selection;
};

// What a planner declares about its parameters. Makes it, in this process.
std::vector<KeyFact> parameters_of(const PlannerEntry& entry);

// Makes each planner once, in this process.
FileKeys file_keys(const PlannerCatalog& planners);

}  // namespace voronaut
