#include "voronaut/environments/formats/foreign_formats.h"

#include <algorithm>
#include <filesystem>

#include "voronaut/environments/config/config_node.h"
#include "voronaut/environments/config/nearest_name.h"
#include "voronaut/environments/formats/csv_table.h"
#include "voronaut/environments/formats/dodgedrone.h"
#include "voronaut/environments/formats/ir_sim.h"
#include "voronaut/environments/formats/movingai.h"
#include "voronaut/environments/formats/ompl_worlds.h"
#include "voronaut/environments/formats/pathbench.h"
#include "voronaut/environments/formats/ros_map.h"
#include "voronaut/environments/formats/sdf_world.h"

namespace voronaut {
namespace {

std::string ending_of(const std::string& path) {
  return std::filesystem::path(path).extension().string();
}

// Whether a line of the text begins with these characters.
bool has_line(std::string_view text, std::string_view beginning) {
  for (std::size_t at = 0; at != std::string_view::npos && at < text.size();) {
    if (text.substr(at).starts_with(beginning)) return true;
    at = text.find('\n', at);
    if (at != std::string_view::npos) ++at;
  }
  return false;
}

ForeignOptions unit_cells() {
  ForeignOptions options;
  options.cell_size_m = 1;
  return options;
}

ForeignWorld read_movingai(const std::string& path, const ForeignOptions& options) {
  const BlockedCells cells = parse_movingai_map(read_text_file(path), path);
  return world_of(cells, {cells.columns(), cells.rows(), options.cell_size_m});
}

ForeignWorld read_ros_map(const std::string& path, const ForeignOptions& options) {
  const RosMapDescription map = read_ros_map_description(ConfigNode::read_file(path));
  const GreyImage image = parse_pgm(read_bytes(map.image), map.image);
  const BlockedCells cells = ros_map_cells(map, image, options.unknown);
  return world_of(cells, {cells.columns(), cells.rows(), map.resolution_m, map.origin});
}

ForeignWorld read_circles(const std::string& path, const ForeignOptions&) {
  ForeignWorld world;
  world.shapes.circles = read_circles_csv(path);
  return world;
}

std::vector<ForeignQuery> read_query_table(const std::string& path, const std::string& world_path) {
  constexpr double kFar = kFarthestCoordinate;
  const auto table = CsvTable::read(path, {"start_x", "start_y", "goal_x", "goal_y"});
  const std::filesystem::path world(world_path);
  const std::string folder = world.parent_path().filename().string();
  std::vector<ForeignQuery> queries;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (table.has("map") && table.text(row, "map") != world.stem().string() &&
        table.text(row, "map") != folder)
      continue;
    ForeignQuery query;
    query.name = std::to_string(queries.size());
    query.start = {table.number(row, "start_x", -kFar, kFar),
                   table.number(row, "start_y", -kFar, kFar)};
    query.goal = {table.number(row, "goal_x", -kFar, kFar),
                  table.number(row, "goal_y", -kFar, kFar)};
    queries.push_back(std::move(query));
  }
  if (queries.empty())
    throw ConfigError(path, 0, "", "no query for the map " + in_quotes(world.stem().string()));
  return queries;
}

}  // namespace

const std::vector<ForeignFormat>& foreign_formats() {
  static const std::vector<ForeignFormat> all = {
      {"movingai",
       "MovingAI grid (.map)",
       [](std::string_view ending, std::string_view text) {
         return ending == ".map" && has_line(text, "type");
       },
       {"cell_size_m"},
       {},
       read_movingai},
      {"ros_map",
       "ROS map_server (.yaml and its .pgm)",
       [](std::string_view ending, std::string_view text) {
         return (ending == ".yaml" || ending == ".yml") && has_line(text, "image:");
       },
       {"unknown"},
       {},
       read_ros_map},
      {"sdf",
       "Gazebo world of cylinders and boxes, as BARN's (.world)",
       [](std::string_view ending, std::string_view text) {
         return ending == ".world" || (ending == ".sdf" && text.find("<sdf") != text.npos);
       },
       {},
       {},
       [](const std::string& path, const ForeignOptions&) {
         return parse_sdf_world(read_text_file(path), path);
       }},
      {"pathbench",
       "PathBench dense map (.json)",
       [](std::string_view ending, std::string_view) { return ending == ".json"; },
       {"cell_size_m"},
       unit_cells(),
       [](const std::string& path, const ForeignOptions& options) {
         return read_pathbench(ConfigNode::read_file(path), options.cell_size_m);
       }},
      {"ir_sim",
       "IR-SIM world (.yaml)",
       [](std::string_view ending, std::string_view text) {
         return (ending == ".yaml" || ending == ".yml") && has_line(text, "robot:") &&
                has_line(text, "world:");
       },
       {},
       {},
       [](const std::string& path, const ForeignOptions&) {
         return read_ir_sim(ConfigNode::read_file(path));
       }},
      {"dodgedrone",
       "DodgeDrone spheres (static_obstacles.csv)",
       [](std::string_view ending, std::string_view text) {
         const std::string_view first = text.substr(0, text.find('\n'));
         return ending == ".csv" && std::count(first.begin(), first.end(), ',') == 10;
       },
       {"cut", "height_m"},
       {},
       [](const std::string& path, const ForeignOptions& options) {
         return parse_dodgedrone(read_text_file(path), path, options);
       }},
      {"ompl_circles",
       "circles of OMPL's tests (.txt)",
       [](std::string_view ending, std::string_view text) {
         return ending == ".txt" && has_line(text, "units:");
       },
       {},
       {},
       [](const std::string& path, const ForeignOptions&) {
         return parse_ompl_circles(read_text_file(path), path);
       }},
      {"ompl_env",
       "grid of OMPL's tests (.txt)",
       [](std::string_view ending, std::string_view text) {
         return ending == ".txt" && has_line(text, "discretization(cells):");
       },
       {"cell_size_m"},
       unit_cells(),
       [](const std::string& path, const ForeignOptions& options) {
         return parse_ompl_environment(read_text_file(path), path, options.cell_size_m);
       }},
      {"circles_csv",
       "circles, columns x, y, r (.csv)",
       [](std::string_view ending, std::string_view) { return ending == ".csv"; },
       {},
       {},
       read_circles}};
  return all;
}

std::vector<std::string> foreign_format_names() {
  std::vector<std::string> names;
  for (const ForeignFormat& format : foreign_formats()) names.push_back(format.name);
  return names;
}

bool is_foreign_file(const std::string& path) {
  const std::string ending = ending_of(path);
  const std::string text = read_bytes(path);
  return (ending != ".yaml" && ending != ".yml") ||
         std::any_of(foreign_formats().begin(), foreign_formats().end(),
                     [&](const ForeignFormat& format) { return format.recognises(ending, text); });
}

const ForeignFormat& foreign_format(const std::string& name, const std::string& path) {
  const std::string text = name.empty() ? read_bytes(path) : "";
  const auto found =
      std::find_if(foreign_formats().begin(), foreign_formats().end(), [&](const auto& format) {
        return name.empty() ? format.recognises(ending_of(path), text) : format.name == name;
      });
  if (found != foreign_formats().end()) return *found;
  if (!name.empty())
    throw ConfigError(path, 0, "",
                      "no format " + in_quotes(name) + allowed_names(name, foreign_format_names()));
  throw ConfigError(path, 0, "",
                    "not recognised as one of the formats " + join_names(foreign_format_names()) +
                        "; name its format");
}

std::vector<ForeignQuery> read_queries(const std::string& path, const std::string& world_path,
                                       const ForeignWorld& world) {
  if (ending_of(path) == ".csv") return read_query_table(path, world_path);
  if (ending_of(path) == ".txt") return parse_ompl_circle_queries(read_text_file(path), path);
  if (!world.cells)
    throw ConfigError(path, 0, "", "cells of " + in_quotes(world_path) + ", which is no grid");
  return parse_movingai_scen(read_text_file(path), path, *world.cells);
}

}  // namespace voronaut
