#include "voronaut/environments/scenario_files/scenario_reader.h"

#include <stdexcept>
#include <utility>

#include "voronaut/environments/config/config_reader.h"
#include "voronaut/environments/config/nearest_name.h"
#include "voronaut/environments/formats/csv_table.h"
#include "voronaut/environments/formats/wkt.h"
#include "voronaut/environments/scenario_files/foreign_scenarios.h"
#include "voronaut/environments/scenario_files/scenario_fields.h"
#include "voronaut/environments/scenario_files/scenario_keys.h"
#include "voronaut/environments/world.h"

namespace voronaut {
namespace {

Circle read_circle(const ConfigNode& node) {
  const std::vector<ConfigNode> values = node.items(3, "[x, y, r]");
  const double x = values[0].number(-kFarthestCoordinate, kFarthestCoordinate);
  const double y = values[1].number(-kFarthestCoordinate, kFarthestCoordinate);
  return {{x, y}, values[2].number(kSmallestRadius, kLargestRadius)};
}

Polygon read_box(const ConfigNode& node) {
  const std::vector<double> limits =
      node.numbers(4, "[xmin, ymin, xmax, ymax]", -kFarthestCoordinate, kFarthestCoordinate);
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

Shapes read_wkt(const ConfigNode& node) {
  try {
    return parse_wkt(node.text());
  } catch (const std::invalid_argument& error) {
    throw node.error(error.what());
  }
}

void add(const Shapes& more, Shapes& shapes) {
  shapes.polygons.insert(shapes.polygons.end(), more.polygons.begin(), more.polygons.end());
  shapes.segments.insert(shapes.segments.end(), more.segments.begin(), more.segments.end());
}

Shapes read_shapes(const ConfigNode& world) {
  world.allow_only(key_names<ShapeKeys>());
  Shapes shapes;
  if (const auto list = world.find("circles"))
    for (const ConfigNode& item : list->items()) shapes.circles.push_back(read_circle(item));
  if (const auto list = world.find("boxes"))
    for (const ConfigNode& item : list->items()) shapes.polygons.push_back(read_box(item));
  if (const auto list = world.find("polygons"))
    for (const ConfigNode& item : list->items()) shapes.polygons.push_back(read_polygon(item));
  if (const auto list = world.find("segments"))
    for (const ConfigNode& item : list->items()) shapes.segments.push_back(read_segment(item));
  if (const auto texts = world.find("wkt"))
    for (const ConfigNode& item : texts->is_list() ? texts->items() : std::vector{*texts})
      add(read_wkt(item), shapes);
  return shapes;
}

// A file's scenario is called like the file; one inside a list must say its name.
std::string default_name(const ConfigNode& entry) {
  return entry.path().empty() ? stem(entry.file()) : "";
}

ScenarioSpecs read_world_entry(const ConfigNode& entry, const DataLocation&) {
  const ConfigNode place = entry.child("world");
  const TaskConfig task = read_task(entry, default_name(entry), key_names<WorldKeys>());
  Shapes shapes = read_shapes(place);
  const Bounds bounds = read_bounds(entry.child("bounds"));
  const auto world = std::make_shared<const World>(bounds, std::move(shapes));
  return {placed_scenario(task, world, read_point(entry.child("start")),
                          read_point(entry.child("goal")), entry, place)};
}

ScenarioSpecs read_generator_entry(const ConfigNode& entry, const DataLocation&) {
  entry.child("generator").child("name");
  WorldGenerator generator = WorldGenerator::read(entry.child("generator"));
  const TaskConfig task = read_task(entry, generator.name(), key_names<GeneratorKeys>());
  return {ScenarioSpec::generated(task, std::move(generator), read_heading(entry))};
}

ScenarioSpecs read_scenario_file_entry(const ConfigNode& entry, const DataLocation& data) {
  entry.allow_only(key_names<ScenarioFileKeys>());
  const ConfigNode file = entry.child("file");
  if (entry.path().empty()) throw file.error("a scenario file cannot name another one");
  return read_scenarios(ConfigNode::read_file(existing_file(file)), data);
}

struct Source {
  std::string key;
  ScenarioSpecs (*read)(const ConfigNode&, const DataLocation&);
};

const std::vector<Source>& sources() {
  static const std::vector<Source> all = {{"file", read_scenario_file_entry},
                                          {"world", read_world_entry},
                                          {"world_file", read_world_file_entry},
                                          {"generator", read_generator_entry},
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
