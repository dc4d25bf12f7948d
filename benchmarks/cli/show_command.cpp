#include <filesystem>
#include <ostream>

#include "voronaut/benchmarks/cli/commands.h"
#include "voronaut/benchmarks/episode/episode_trace.h"
#include "voronaut/environments/formats/foreign_formats.h"
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

FigurePanel foreign_panel(const std::string& file, const std::string& name) {
  const ForeignFormat& format = foreign_format(name, file);
  const ForeignWorld read = format.read(file, format.defaults);
  const Bounds bounds = read.bounds ? *read.bounds : bounds_around(read.shapes, file);
  Scenario scenario;
  scenario.world = std::make_shared<const World>(bounds, read.shapes);
  const Vec2 middle = (bounds.min + bounds.max) / 2;
  scenario.start_world = read.start.value_or(middle);
  scenario.goal_world = read.goal.value_or(middle);
  FigurePanel panel{std::filesystem::path(file).filename().string(), trace_world(scenario, ""), {}};
  panel.ends = read.start && read.goal;
  return panel;
}

std::vector<FigurePanel> scenario_panels(const ShowOptions& options) {
  std::vector<FigurePanel> panels;
  for (const ScenarioSpec& spec :
       read_scenarios(ConfigNode::read_file(options.file), DataLocation::find(options.data))) {
    const Scenario scenario = spec.instantiate(options.seed);
    panels.push_back({scenario.name, trace_world(scenario, ""), {}});
  }
  return panels;
}

}  // namespace

ExitCode execute(const ShowOptions& options, const CommandContext& context) {
  check_figure_name(options.out);
  const bool foreign = !options.format.empty() || is_foreign_file(options.file);
  const std::vector<FigurePanel> panels =
      foreign ? std::vector{foreign_panel(options.file, options.format)} : scenario_panels(options);
  write_figure(panels, options.out);
  context.out << options.out << "\n";
  return ExitCode::success;
}

}  // namespace voronaut
