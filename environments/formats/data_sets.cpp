#include "voronaut/environments/formats/data_sets.h"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <optional>
#include <utility>

#include "voronaut/environments/config/file_session.h"
#include "voronaut/environments/config/nearest_name.h"
#include "voronaut/environments/formats/csv_table.h"
#include "voronaut/environments/formats/foreign_formats.h"
#include "voronaut/environments/formats/movingai.h"
#include "voronaut/environments/world.h"

namespace voronaut {
namespace {

// One world that an index lists, with the ways through it; its own file is read only if it is
// selected.
struct Course {
  std::string name;
  std::vector<ForeignQuery> queries;  // one without a name: it is called like the course
  std::function<ForeignWorld()> read;
  double barn_length_m = 0;

  std::string name_of(const ForeignQuery& query) const {
    return query.name.empty() ? name : name + "_" + query.name;
  }
};

using Courses = std::vector<Course>;

Courses list_barn(const std::string& folder, const ForeignOptions&) {
  const auto table = CsvTable::read(folder + "/worlds.csv", {"world", "start_x", "start_y",
                                                             "goal_x", "goal_y", "ref_path_len_m"});
  Courses courses;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    std::string number = table.text(row, "world");
    number.insert(0, 3 - std::min<std::size_t>(number.size(), 3), '0');
    ForeignQuery query;
    query.start = {table.number(row, "start_x", -kFarthestCoordinate, kFarthestCoordinate),
                   table.number(row, "start_y", -kFarthestCoordinate, kFarthestCoordinate)};
    query.goal = {table.number(row, "goal_x", -kFarthestCoordinate, kFarthestCoordinate),
                  table.number(row, "goal_y", -kFarthestCoordinate, kFarthestCoordinate)};
    std::string file = folder;
    file.append("/obstacles/world_").append(number).append(".csv");
    courses.push_back({"barn_" + number,
                       {query},
                       [file] {
                         ForeignWorld world;
                         world.bounds = Bounds{{-4.5, 0}, {0, 14}};
                         world.shapes.circles = read_circles_csv(file);
                         return world;
                       },
                       table.number(row, "ref_path_len_m", 0, kFarthestCoordinate)});
  }
  return courses;
}

Courses list_dodgedrone(const std::string& folder, const ForeignOptions&) {
  const auto table = CsvTable::read(folder + "/index.csv", {"env"});
  Courses courses;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const std::string& environment = table.text(row, "env");
    ForeignQuery query;
    query.goal = {18, 0};
    std::string file = folder;
    file.append("/").append(environment).append("/slice_z1.csv");
    courses.push_back({"dodgedrone_" + environment, {query}, [file] {
                         ForeignWorld world;
                         world.bounds = Bounds{{-2, -12}, {20, 12}};
                         world.shapes.circles = read_circles_csv(file);
                         return world;
                       }});
  }
  return courses;
}

Courses list_movingai(const std::string& folder, const ForeignOptions& options) {
  const auto table = CsvTable::read(folder + "/index.csv", {"family", "map", "width", "height"});
  constexpr int kLongest = BlockedCells::kLongestSide;
  Courses courses;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const std::string& map = table.text(row, "map");
    std::string file = folder;
    file.append("/").append(table.text(row, "family")).append("/").append(map).append(".map");
    const CellFrame frame{static_cast<int>(table.number(row, "width", 1, kLongest)),
                          static_cast<int>(table.number(row, "height", 1, kLongest)),
                          options.cell_size_m};
    const std::string queries = file + ".scen";
    courses.push_back(
        {"movingai_" + map,
         parse_movingai_scen(read_text_file(queries), queries, frame, map + ".map"),
         [file, options] { return foreign_format("movingai", file).read(file, options); }});
  }
  return courses;
}

Courses list_mrpb(const std::string& folder, const ForeignOptions& options) {
  const std::string index = folder + "/queries.csv";
  const auto table = CsvTable::read(index, {"map", "query", "xmin", "xmax", "ymin", "ymax",
                                            "start_x", "start_y", "goal_x", "goal_y"});
  Courses courses;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const std::string& map = table.text(row, "map");
    const std::string name = "mrpb_" + map;
    if (courses.empty() || courses.back().name != name) {
      const std::string file = folder + "/" + map + "/map.yaml";
      const Bounds bounds{{table.number(row, "xmin", -kFarthestCoordinate, kFarthestCoordinate),
                           table.number(row, "ymin", -kFarthestCoordinate, kFarthestCoordinate)},
                          {table.number(row, "xmax", -kFarthestCoordinate, kFarthestCoordinate),
                           table.number(row, "ymax", -kFarthestCoordinate, kFarthestCoordinate)}};
      courses.push_back({name, {}, [file, options, bounds] {
                           ForeignWorld world = foreign_format("ros_map", file).read(file, options);
                           world.bounds = bounds;
                           return world;
                         }});
    }
    ForeignQuery query;
    query.name = table.text(row, "query");
    query.start = {table.number(row, "start_x", -kFarthestCoordinate, kFarthestCoordinate),
                   table.number(row, "start_y", -kFarthestCoordinate, kFarthestCoordinate)};
    query.goal = {table.number(row, "goal_x", -kFarthestCoordinate, kFarthestCoordinate),
                  table.number(row, "goal_y", -kFarthestCoordinate, kFarthestCoordinate)};
    courses.back().queries.push_back(query);
  }
  return courses;
}

struct DataSet {
  std::string name;
  DataSetTraits traits;
  Courses (*list)(const std::string& folder, const ForeignOptions& options);
};

DataSetTraits movingai_traits() {
  DataSetTraits traits;
  traits.queries.sample = 2;
  traits.queries.clearance_m = 0.42;
  traits.queries.shortest_m = 5;
  traits.queries.longest_m = 60;
  traits.options = {"cell_size_m"};
  return traits;
}

const std::vector<DataSet>& data_sets() {
  static const std::vector<DataSet> all = {{"barn", {}, list_barn},
                                           {"dodgedrone", {}, list_dodgedrone},
                                           {"movingai", movingai_traits(), list_movingai},
                                           {"mrpb", {{}, {"unknown"}}, list_mrpb}};
  return all;
}

const DataSet* find_data_set(const std::string& name) {
  const auto set = std::find_if(data_sets().begin(), data_sets().end(),
                                [&name](const DataSet& one) { return one.name == name; });
  return set == data_sets().end() ? nullptr : &*set;
}

std::string folder_of(const std::string& name, const DataLocation& data, const ConfigNode& place) {
  const std::string remedy = "give --data DIR or set VORONAUT_DATA";
  if (data.folder.empty())
    throw place.error("'" + name + "' lies in the data folder, which is not known: " + remedy);
  std::string folder = (std::filesystem::path(data.folder) / name).string();
  std::error_code ignored;
  if (!FileSession::has_copies() && !std::filesystem::is_directory(folder, ignored))
    throw place.error("no folder " + in_quotes(folder) + " (data folder from " + data.origin +
                      "; " + remedy + ")");
  return folder;
}

// The worlds of courses, each read once.
class CourseWorlds {
 public:
  std::shared_ptr<const World> of(const Course& course) {
    for (const auto& [name, world] : read_)
      if (name == course.name) return world;
    ForeignWorld read = course.read();
    read_.emplace_back(course.name,
                       std::make_shared<const World>(read.bounds.value(), read.shapes));
    return read_.back().second;
  }

 private:
  std::vector<std::pair<std::string, std::shared_ptr<const World>>> read_;
};

std::vector<DataSetWorld> picked_worlds(const Courses& courses,
                                        const std::vector<std::string>& picks,
                                        const ConfigNode& place) {
  std::vector<std::string> names;
  std::vector<std::pair<const Course*, const ForeignQuery*>> ways;
  for (const Course& course : courses) {
    for (const ForeignQuery& query : course.queries) {
      names.push_back(course.name_of(query));
      ways.emplace_back(&course, &query);
    }
  }
  CourseWorlds worlds;
  std::vector<DataSetWorld> picked;
  for (const std::string& name : picks) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) {
      const auto meant = nearest_name(name, names);
      throw place.error("no world " + in_quotes(name) + " among the " +
                        std::to_string(names.size()) + " of this data set" +
                        (meant ? " (did you mean '" + *meant + "'?)" : ""));
    }
    const auto& [course, query] = ways[static_cast<std::size_t>(found - names.begin())];
    picked.push_back({name, worlds.of(*course), query->start, query->goal, course->barn_length_m});
  }
  return picked;
}

}  // namespace

std::vector<std::string> data_set_names() {
  std::vector<std::string> names;
  for (const DataSet& set : data_sets()) names.push_back(set.name);
  return names;
}

DataSetTraits data_set_traits(const std::string& name) {
  const DataSet* set = find_data_set(name);
  return set == nullptr ? DataSetTraits{} : set->traits;
}

std::vector<DataSetWorld> read_data_set(const std::string& name, const DataSetSelection& selection,
                                        const DataLocation& data, const ConfigNode& place) {
  const DataSet* set = find_data_set(name);
  if (set == nullptr)
    throw place.error("no data set " + in_quotes(name) + allowed_names(name, data_set_names()));
  const Courses courses = set->list(folder_of(name, data, place), selection.options);
  if (!selection.pick.empty()) return picked_worlds(courses, selection.pick, place);
  const std::size_t limit =
      selection.limit > 0 ? static_cast<std::size_t>(selection.limit) : std::size_t(-1);
  CourseWorlds read;
  std::vector<DataSetWorld> worlds;
  for (const Course& course : courses) {
    if (worlds.size() >= limit) break;
    const auto world = read.of(course);
    for (const ForeignQuery& query :
         select_queries(course.queries, selection.queries, *world, course.name))
      if (worlds.size() < limit)
        worlds.push_back(
            {course.name_of(query), world, query.start, query.goal, course.barn_length_m});
  }
  return worlds;
}

}  // namespace voronaut
