#include "voronaut/benchmarks/suite/shortest_references.h"

#include <stdexcept>

#include "voronaut/environments/shortest_path/shortest_path.h"

namespace voronaut {

ShortestReferences ShortestReferences::exact() { return ShortestReferences(exact_length_m); }

double ShortestReferences::exact_length_m(const Scenario& scenario, double radius_m) {
  const auto path =
      shortest_path(*scenario.world, scenario.start_world, scenario.goal_world, radius_m);
  return path ? path->length_m : kAbsent;
}

void ShortestReferences::add_to(TrialSpec& spec) {
  spec.shortest_length_m = length_m(spec, spec.vehicle.body_radius_m);
  spec.shortest_at_clearance_m = length_m(spec, spec.vehicle.planning_clearance_m);
}

double ShortestReferences::length_m(const TrialSpec& spec, double radius_m) {
  const auto key = std::make_pair(spec.world_id, radius_m);
  const auto found = known_.find(key);
  if (found != known_.end()) return found->second;
  if (const auto failed = failed_.find(key); failed != failed_.end())
    throw std::runtime_error(failed->second);
  try {
    return known_[key] = length_(spec.scenario, radius_m);
  } catch (const std::runtime_error& error) {
    known_.erase(key);
    failed_[key] = error.what();
    throw;
  }
}

}  // namespace voronaut
