#include <algorithm>
#include <iomanip>
#include <ostream>

#include "voronaut/benchmarks/cli/commands.h"
#include "voronaut/benchmarks/cli/dry_run.h"
#include "voronaut/benchmarks/isolation/child_process.h"
#include "voronaut/benchmarks/responses/response_tables.h"
#include "voronaut/benchmarks/suite/shipped_files.h"
#include "voronaut/benchmarks/suite/suite_config.h"
#include "voronaut/benchmarks/suite/suite_trials.h"
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

ListedRows scenario_rows() {
  ListedRows rows = rows_of(shipped_files("scenarios"));
  for (const std::string& name : WorldGenerator::names())
    rows.emplace_back("generator: {name: " + name + "}", "random worlds");
  for (const std::string& name : data_set_names())
    rows.emplace_back("dataset: " + name, "real worlds, from --data or VORONAUT_DATA");
  for (const ForeignFormat& format : foreign_formats())
    rows.emplace_back("world_file: (format " + format.name + ")", format.summary);
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
  ListedRows rows;
  if (what == "vehicles") {
    rows = vehicle_rows();
  } else if (what == "regulators") {
    for (const std::string& name : regulator_names()) rows.emplace_back(name, "");
  } else if (what == "scenarios") {
    rows = scenario_rows();
  } else {
    rows = rows_of(shipped_files("suites"));
  }
  return rows;
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
  const ConfigNode root = ConfigNode::read_file(find_suite(options.file).string());
  const auto keys = {"suite", "planners", "vehicles", "include"};
  if (!options.set.empty() ||
      std::any_of(keys.begin(), keys.end(), [&](const char* key) { return root.find(key); })) {
    check_suite(options, context);
    return ExitCode::success;
  }
  for (const ScenarioSpec& scenario : read_scenarios(root, DataLocation::find(options.data))) {
    scenario.instantiate(1);
    context.out << options.file << ": scenario '" << scenario.name() << "'\n";
  }
  return ExitCode::success;
}

}  // namespace voronaut
