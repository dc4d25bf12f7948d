#include <algorithm>
#include <iomanip>
#include <ostream>
#include <stdexcept>

#include "voronaut/benchmarks/cli/commands.h"
#include "voronaut/benchmarks/cli/dry_run.h"
#include "voronaut/benchmarks/cli/named_scenarios.h"
#include "voronaut/benchmarks/isolation/child_process.h"
#include "voronaut/benchmarks/keys/file_keys.h"
#include "voronaut/benchmarks/responses/response_tables.h"
#include "voronaut/benchmarks/suite/shipped_files.h"
#include "voronaut/benchmarks/suite/suite_config.h"
#include "voronaut/benchmarks/suite/suite_trials.h"
#include "voronaut/environments/config/key_facts.h"
#include "voronaut/environments/config/nearest_name.h"
#include "voronaut/environments/formats/data_sets.h"
#include "voronaut/environments/formats/foreign_formats.h"
#include "voronaut/environments/generators/world_generators.h"
#include "voronaut/environments/scenario_files/scenario_reader.h"
#include "voronaut/planners/problem/problem.h"
#include "voronaut/reports/summary/results_page.h"
#include "voronaut/reports/summary/text_table.h"

namespace voronaut {

namespace {

using ListedRows = std::vector<std::pair<std::string, std::string>>;

ListedRows rows_of(const std::vector<ShippedFile>& files) {
  ListedRows rows;
  for (const ShippedFile& file : files) rows.emplace_back(file.name, file.summary);
  return rows;
}

ListedRows vehicle_rows() {
  ListedRows rows;
  for (const std::string& name : vehicle_names()) {
    const VehicleSpec spec = find_vehicle(name);
    rows.emplace_back(name, "body radius " + number_text(spec.body_radius_m) + " m, clearance " +
                                number_text(spec.planning_clearance_m) + " m, up to " +
                                number_text(spec.limits.max_speed_m_s) + " m/s, regulator " +
                                spec.regulator);
  }
  return rows;
}

ListedRows format_rows() {
  ListedRows rows;
  for (const ForeignFormat& format : foreign_formats())
    rows.emplace_back(format.name, format.summary);
  return rows;
}

// Names and what is the same of all of them.
ListedRows rows_of(const std::vector<std::string>& names, const std::string& summary) {
  ListedRows rows;
  for (const std::string& name : names) rows.emplace_back(name, summary);
  return rows;
}

std::string_view to_text(Reproducible reproducible) {
  switch (reproducible) {
    case Reproducible::unknown:
      return "unknown";
    case Reproducible::no:
      return "no";
    case Reproducible::everywhere:
      break;
  }
  return "yes";
}

// In a process of its own: a plugin's planner may fail as soon as it is made.
std::string is_anytime(const PlannerEntry& entry) {
  const ChildReport report = run_in_child(
      [&]() -> std::string {
        PlanningProblem problem({.bounds_world = {Vec2(-1, -1), Vec2(1, 1)}});
        return entry.make(problem.space_information())->getSpecs().optimizingPaths ? "yes" : "no";
      },
      {.memory_mb = 1024, .cpu_s = 10, .wall_s = 20});
  return report.end == ChildReport::End::finished ? report.output : "fails";
}

// `reproducible`: the same seed and counted budget give the same bits. `anytime`: improves what it
// has until its budget is spent, unless the suite says `stop: first`.
TextTable planner_table(const PlannerCatalog& planners) {
  using Align = TextTable::Align;
  TextTable table{{{"planner", Align::left},
                   {"reproducible", Align::left},
                   {"anytime", Align::left},
                   {"plans", Align::left},
                   {"what it is", Align::left}},
                  {}};
  for (const PlannerEntry* entry : planners.entries()) {
    table.rows.push_back(
        {entry->name, std::string(to_text(entry->traits.reproducible)), is_anytime(*entry),
         entry->traits.plans_on_every_scan ? "every scan" : "when needed", entry->summary});
  }
  return table;
}

ListedRows rows_of(const std::string& what) {
  if (what == "vehicles") return vehicle_rows();
  if (what == "regulators") return rows_of(regulator_names(), "");
  if (what == "generators")
    return rows_of(WorldGenerator::names(), "random worlds, `generator: {name: ...}`");
  if (what == "datasets")
    return rows_of(data_set_names(), "`dataset: ...`, from --data or VORONAUT_DATA");
  if (what == "formats") return format_rows();
  return rows_of(shipped_files(what));
}

std::vector<std::string> names_of(const PlannerCatalog& planners) {
  std::vector<std::string> names;
  for (const PlannerEntry* entry : planners.entries()) names.push_back(entry->name);
  return names;
}

TextTable parameter_table(const std::vector<KeyFact>& facts) {
  using Align = TextTable::Align;
  TextTable table{{{"parameter", Align::left},
                   {"allowed", Align::left},
                   {"unit", Align::left},
                   {"default", Align::left},
                   {"", Align::left}},
                  {}};
  for (const KeyFact& fact : facts)
    table.rows.push_back(
        {fact.key, allowed_text(fact), unit_of_key(fact.key), fact.default_text, fact.sentence});
  return table;
}

template <class... Configs>
std::string variant_parameters(const std::variant<Configs...>& config) {
  return parameter_table(std::visit([](const auto& c) { return key_facts(c); }, config)).aligned();
}

std::string parameters_of_vehicle(const std::string& name) {
  const VehicleSpec spec = find_vehicle(name);
  return "params\n" + parameter_table(key_facts(spec)).aligned() + "\nmodel\n" +
         variant_parameters(spec.model) + "\nregulator " + spec.regulator + ", params\n" +
         variant_parameters(find_regulator(spec.regulator));
}

// What one planner, vehicle, regulator or family of worlds may be told.
std::string parameters_text(const ListOptions& options, const PlannerCatalog& planners) {
  const auto require = [&](const std::vector<std::string>& names) {
    if (std::find(names.begin(), names.end(), options.name) == names.end())
      throw std::invalid_argument("no " + options.what.substr(0, options.what.size() - 1) + " " +
                                  in_quotes(options.name) + allowed_names(options.name, names));
  };
  if (options.what == "planners") {
    require(names_of(planners));
    return parameter_table(parameters_of(*planners.find(options.name))).aligned();
  }
  if (options.what == "vehicles") {
    require(vehicle_names());
    return parameters_of_vehicle(options.name);
  }
  if (options.what == "regulators") {
    require(regulator_names());
    return variant_parameters(find_regulator(options.name));
  }
  if (options.what == "generators") {
    require(WorldGenerator::names());
    return parameter_table(WorldGenerator::keys(options.name)).aligned();
  }
  throw std::invalid_argument("list " + options.what + ": takes no NAME (allowed after planners, " +
                              "vehicles, regulators, generators)");
}

void check_suite(const CheckOptions& options, const CommandContext& context) {
  SuiteChoice choice;
  choice.suite = options.file;
  choice.data = options.data;
  choice.set = options.set;
  const SuiteConfig suite = source_of(choice).read(context.planners);
  SuiteTrials::check_worlds(suite);
  context.out << options.file << ": " << size_text(suite) << "\n";
}

}  // namespace

ExitCode execute(const ListOptions& options, const CommandContext& context) {
  if (!options.name.empty()) {
    context.out << parameters_text(options, context.planners);
    return ExitCode::success;
  }
  if (options.what == "planners") {
    context.out << planner_table(context.planners).aligned();
    return ExitCode::success;
  }
  if (options.what == "results") {
    context.out << results_page();
    return ExitCode::success;
  }
  if (options.what == "responses") {
    context.out << response_tables();
    return ExitCode::success;
  }
  const ListedRows rows = rows_of(options.what);
  std::size_t width = 0;
  for (const auto& [name, summary] : rows) width = std::max(width, name.size());
  for (const auto& [name, summary] : rows) {
    context.out << name;
    if (!summary.empty()) context.out << std::string(width + 2 - name.size(), ' ') << summary;
    context.out << "\n";
  }
  return ExitCode::success;
}

ExitCode execute(const CheckOptions& options, const CommandContext& context) {
  const NamedScenarios found = find_scenarios(options.file, true, names_of(context.planners));
  if (!options.set.empty() || found.is_suite) {
    check_suite(options, context);
    return ExitCode::success;
  }
  for (const ScenarioSpec& scenario :
       read_scenarios(found.root, DataLocation::find(options.data))) {
    scenario.instantiate(1);
    context.out << options.file << ": scenario '" << scenario.name() << "'\n";
  }
  return ExitCode::success;
}

}  // namespace voronaut
