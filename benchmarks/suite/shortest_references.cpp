#include "voronaut/benchmarks/suite/shortest_references.h"

#include "voronaut/environments/shortest_path/shortest_path.h"

namespace voronaut {

ShortestReferences ShortestReferences::exact() {
  return ShortestReferences([](const Scenario& scenario, double radius_m) {
    const auto path =
        shortest_path(*scenario.world, scenario.start_world, scenario.goal_world, radius_m);
    return path ? path->length_m : kAbsent;
  });
}

void ShortestReferences::add_to(TrialSpec& spec) {
  spec.shortest_length_m = length_m(spec, spec.vehicle.body_radius_m);
  spec.shortest_at_clearance_m = length_m(spec, spec.vehicle.planning_clearance_m);
}

double ShortestReferences::length_m(const TrialSpec& spec, double radius_m) {
  const auto key = std::make_pair(spec.world_id, radius_m);
  const auto found = known_.find(key);
  if (found != known_.end()) return found->second;
  return known_[key] = length_(spec.scenario, radius_m);
}

}  // namespace voronaut
