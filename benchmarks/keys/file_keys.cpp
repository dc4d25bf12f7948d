#include "voronaut/benchmarks/keys/file_keys.h"

#include <variant>

#include "voronaut/benchmarks/suite/entry_keys.h"
#include "voronaut/benchmarks/suite/suite_config.h"
#include "voronaut/environments/formats/query_selection.h"
#include "voronaut/environments/generators/world_generators.h"
#include "voronaut/environments/scenario_files/scenario_keys.h"
#include "voronaut/planners/catalog/parameter_declaration.h"
#include "voronaut/planners/catalog/parameter_range.h"

namespace voronaut {
namespace {

using Kind = KeyFact::Kind;

template <class... Configs>
std::vector<KeyFact> facts_of(const std::variant<Configs...>& config) {
  return std::visit([](const auto& chosen) { return key_facts(chosen); }, config);
}

Kind kind_of(const ParameterRange& range) {
  switch (range.kind) {
    case ParameterRange::Kind::flag:
      return Kind::flag;
    case ParameterRange::Kind::number:
      return Kind::number;
    case ParameterRange::Kind::whole_number:
      return Kind::whole_number;
    case ParameterRange::Kind::text:
      break;
  }
  return range.options.empty() ? Kind::text : Kind::choice;
}

// OMPL's defaults of these are the processor's threads: not a fact of the program.
bool follows_the_machine(const std::string& key) {
  return key == "num_planners" || key == "num_threads";
}

KeyFact parameter_fact(const ompl::base::GenericParam& param) {
  const ParameterRange range(param);
  KeyFact fact;
  fact.key = param.getName();
  fact.kind = kind_of(range);
  fact.lo = range.low;
  fact.hi = range.high;
  if (fact.kind == Kind::choice) fact.choices = range.options;
  if (!follows_the_machine(fact.key)) fact.default_text = param.getValue();
  if (fact.kind == Kind::flag) fact.default_text = fact.default_text == "1" ? "true" : "false";
  if (const auto* described = dynamic_cast<const ParameterSentence*>(&param))
    fact.sentence = described->sentence;
  return fact;
}

}  // namespace

std::vector<KeyFact> parameters_of(const PlannerEntry& entry) {
  PlanningProblem problem({.bounds_world = {Vec2(-1, -1), Vec2(1, 1)}});
  const auto planner = entry.make(problem.space_information());
  std::vector<KeyFact> facts;
  for (const auto& [name, param] : planner->params().getParams())
    facts.push_back(parameter_fact(*param));
  return facts;
}

namespace {

void add_scenario_keys(FileKeys& keys) {
  keys.task = key_facts(TaskConfig{});
  keys.file = key_facts(ScenarioFileKeys{});
  keys.world = key_facts(WorldKeys{});
  keys.world_file = key_facts(WorldFileKeys{});
  keys.generator = key_facts(GeneratorKeys{});
  keys.data_set = key_facts(DataSetKeys{});
  for (const std::string& name : WorldGenerator::names())
    keys.generators.push_back({name, WorldGenerator::keys(name)});
  keys.foreign_options = key_facts(ForeignOptions{});
  keys.query_file = key_facts(QueryFileKeys{});
  keys.query_selection = key_facts(QuerySelection{});
}

}  // namespace

FileKeys file_keys(const PlannerCatalog& planners) {
  FileKeys keys;
  keys.suite = key_facts(SuiteConfig{});
  keys.vehicle = key_facts(VehicleEntryKeys{});
  keys.regulator = key_facts(RegulatorEntryKeys{});
  keys.planner = key_facts(PlannerEntryKeys{});
  keys.criterion = key_facts(AcceptanceCriterion{});
  keys.sweep_range = key_facts(SweepRange{});
  for (const std::string& name : vehicle_names()) {
    keys.vehicle_params.push_back({name, key_facts(find_vehicle(name))});
    keys.vehicle_models.push_back({name, facts_of(find_vehicle(name).model)});
  }
  for (const std::string& name : regulator_names())
    keys.regulators.push_back({name, facts_of(find_regulator(name))});
  for (const PlannerEntry* entry : planners.entries())
    keys.planners.push_back({entry->name, parameters_of(*entry)});
  add_scenario_keys(keys);
  return keys;
}

}  // namespace voronaut
