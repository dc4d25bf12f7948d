#include "voronaut/environments/scenario_files/scenario_fields.h"

#include <cmath>
#include <filesystem>
#include <string_view>

#include "voronaut/environments/config/config_reader.h"
#include "voronaut/environments/config/file_session.h"
#include "voronaut/environments/config/input_file.h"
#include "voronaut/environments/config/label.h"
#include "voronaut/environments/config/nearest_name.h"
#include "voronaut/environments/formats/csv_table.h"
#include "voronaut/environments/scenario_files/scenario_keys.h"
#include "voronaut/environments/world.h"

namespace voronaut {
namespace {

void require_plain(const std::string& name, const ConfigNode& place) {
  constexpr std::string_view kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-.+";
  if (name.empty() || name.size() > kLabelBytesMax ||
      name.find_first_not_of(kPlain) != std::string::npos)
    throw place.error("expected a name of letters, digits and _-.+, at most " +
                      std::to_string(kLabelBytesMax) + ", got " +
                      in_quotes(name.substr(0, kLabelBytesMax)));
}

}  // namespace

Vec2 read_point(const ConfigNode& node) {
  const std::vector<double> xy =
      node.numbers(2, "[x, y]", -kFarthestCoordinate, kFarthestCoordinate);
  return {xy[0], xy[1]};
}

Bounds read_bounds(const ConfigNode& node) {
  const std::vector<ConfigNode> corners = node.items(2, "[[xmin, ymin], [xmax, ymax]]");
  Bounds bounds{read_point(corners[0]), read_point(corners[1])};
  if (!(bounds.min.array() < bounds.max.array()).all())
    throw node.error("expected [[xmin, ymin], [xmax, ymax]] with xmin < xmax and ymin < ymax");
  const Vec2 size_m = bounds.max - bounds.min;
  if (size_m.maxCoeff() > kWidestBounds_m)
    throw node.error("expected bounds up to " + number_text(kWidestBounds_m) + " m each way, got " +
                     number_text(size_m.x()) + " x " + number_text(size_m.y()) + " m");
  return bounds;
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
  HeadingConfig heading;
  read_present_keys(entry, keys_of(heading));
  if (std::isnan(heading.start_heading_rad)) return std::nullopt;
  return heading.start_heading_rad;
}

std::string existing_file(const ConfigNode& node) {
  std::string path = node.beside(node.text());
  std::error_code ignored;
  if (FileSession::copy_of(path) != nullptr) return path;
  if (!std::filesystem::exists(path, ignored)) throw node.error("no file " + in_quotes(path));
  if (const std::string problem = input_file_problem(path); !problem.empty())
    throw node.error(in_quotes(path) + " cannot be read (" + problem + ")");
  return path;
}

std::string stem(const std::string& path) { return std::filesystem::path(path).stem().string(); }

ScenarioSpec placed_scenario(const TaskConfig& task, const std::shared_ptr<const World>& world,
                             const Vec2& start, const Vec2& goal, const ConfigNode& entry,
                             const ConfigNode& place, std::optional<double> heading_of_file_rad) {
  const auto require_placed = [&](const char* key, const Vec2& p) {
    const std::string problem = placement_problem(*world, p);
    if (problem.empty()) return;
    if (const auto given = entry.find(key)) throw given->error(problem);
    throw place.error(task.name + ": " + key + " " + problem);
  };
  require_placed("start", start);
  require_placed("goal", goal);
  const auto heading_rad = read_heading(entry);
  return ScenarioSpec::fixed(task, world, start, goal,
                             heading_rad ? heading_rad : heading_of_file_rad);
}

}  // namespace voronaut
