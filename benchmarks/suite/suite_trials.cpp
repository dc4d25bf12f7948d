#include "voronaut/benchmarks/suite/suite_trials.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "voronaut/benchmarks/suite/footprint_entry.h"
#include "voronaut/benchmarks/trial/trial_id.h"
#include "voronaut/environments/random.h"

namespace voronaut {

namespace {

std::uint64_t world_seed(const SuiteConfig& suite, const std::string& scenario,
                         std::size_t repetition) {
  return derive_seed(suite.seed, {scenario}, repetition);
}

}  // namespace

SuiteTrials::SuiteTrials(const SuiteConfig& suite, Rehearse rehearse, Shard shard)
    : suite_(suite), rehearse_(std::move(rehearse)), shard_(shard) {
  for (std::size_t scenario = 0; scenario < suite.scenarios.size(); ++scenario) {
    const bool once = suite.repeat == Repeat::random && !suite.scenarios[scenario].random();
    const auto repetitions = static_cast<std::size_t>(once ? 1 : suite.repetitions);
    for (std::size_t i = 0; i < repetitions; ++i) visits_.push_back({scenario, i});
  }
  for (const ScenarioSpec& scenario : suite.scenarios)
    scenario_steps_.push_back(zipped_step(suite.sweep, "scenario", scenario.name()));
  for (const VehicleEntry& vehicle : suite.vehicles)
    vehicle_steps_.push_back(zipped_step(suite.sweep, "vehicle", vehicle.vehicle.name));
  for (const PlannerSpec& planner : suite.planners)
    planner_steps_.push_back(zipped_step(suite.sweep, "planner", planner.label));
  const std::size_t first = visits_.size() * (shard.number - 1) / shard.count;
  std::rotate(visits_.begin(), visits_.begin() + static_cast<std::ptrdiff_t>(first), visits_.end());
}

std::size_t SuiteTrials::in_world() const {
  return suite_.vehicles.size() * suite_.planners.size();
}

std::size_t SuiteTrials::total() const {
  std::vector<std::size_t> in_scenario(suite_.scenarios.size(), 0);
  for (std::size_t s = 0; s < in_scenario.size(); ++s)
    for (std::size_t v = 0; v < suite_.vehicles.size(); ++v)
      for (std::size_t p = 0; p < suite_.planners.size(); ++p)
        in_scenario[s] += meet(s, v, p) ? 1 : 0;
  std::size_t sum = 0;
  for (const Visit& visit : visits_) sum += in_scenario[visit.scenario];
  return sum;
}

const SuiteTrials::Visit& SuiteTrials::visit() const { return visits_[next_ / in_world()]; }

bool SuiteTrials::meet(std::size_t scenario, std::size_t vehicle, std::size_t planner) const {
  std::optional<std::size_t> step;
  for (const auto& own :
       {scenario_steps_[scenario], vehicle_steps_[vehicle], planner_steps_[planner]}) {
    if (own && step && *own != *step) return false;
    if (own) step = own;
  }
  return true;
}

std::optional<PlannedTrial> SuiteTrials::next() {
  while (auto planned = next_of_suite())
    if (shard_.holds(planned->spec.trial_id)) return planned;
  return std::nullopt;
}

std::optional<PlannedTrial> SuiteTrials::next_of_suite() {
  for (; next_ < visits_.size() * in_world(); ++next_) {
    const std::size_t vehicle = next_ % in_world() / suite_.planners.size();
    const std::size_t planner = next_ % suite_.planners.size();
    if (vehicle == 0 && planner == 0) enter_world();
    if (!meet(visit().scenario, vehicle, planner)) continue;
    PlannedTrial planned = trial(suite_.vehicles[vehicle], suite_.planners[planner]);
    ++next_;
    return planned;
  }
  return std::nullopt;
}

void SuiteTrials::enter_world() {
  const auto [scenario, repetition] = visit();
  const ScenarioSpec& source = suite_.scenarios[scenario];
  if (made_ == scenario && !source.random()) return;
  made_ = scenario;
  make_world(source, world_seed(suite_, source.name(), repetition));
  if (refusal_.empty()) return;
  scenario_ = {};
  scenario_.name = source.name();
  scenario_.group = source.group();
  world_id_.clear();
}

void SuiteTrials::make_world(const ScenarioSpec& source, std::uint64_t seed) {
  refusal_.clear();
  if (rehearse_ && source.random()) refusal_ = rehearse_([&] { source.instantiate(seed); });
  if (!refusal_.empty()) return;
  try {
    scenario_ = source.instantiate(seed);
    world_id_ = world_id(scenario_);
  } catch (const std::runtime_error&) {  // its text names files: not for a deterministic column
    refusal_ = "the generator drew no admissible world";
  }
}

PlannedTrial SuiteTrials::trial(const VehicleEntry& vehicle, const PlannerSpec& planner) const {
  const std::size_t repetition = visit().repetition;
  TrialSpec spec;
  spec.suite = suite_.name;
  spec.kind = suite_.kind;
  spec.scenario = scenario_;
  if (!mobility_of(vehicle.vehicle).flies)
    spec.scenario.start_height_m = spec.scenario.cruise_height_m = 0;
  spec.world_id = world_id_;
  spec.vehicle = vehicle.vehicle;
  if (vehicle.footprint_of_scenario) take_footprint(spec.scenario, spec.vehicle);
  spec.regulator_name = vehicle.regulator_name;
  spec.regulator = vehicle.regulator;
  spec.planner = planner;
  spec.flight = flight_of(suite_, vehicle, planner);
  spec.repetition = static_cast<std::int64_t>(repetition);
  spec.planner_seed = derive_seed(suite_.seed, {scenario_.name, planner.label}, repetition);
  spec.trial_id = trial_id(spec);
  return {std::move(spec), refusal_};
}

void SuiteTrials::check_worlds(const SuiteConfig& suite) {
  for (const ScenarioSpec& source : suite.scenarios)
    source.instantiate(world_seed(suite, source.name(), 0));
}

}  // namespace voronaut
