#include "voronaut/environments/formats/data_sets.h"

#include <algorithm>
#include <filesystem>
#include <functional>

#include "voronaut/environments/config/nearest_name.h"
#include "voronaut/environments/formats/csv_table.h"

namespace voronaut {
namespace {

constexpr double kFar = kFarthestCoordinate;

// One world that an index lists; its own file is read only if it is selected.
struct Listed {
  std::string name;
  std::function<DataSetWorld()> read;
};

std::vector<Listed> list_barn(const std::string& folder) {
  const auto table =
      CsvTable::read(folder + "/worlds.csv", {"world", "start_x", "start_y", "goal_x", "goal_y"});
  std::vector<Listed> worlds;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    std::string number = table.text(row, "world");
    number.insert(0, 3 - std::min<std::size_t>(number.size(), 3), '0');
    DataSetWorld world;
    world.name = "barn_" + number;
    world.bounds = {{-4.5, 0}, {0, 14}};
    world.start = {table.number(row, "start_x", -kFar, kFar),
                   table.number(row, "start_y", -kFar, kFar)};
    world.goal = {table.number(row, "goal_x", -kFar, kFar),
                  table.number(row, "goal_y", -kFar, kFar)};
    std::string file = folder;
    file.append("/obstacles/world_").append(number).append(".csv");
    worlds.push_back({world.name, [world, file] {
                        DataSetWorld read = world;
                        read.shapes.circles = read_circles_csv(file);
                        return read;
                      }});
  }
  return worlds;
}

std::vector<Listed> list_dodgedrone(const std::string& folder) {
  const auto table = CsvTable::read(folder + "/index.csv", {"env"});
  std::vector<Listed> worlds;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const std::string& environment = table.text(row, "env");
    DataSetWorld world;
    world.name = "dodgedrone_" + environment;
    world.bounds = {{-2, -12}, {20, 12}};
    world.goal = {18, 0};
    std::string file = folder;
    file.append("/").append(environment).append("/slice_z1.csv");
    worlds.push_back({world.name, [world, file] {
                        DataSetWorld read = world;
                        read.shapes.circles = read_circles_csv(file);
                        return read;
                      }});
  }
  return worlds;
}

struct DataSet {
  std::string name;
  std::vector<Listed> (*list)(const std::string& folder);
};

const std::vector<DataSet>& data_sets() {
  static const std::vector<DataSet> all = {{"barn", list_barn}, {"dodgedrone", list_dodgedrone}};
  return all;
}

std::string folder_of(const std::string& name, const DataLocation& data, const ConfigNode& place) {
  const std::string remedy = "give --data DIR or set VORONAUT_DATA";
  if (data.folder.empty())
    throw place.error("'" + name + "' lies in the data folder, which is not known: " + remedy);
  std::string folder = (std::filesystem::path(data.folder) / name).string();
  std::error_code ignored;
  if (!std::filesystem::is_directory(folder, ignored))
    throw place.error("no folder " + in_quotes(folder) + " (data folder from " + data.origin +
                      "; " + remedy + ")");
  return folder;
}

const Listed& find_listed(const std::vector<Listed>& listed, const std::string& name,
                          const ConfigNode& place) {
  std::vector<std::string> names;
  names.reserve(listed.size());
  for (const Listed& world : listed) {
    if (world.name == name) return world;
    names.push_back(world.name);
  }
  const auto meant = nearest_name(name, names);
  throw place.error("no world " + in_quotes(name) + " among the " + std::to_string(names.size()) +
                    " of this data set" + (meant ? " (did you mean '" + *meant + "'?)" : ""));
}

}  // namespace

std::vector<std::string> data_set_names() {
  std::vector<std::string> names;
  for (const DataSet& set : data_sets()) names.push_back(set.name);
  return names;
}

std::vector<DataSetWorld> read_data_set(const std::string& name, const DataSetSelection& selection,
                                        const DataLocation& data, const ConfigNode& place) {
  const auto set = std::find_if(data_sets().begin(), data_sets().end(),
                                [&name](const DataSet& one) { return one.name == name; });
  if (set == data_sets().end())
    throw place.error("no data set " + in_quotes(name) + allowed_names(name, data_set_names()));
  const std::vector<Listed> listed = set->list(folder_of(name, data, place));
  std::vector<DataSetWorld> worlds;
  for (const std::string& picked : selection.pick)
    worlds.push_back(find_listed(listed, picked, place).read());
  if (!selection.pick.empty()) return worlds;
  for (const Listed& world : listed) {
    if (selection.limit > 0 && worlds.size() == static_cast<std::size_t>(selection.limit)) break;
    worlds.push_back(world.read());
  }
  return worlds;
}

}  // namespace voronaut
