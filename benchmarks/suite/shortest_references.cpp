#include "voronaut/benchmarks/suite/shortest_references.h"

#include <cmath>
#include <stdexcept>

#include "voronaut/environments/polygons/polygon_areas.h"
#include "voronaut/environments/shortest_path/narrowest_passage.h"
#include "voronaut/environments/shortest_path/shortest_path.h"

namespace voronaut {

namespace {

// computed[key], computed now if it is not there; what failed once fails again with the same words.
template <class Key, class Value, class Compute>
Value once(std::map<Key, Value>& computed, std::map<Key, std::string>& failed, const Key& key,
           Compute&& compute) {
  if (const auto found = computed.find(key); found != computed.end()) return found->second;
  if (const auto why = failed.find(key); why != failed.end()) throw std::runtime_error(why->second);
  try {
    return computed.emplace(key, compute()).first->second;
  } catch (const std::runtime_error& error) {
    failed[key] = error.what();
    throw;
  }
}

}  // namespace

ShortestReferences ShortestReferences::exact() {
  return ShortestReferences(exact_length_m, exact_difficulty);
}

double ShortestReferences::exact_length_m(const Scenario& scenario, double radius_m) {
  const auto path =
      shortest_path(*scenario.world, scenario.start_world, scenario.goal_world, radius_m);
  return path ? path->length_m : kAbsent;
}

WorldDifficulty ShortestReferences::exact_difficulty(const Scenario& scenario) {
  const World& world = *scenario.world;
  const double passage_m = narrowest_passage_m(world, scenario.start_world, scenario.goal_world);
  return {free_share(world.bounds(), world.shapes()), std::isinf(passage_m) ? kAbsent : passage_m};
}

void ShortestReferences::add_to(TrialSpec& spec) {
  spec.answer = answer_of(spec);
  spec.shortest_length_m = length_m(spec, spec.vehicle.inscribed_radius_m());
  spec.shortest_at_clearance_m = length_m(spec, spec.vehicle.planning_clearance_m);
  const WorldDifficulty difficulty = difficulty_of(spec);
  spec.free_share = difficulty.free_share;
  spec.narrowest_passage_m = difficulty.narrowest_passage_m;
}

double ShortestReferences::length_m(const TrialSpec& spec, double radius_m) {
  return once(known_, failed_, std::make_pair(spec.world_id, radius_m),
              [&] { return length_(spec.scenario, radius_m); });
}

StepAnswer ShortestReferences::answer_of(const TrialSpec& spec) {
  if (spec.kind != TrialKind::flown) return spec.answer;
  const auto found = answers_.find(spec.vehicle.name);
  if (found != answers_.end()) return found->second;
  const double period_s = spec.flight.loop.vehicle_period_s;
  return answers_[spec.vehicle.name] = step_answer(spec.vehicle, spec.regulator, period_s);
}

WorldDifficulty ShortestReferences::difficulty_of(const TrialSpec& spec) {
  if (!difficulty_) return {};
  return once(difficulties_, not_rated_, spec.world_id, [&] { return difficulty_(spec.scenario); });
}

}  // namespace voronaut
