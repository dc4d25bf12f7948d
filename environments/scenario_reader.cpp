#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include "voronaut/environments/config/nearest_name.h"
#include "voronaut/environments/formats/csv_table.h"
#include "voronaut/environments/formats/data_sets.h"
#include "voronaut/environments/scenario.h"
#include "voronaut/environments/world.h"

namespace voronaut {
namespace {

constexpr double kFar = kFarthestCoordinate;

Vec2 read_point(const ConfigNode& node) {
  const std::vector<double> xy = node.numbers(2, "[x, y]", -kFar, kFar);
  return {xy[0], xy[1]};
}

Bounds read_bounds(const ConfigNode& node) {
  const std::vector<ConfigNode> corners = node.items(2, "[[xmin, ymin], [xmax, ymax]]");
  Bounds bounds{read_point(corners[0]), read_point(corners[1])};
  if (!(bounds.min.array() < bounds.max.array()).all())
    throw node.error("expected [[xmin, ymin], [xmax, ymax]] with xmin < xmax and ymin < ymax");
  return bounds;
}

Circle read_circle(const ConfigNode& node) {
  const std::vector<ConfigNode> values = node.items(3, "[x, y, r]");
  const double x = values[0].number(-kFar, kFar);
  const double y = values[1].number(-kFar, kFar);
  return {{x, y}, values[2].number(kSmallestRadius, kLargestRadius)};
}

Polygon read_box(const ConfigNode& node) {
  const std::vector<double> limits = node.numbers(4, "[xmin, ymin, xmax, ymax]", -kFar, kFar);
  if (limits[0] >= limits[2] || limits[1] >= limits[3])
    throw node.error("expected [xmin, ymin, xmax, ymax] with xmin < xmax and ymin < ymax");
  return box(Bounds{{limits[0], limits[1]}, {limits[2], limits[3]}});
}

Polygon read_polygon(const ConfigNode& node) {
  Shapes alone;
  alone.polygons.emplace_back();
  for (const ConfigNode& vertex : node.items())
    alone.polygons.front().vertices.push_back(read_point(vertex));
  try {
    return validated(std::move(alone)).polygons.front();
  } catch (const std::invalid_argument& error) {
    // Its message starts with the polygon's number among those it was given; the key says which.
    const std::string message = error.what();
    throw node.error(message.substr(std::string("polygon 0 ").size()));
  }
}

Segment read_segment(const ConfigNode& node) {
  const std::vector<ConfigNode> ends = node.items(2, "[[x, y], [x, y]]");
  Segment segment{read_point(ends[0]), read_point(ends[1])};
  if (segment.a == segment.b) throw node.error("both ends are the same point");
  return segment;
}

Shapes read_shapes(const ConfigNode& world) {
  world.allow_only({"circles", "boxes", "polygons", "segments"});
  Shapes shapes;
  if (const auto list = world.find("circles"))
    for (const ConfigNode& item : list->items()) shapes.circles.push_back(read_circle(item));
  if (const auto list = world.find("boxes"))
    for (const ConfigNode& item : list->items()) shapes.polygons.push_back(read_box(item));
  if (const auto list = world.find("polygons"))
    for (const ConfigNode& item : list->items()) shapes.polygons.push_back(read_polygon(item));
  if (const auto list = world.find("segments"))
    for (const ConfigNode& item : list->items()) shapes.segments.push_back(read_segment(item));
  return shapes;
}

// Names become file names, columns and arguments.
void require_plain(const std::string& name, const ConfigNode& place) {
  constexpr std::string_view kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-.+";
  if (name.empty() || name.find_first_not_of(kPlain) != std::string::npos)
    throw place.error("expected a name of letters, digits and _-.+, got " + in_quotes(name));
}

TaskConfig read_task(const ConfigNode& entry, const std::string& default_name,
                     const std::vector<std::string>& other_keys) {
  TaskConfig task;
  task.name = default_name;
  read_into(entry, task, other_keys);
  if (task.name.empty() && !entry.find("name")) entry.child("name");
  require_plain(task.name, entry.find("name").value_or(entry));
  if (task.group.empty()) task.group = task.name;
  require_plain(task.group, entry.find("group").value_or(entry));
  return task;
}

std::optional<double> read_heading(const ConfigNode& entry) {
  const auto heading = entry.find("start_heading_rad");
  return heading ? std::optional(heading->number(-10, 10)) : std::nullopt;
}

std::string stem(const std::string& path) { return std::filesystem::path(path).stem().string(); }

// A file's scenario is called like the file; one inside a list must say its name.
std::string default_name(const ConfigNode& entry) {
  return entry.path().empty() ? stem(entry.file()) : "";
}

using Specs = std::vector<ScenarioSpec>;

Specs read_fixed(const ConfigNode& entry, const std::string& source, const std::string& name,
                 Shapes (*read)(const ConfigNode&)) {
  const TaskConfig task =
      read_task(entry, name, {source, "bounds", "start", "goal", "start_heading_rad"});
  Shapes shapes = read(entry.child(source));
  const Bounds bounds = read_bounds(entry.child("bounds"));
  const auto world = std::make_shared<const World>(bounds, std::move(shapes));
  const auto placed = [&](const char* key) {
    Vec2 p = read_point(entry.child(key));
    const std::string problem = placement_problem(*world, p);
    if (!problem.empty()) throw entry.child(key).error(problem);
    return p;
  };
  const Vec2 start = placed("start");
  const Vec2 goal = placed("goal");
  return {ScenarioSpec::fixed(task, world, start, goal, read_heading(entry))};
}

// The file that a key names.
std::string existing_file(const ConfigNode& node) {
  std::string path = node.beside(node.text());
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored))
    throw node.error("no file " + in_quotes(path));
  return path;
}

Shapes read_foreign_circles(const ConfigNode& file) {
  Shapes shapes;
  shapes.circles = read_circles_csv(existing_file(file));
  return shapes;
}

Specs read_world(const ConfigNode& entry, const DataLocation&) {
  return read_fixed(entry, "world", default_name(entry), read_shapes);
}

Specs read_circles(const ConfigNode& entry, const DataLocation&) {
  const std::string file = entry.child("circles_csv").text();
  return read_fixed(entry, "circles_csv", stem(file), read_foreign_circles);
}

Specs read_generator(const ConfigNode& entry, const DataLocation&) {
  entry.child("generator").child("name");
  WorldGenerator generator = WorldGenerator::read(entry.child("generator"));
  const TaskConfig task = read_task(entry, generator.name(), {"generator", "start_heading_rad"});
  return {ScenarioSpec::generated(task, std::move(generator), read_heading(entry))};
}

Specs read_data_set_entry(const ConfigNode& entry, const DataLocation& data) {
  const ConfigNode place = entry.child("dataset");
  const std::string set = data_set_names()[place.choice(data_set_names())];
  TaskConfig task = read_task(entry, set, {"dataset", "limit", "pick"});
  if (const auto name = entry.find("name"))
    throw name->error("the worlds of a data set have names of their own; use group");
  DataSetSelection selection;
  if (const auto pick = entry.find("pick")) selection.pick = pick->texts();
  if (const auto limit = entry.find("limit"))
    selection.limit = static_cast<int>(limit->whole_number(1, 1'000'000));
  if (entry.find("pick") && entry.find("limit"))
    throw entry.child("limit").error("cannot stand beside 'pick'");
  Specs specs;
  for (DataSetWorld& read : read_data_set(set, selection, data, place)) {
    const auto world = std::make_shared<const World>(read.bounds, std::move(read.shapes));
    for (const Vec2& p : {read.start, read.goal})
      if (const std::string problem = placement_problem(*world, p); !problem.empty())
        throw place.error(read.name + ": " + problem);
    task.name = read.name;
    specs.push_back(ScenarioSpec::fixed(task, world, read.start, read.goal));
  }
  return specs;
}

Specs read_scenario_file(const ConfigNode& entry, const DataLocation& data) {
  entry.allow_only({"file"});
  const ConfigNode file = entry.child("file");
  if (entry.path().empty()) throw file.error("a scenario file cannot name another one");
  return read_scenarios(ConfigNode::read_file(existing_file(file)), data);
}

struct Source {
  std::string key;
  Specs (*read)(const ConfigNode&, const DataLocation&);
};

const std::vector<Source>& sources() {
  static const std::vector<Source> all = {{"file", read_scenario_file},
                                          {"world", read_world},
                                          {"circles_csv", read_circles},
                                          {"generator", read_generator},
                                          {"dataset", read_data_set_entry}};
  return all;
}

}  // namespace

std::vector<ScenarioSpec> read_scenarios(const ConfigNode& entry, const DataLocation& data) {
  const Source* chosen = nullptr;
  std::vector<std::string> names;
  for (const Source& source : sources()) {
    names.push_back(source.key);
    const auto found = entry.find(source.key);
    if (!found) continue;
    if (chosen != nullptr) throw found->error("cannot stand beside '" + chosen->key + "'");
    chosen = &source;
  }
  if (chosen != nullptr) return chosen->read(entry, data);
  for (const std::string& key : entry.keys())
    if (const auto meant = nearest_name(key, names))
      throw entry.child(key).error("unknown key" + allowed_names(key, names));
  throw entry.error("expected one of the keys " + join_names(names));
}

}  // namespace voronaut
