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
#include "voronaut/environments/formats/text_lines.h"
#include "voronaut/environments/formats/wkt.h"

namespace voronaut {
namespace {

std::string ending_of(const std::string& path) {
  return std::filesystem::path(path).extension().string();
}

FileLook look_at(const std::string& path) {
  FileLook file{ending_of(path), std::string(without_byte_order_mark(read_bytes(path))), {}};
  if (file.ending == ".yaml" || file.ending == ".yml")
    file.yaml = ConfigNode::parse(file.text, path);
  return file;
}

bool is_ros_map(const FileLook& file) { return file.yaml && file.yaml->find("image"); }

// Our own scenario files have a `world` too, of shapes.
bool is_ir_sim(const FileLook& file) {
  if (!file.yaml) return false;
  const auto world = file.yaml->find("world");
  const bool has_size = world && world->is_map() && (world->find("width") || world->find("height"));
  return has_size || file.yaml->find("robot") || file.yaml->find("obstacle") ||
         file.yaml->find("irsim");
}

bool has_line(const FileLook& file, std::string_view beginning) {
  TextLines lines(file.text, "");
  while (lines.next())
    if (lines.line().starts_with(beginning)) return true;
  return false;
}

ForeignOptions unit_cells() {
  ForeignOptions options;
  options.cell_size_m = 1;
  return options;
}

ForeignOptions seen_from_above() {
  ForeignOptions options;
  options.cut = BodyCut::columns;
  return options;
}

ForeignWorld read_movingai(const std::string& path, const ForeignOptions& options) {
  const BlockedCells cells = parse_movingai_map(read_text_file(path), path);
  return world_of(cells, {cells.columns(), cells.rows(), options.cell_size_m});
}

// What is wrong with the image is said where the map names it.
GreyImage read_image(const RosMapDescription& map, const ConfigNode& place) {
  try {
    return read_ros_map_image(map);
  } catch (const ConfigError& error) {
    throw place.error(error.what());
  }
}

ForeignWorld read_ros_map(const std::string& path, const ForeignOptions& options) {
  const ConfigNode root = ConfigNode::read_file(path);
  const RosMapDescription map = read_ros_map_description(root);
  const GreyImage image = read_image(map, root.child("image"));
  const BlockedCells cells = ros_map_cells(map, image, options.unknown);
  return world_of(cells, {cells.columns(), cells.rows(), map.resolution_m, map.origin});
}

ForeignWorld read_circles(const std::string& path, const ForeignOptions&) {
  ForeignWorld world;
  world.shapes.circles = read_circles_csv(path);
  return world;
}

std::vector<ForeignQuery> read_query_table(const std::string& path, const std::string& world_path) {
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
    query.start = {table.number(row, "start_x", -kFarthestCoordinate, kFarthestCoordinate),
                   table.number(row, "start_y", -kFarthestCoordinate, kFarthestCoordinate)};
    query.goal = {table.number(row, "goal_x", -kFarthestCoordinate, kFarthestCoordinate),
                  table.number(row, "goal_y", -kFarthestCoordinate, kFarthestCoordinate)};
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
       [](const FileLook& file) { return file.ending == ".map"; },
       {"cell_size_m"},
       {},
       read_movingai},
      {"ros_map",
       "ROS map_server (.yaml and its .pgm or .png)",
       is_ros_map,
       {"unknown"},
       {},
       read_ros_map},
      {"sdf",
       "Gazebo world of cylinders and boxes, as BARN's (.world)",
       [](const FileLook& file) { return file.ending == ".world" || file.ending == ".sdf"; },
       {"cut", "height_m"},
       seen_from_above(),
       [](const std::string& path, const ForeignOptions& options) {
         return parse_sdf_world(read_text_file(path), path, options);
       }},
      {"pathbench",
       "PathBench dense map (.json)",
       [](const FileLook& file) { return file.ending == ".json"; },
       {"cell_size_m"},
       unit_cells(),
       [](const std::string& path, const ForeignOptions& options) {
         return read_pathbench(ConfigNode::read_file(path), options.cell_size_m);
       }},
      {"ir_sim",
       "IR-SIM world (.yaml)",
       is_ir_sim,
       {},
       {},
       [](const std::string& path, const ForeignOptions&) {
         return read_ir_sim(ConfigNode::read_file(path));
       }},
      {"dodgedrone",
       "DodgeDrone spheres (static_obstacles.csv)",
       [](const FileLook& file) {
         const std::string first = file.text.substr(0, file.text.find('\n'));
         return file.ending == ".csv" && std::count(first.begin(), first.end(), ',') == 10;
       },
       {"cut", "height_m"},
       {},
       [](const std::string& path, const ForeignOptions& options) {
         return parse_dodgedrone(read_text_file(path), path, options);
       }},
      {"ompl_circles",
       "circles of OMPL's tests (.txt)",
       [](const FileLook& file) { return file.ending == ".txt" && has_line(file, "units:"); },
       {},
       {},
       [](const std::string& path, const ForeignOptions&) {
         return parse_ompl_circles(read_text_file(path), path);
       }},
      {"ompl_env",
       "grid of OMPL's tests (.txt)",
       [](const FileLook& file) {
         return file.ending == ".txt" && has_line(file, "discretization(cells):");
       },
       {"cell_size_m"},
       unit_cells(),
       [](const std::string& path, const ForeignOptions& options) {
         return parse_ompl_environment(read_text_file(path), path, options.cell_size_m);
       }},
      {"wkt",
       "well-known text, a geometry a line (.wkt)",
       [](const FileLook& file) { return file.ending == ".wkt"; },
       {},
       {},
       [](const std::string& path, const ForeignOptions&) {
         ForeignWorld world;
         world.shapes = parse_wkt_lines(read_text_file(path), path);
         return world;
       }},
      {"circles_csv",
       "circles, columns x, y, r (.csv)",
       [](const FileLook& file) { return file.ending == ".csv"; },
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
  const FileLook file = look_at(path);
  return !file.yaml ||
         std::any_of(foreign_formats().begin(), foreign_formats().end(),
                     [&](const ForeignFormat& format) { return format.recognises(file); });
}

const ForeignFormat& foreign_format(const std::string& name, const std::string& path) {
  const FileLook file = name.empty() ? look_at(path) : FileLook{};
  const auto found = std::find_if(
      foreign_formats().begin(), foreign_formats().end(), [&](const ForeignFormat& format) {
        return name.empty() ? format.recognises(file) : format.name == name;
      });
  if (found != foreign_formats().end()) return *found;
  if (!name.empty())
    throw ConfigError(path, 0, "",
                      "no format " + in_quotes(name) + allowed_names(name, foreign_format_names()));
  throw ConfigError(path, 1, "",
                    "not recognised as one of the formats " + join_names(foreign_format_names()) +
                        "; name its format");
}

std::vector<ForeignQuery> read_queries(const std::string& path, const std::string& world_path,
                                       const ForeignWorld& world) {
  if (ending_of(path) == ".csv") return read_query_table(path, world_path);
  if (ending_of(path) == ".txt") return parse_ompl_circle_queries(read_text_file(path), path);
  if (!world.cells)
    throw ConfigError(path, 0, "", "cells of " + in_quotes(world_path) + ", which is no grid");
  return parse_movingai_scen(read_text_file(path), path, *world.cells,
                             std::filesystem::path(world_path).filename().string());
}

}  // namespace voronaut
