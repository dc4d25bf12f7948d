#include "voronaut/environments/scenario_files/foreign_scenarios.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "voronaut/environments/config/config_reader.h"
#include "voronaut/environments/config/nearest_name.h"
#include "voronaut/environments/formats/data_sets.h"
#include "voronaut/environments/formats/foreign_formats.h"
#include "voronaut/environments/scenario_files/scenario_keys.h"
#include "voronaut/environments/world.h"

namespace voronaut {
namespace {

using Keys = std::vector<std::string>;

Keys joined(Keys keys, const Keys& more) {
  keys.insert(keys.end(), more.begin(), more.end());
  return keys;
}

std::shared_ptr<const World> world_of(ForeignWorld& read, const ConfigNode& entry) {
  if (const auto bounds = entry.find("bounds")) read.bounds = read_bounds(*bounds);
  if (!read.bounds) entry.child("bounds");  // says that it is missing
  try {
    return std::make_shared<const World>(*read.bounds, read.shapes);
  } catch (const std::invalid_argument& error) {
    throw entry.child("world_file").error(error.what());
  }
}

// The queries that `queries: {file: .., pick: [..], ..}` or `queries: file` names.
std::vector<ForeignQuery> selected_queries(const ConfigNode& node, const std::string& world_path,
                                           const ForeignWorld& read, const World& world) {
  if (!node.is_map()) return read_queries(existing_file(node), world_path, read);
  QuerySelection selection;
  read_into(node, selection, key_names<QueryFileKeys>());
  const auto all = read_queries(existing_file(node.child("file")), world_path, read);
  const auto pick = node.find("pick");
  if (!pick) {
    auto selected = select_queries(all, selection, world, stem(world_path));
    if (selected.empty()) throw node.error("selects none of " + std::to_string(all.size()));
    return selected;
  }
  std::vector<ForeignQuery> picked;
  for (const ConfigNode& item : pick->items()) {
    const auto found = std::find_if(all.begin(), all.end(), [&](const ForeignQuery& query) {
      return query.name == item.text();
    });
    if (found == all.end())
      throw item.error("no query " + in_quotes(item.text()) + " among the " +
                       std::to_string(all.size()) + " of the file");
    picked.push_back(*found);
  }
  return picked;
}

// A file for ground robots, say, flown over at the height that nobody gave: the empty world is an
// answer to a question that was not asked.
void require_bodies_on_plane(const ForeignWorld& read, const ForeignOptions& options,
                             const ConfigNode& entry) {
  if (read.bodies_off_plane == 0 || !read.shapes.empty()) return;
  for (const char* key : {"cruise_height_m", "height_m", "cut"})
    if (entry.find(key)) return;
  throw entry.child("world_file")
      .error("none of its " + std::to_string(read.bodies_off_plane) +
             " bodies reaches the height of flight, " + number_text(options.height_m) +
             " m unless cruise_height_m is given (or height_m, or cut: columns for all of them)");
}

Vec2 given_or(const ConfigNode& entry, const char* key, const std::optional<Vec2>& of_file) {
  if (const auto given = entry.find(key)) return read_point(*given);
  if (!of_file) entry.child(key);  // says that it is missing
  return *of_file;
}

}  // namespace

ScenarioSpecs read_world_file_entry(const ConfigNode& entry, const DataLocation&) {
  const ConfigNode place = entry.child("world_file");
  const std::string path = existing_file(place);
  const auto name = entry.find("format");
  if (name) name->choice(foreign_format_names());
  const ForeignFormat& format = foreign_format(name ? name->text() : "", path);
  TaskConfig task =
      read_task(entry, stem(path), joined(key_names<WorldFileKeys>(), format.options));
  ForeignOptions options = format.defaults;
  options.cut = BodyCut::plane;
  options.height_m = task.cruise_height_m;
  read_present_keys(entry, keys_of(options));
  ForeignWorld read = format.read(path, options);
  require_bodies_on_plane(read, options, entry);
  const auto world = world_of(read, entry);
  task.robot = read.robot;
  const auto queries = entry.find("queries");
  if (!queries)
    return {placed_scenario(task, world, given_or(entry, "start", read.start),
                            given_or(entry, "goal", read.goal), entry, place,
                            entry.find("start") ? std::nullopt : read.start_heading_rad)};
  for (const char* key : {"start", "goal"})
    if (const auto given = entry.find(key)) throw given->error("cannot stand beside 'queries'");
  ScenarioSpecs specs;
  const std::string map = task.name;
  for (const ForeignQuery& query : selected_queries(*queries, path, read, *world)) {
    task.name = map + "_" + query.name;
    specs.push_back(placed_scenario(task, world, query.start, query.goal, entry, *queries));
  }
  return specs;
}

ScenarioSpecs read_data_set_entry(const ConfigNode& entry, const DataLocation& data) {
  const ConfigNode place = entry.child("dataset");
  const std::string set = data_set_names()[place.choice(data_set_names())];
  const DataSetTraits traits = data_set_traits(set);
  TaskConfig task = read_task(entry, set, joined(key_names<DataSetKeys>(), traits.options));
  if (const auto name = entry.find("name"))
    throw name->error("the worlds of a data set have names of their own; use group");
  DataSetSelection selection;
  selection.queries = traits.queries;
  read_present_keys(entry, keys_of(selection.options));
  if (const auto queries = entry.find("queries")) read_into(*queries, selection.queries);
  if (const auto pick = entry.find("pick")) selection.pick = pick->texts();
  DataSetKeys own;
  read_present_keys(entry, keys_of(own));
  selection.limit = own.limit;
  for (const char* key : {"limit", "queries"})
    if (const auto given = entry.find(key); given && entry.find("pick"))
      throw given->error("cannot stand beside 'pick'");
  ScenarioSpecs specs;
  for (const DataSetWorld& read : read_data_set(set, selection, data, place)) {
    task.name = read.name;
    task.barn_length_m = read.barn_length_m;
    specs.push_back(placed_scenario(task, read.world, read.start, read.goal, entry, place));
  }
  return specs;
}

}  // namespace voronaut
