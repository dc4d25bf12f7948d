#include <filesystem>
#include <fstream>
#include <ostream>
#include <stdexcept>

#include "voronaut/benchmarks/cli/commands.h"
#include "voronaut/benchmarks/cli/named_scenarios.h"
#include "voronaut/benchmarks/episode/episode_trace.h"
#include "voronaut/benchmarks/suite/suite_includes.h"
#include "voronaut/environments/formats/foreign_formats.h"
#include "voronaut/environments/formats/wkt.h"
#include "voronaut/environments/polygons/polygon_areas.h"
#include "voronaut/environments/scenario_files/scenario_reader.h"
#include "voronaut/environments/world.h"
#include "voronaut/reports/figures/figure_file.h"

namespace voronaut {
namespace {

// A world around the shapes, for files that do not say how far it reaches.
Bounds bounds_around(const Shapes& shapes, const std::string& file) {
  if (shapes.empty()) throw ConfigError(file, 1, "", "nothing to draw");
  const Bounds huge{Vec2::Constant(1e9), Vec2::Constant(-1e9)};
  Bounds around = huge;
  const auto extend = [&around](const Bounds& of) {
    around = {around.min.cwiseMin(of.min), around.max.cwiseMax(of.max)};
  };
  for (const Circle& circle : shapes.circles) extend(bounds_of(circle));
  for (const Segment& segment : shapes.segments) extend(bounds_of(segment));
  for (const Polygon& polygon : shapes.polygons) extend(bounds_of(polygon));
  const Vec2 margin = Vec2::Constant(0.5);
  return {around.min - margin, around.max + margin};
}

// Solids that overlap or share edges as one: without the edges inside. Holes are rings the other
// way round, which a figure leaves open.
TraceWorld drawn_world(const Scenario& scenario) {
  TraceWorld world = trace_world(scenario, "");
  world.polygons.clear();
  const auto add_ring = [&world](const std::vector<Vec2>& ring) {
    auto& outline = world.polygons.emplace_back();
    for (const Vec2& p : ring) outline.push_back({p.x(), p.y()});
  };
  for (const PolygonArea& area : united(scenario.world->shapes().polygons)) {
    add_ring(area.outer);
    for (const auto& hole : area.holes) add_ring(hole);
  }
  return world;
}

Scenario foreign_scenario(const std::string& file, const std::string& name, bool& has_ends) {
  const ForeignFormat& format = foreign_format(name, file);
  const ForeignWorld read = format.read(file, format.defaults);
  const Bounds bounds = read.bounds ? *read.bounds : bounds_around(read.shapes, file);
  Scenario scenario;
  scenario.name = std::filesystem::path(file).filename().string();
  scenario.world = std::make_shared<const World>(bounds, read.shapes);
  const Vec2 middle = (bounds.min + bounds.max) / 2;
  scenario.start_world = read.start.value_or(middle);
  scenario.goal_world = read.goal.value_or(middle);
  has_ends = read.start && read.goal;
  return scenario;
}

std::vector<Scenario> scenarios_of(const ShowOptions& options, const PlannerCatalog& planners) {
  std::vector<std::string> names;
  for (const PlannerEntry* entry : planners.entries()) names.push_back(entry->name);
  const NamedScenarios found = find_scenarios(options.file, false, names);
  std::vector<ConfigNode> entries = {found.root};
  if (found.is_suite) entries = with_includes(found.root).child("scenarios").items();
  std::vector<Scenario> scenarios;
  for (const ConfigNode& entry : entries)
    for (const ScenarioSpec& spec : read_scenarios(entry, DataLocation::find(options.data)))
      scenarios.push_back(spec.instantiate(options.seed));
  return scenarios;
}

void write_wkt(const std::vector<Scenario>& scenarios, const std::string& path) {
  std::ofstream file(path);
  for (const Scenario& scenario : scenarios) file << wkt_of(scenario.world->shapes());
  if (!file.flush()) throw std::invalid_argument(path + ": cannot be written");
}

}  // namespace

ExitCode execute(const ShowOptions& options, const CommandContext& context) {
  const bool as_text = options.out.ends_with(".wkt");
  if (!as_text) check_figure_name(options.out);
  bool has_ends = true;
  const bool foreign = !options.format.empty() ||
                       (std::filesystem::exists(options.file) && is_foreign_file(options.file));
  const std::vector<Scenario> scenarios =
      foreign ? std::vector{foreign_scenario(options.file, options.format, has_ends)}
              : scenarios_of(options, context.planners);
  if (as_text) {
    write_wkt(scenarios, options.out);
  } else {
    std::vector<FigurePanel> panels;
    for (const Scenario& scenario : scenarios) {
      panels.push_back({scenario.name, drawn_world(scenario), {}});
      panels.back().ends = has_ends;
    }
    write_figure(panels, options.out);
  }
  context.out << options.out << "\n";
  return ExitCode::success;
}

}  // namespace voronaut
