#include "voronaut/environments/formats/ir_sim.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "voronaut/environments/config/nearest_name.h"
#include "voronaut/environments/formats/csv_table.h"
#include "voronaut/environments/formats/yaml_flag.h"
#include "voronaut/environments/generators/placement.h"

namespace voronaut {
namespace {

constexpr double kFar = kFarthestCoordinate;
constexpr double kDefaultSide_m = 10;  // of IR-SIM's world

// The keys that IR-SIM documents (docs/source/yaml_config). Most are about motion and plots and are
// not read; any other may be a slip that changes the world.
const std::vector<std::string> kWorldKeys = {
    "name",         "height",         "width",  "step_time",    "sample_time", "offset",
    "control_mode", "collision_mode", "status", "obstacle_map", "mdownsample", "plot"};
const std::vector<std::string> kObjectKeys = {
    "number",      "distribution",   "shape",      "state",          "unobstructed",
    "goal",        "name",           "kinematics", "velocity",       "state_dim",
    "vel_dim",     "group",          "vel_min",    "vel_max",        "acce",
    "angle_range", "goal_threshold", "behavior",   "group_behavior", "role",
    "static",      "sensors",        "fov",        "fov_radius",     "arrive_mode",
    "color",       "plot",           "description"};

struct Placed {
  Vec2 p = Vec2::Zero();
  Vec2 heading = Vec2::UnitX();

  Vec2 world(const Vec2& local) const { return p + turned(local, heading); }
};

// [x, y], [x, y, theta] or longer; what comes after theta is not read.
Placed read_state(const ConfigNode& node) {
  const std::vector<ConfigNode> values = node.items();
  if (values.size() < 2) throw node.error("expected [x, y, theta]");
  Placed placed;
  placed.p = {values[0].number(-kFar, kFar), values[1].number(-kFar, kFar)};
  if (values.size() > 2) placed.heading = unit_vector(values[2].number(-1e3, 1e3));
  return placed;
}

std::vector<ConfigNode> one_or_more(const ConfigNode& node) {
  return node.is_list() ? node.items() : std::vector{node};
}

bool is_list_of_lists(const ConfigNode& node) {
  const auto items = node.items();
  return !items.empty() && items.front().is_list();
}

Vec2 read_xy(const ConfigNode& node) {
  const auto xy = node.numbers(2, "[x, y]", -kFar, kFar);
  return {xy[0], xy[1]};
}

std::vector<Vec2> read_vertices(const ConfigNode& shape, const Placed& at, std::size_t at_least) {
  const ConfigNode node = shape.child("vertices");
  std::vector<Vec2> vertices;
  for (const ConfigNode& item : node.items()) vertices.push_back(at.world(read_xy(item)));
  if (vertices.size() < at_least)
    throw node.error("expected at least " + std::to_string(at_least) + " vertices");
  return vertices;
}

Polygon read_polygon(const ConfigNode& shape, const Placed& at) {
  Shapes alone;
  alone.polygons.push_back({read_vertices(shape, at, 3)});
  auto& vertices = alone.polygons.front().vertices;
  if (vertices.front() == vertices.back()) vertices.pop_back();
  try {
    return validated(std::move(alone)).polygons.front();
  } catch (const std::invalid_argument& error) {
    throw shape.error(error.what());
  }
}

// Refuses what is drawn at random, and keys that would change the shape and are not read: a
// wheelbase moves it.
void check_shape(const ConfigNode& shape) {
  if (const auto random = shape.find("random_shape"); random && read_yaml_flag(*random))
    throw random->error("a shape drawn at random is not read");
  shape.allow_only(
      {"name", "radius", "center", "length", "width", "vertices", "random_shape", "is_convex"});
}

void add_shape(const ConfigNode& shape, const Placed& at, Shapes& shapes) {
  const std::vector<std::string> kinds = {"circle", "rectangle", "polygon", "linestring"};
  const std::string& kind = kinds[shape.child("name").choice(kinds)];
  if (kind == "circle") {
    const auto center = shape.find("center");
    const Vec2 p = at.world(center ? read_xy(*center) : Vec2(0, 0));
    shapes.circles.push_back({p, shape.child("radius").number(kSmallestRadius, kLargestRadius)});
  } else if (kind == "rectangle") {
    const double length_m = shape.child("length").number(kSmallestRadius, kLargestRadius);
    const double width_m = shape.child("width").number(kSmallestRadius, kLargestRadius);
    shapes.polygons.push_back(box(at.p, length_m, width_m, at.heading));
  } else if (kind == "polygon") {
    shapes.polygons.push_back(read_polygon(shape, at));
  } else {
    const auto corners = read_vertices(shape, at, 2);
    for (std::size_t i = 1; i < corners.size(); ++i) {
      if (corners[i] == corners[i - 1]) throw shape.error("repeats a vertex");
      shapes.segments.push_back({corners[i - 1], corners[i]});
    }
  }
}

// `unobstructed` of one obstacle of the entry: nothing collides with it, and IR-SIM's lidar sees
// through it.
bool is_unobstructed(const ConfigNode& entry, std::size_t index) {
  const auto node = entry.find("unobstructed");
  if (!node) return false;
  const auto flags = one_or_more(*node);
  return !flags.empty() && read_yaml_flag(flags[std::min(index, flags.size() - 1)]);
}

void add_obstacles(const ConfigNode& entry, Shapes& shapes) {
  entry.allow_only(kObjectKeys);
  if (const auto distribution = entry.find("distribution");
      distribution && distribution->child("name").text() != "manual")
    throw distribution->error(
        "obstacles that IR-SIM places itself, at random or in a circle, are not read: give manual "
        "and their states");
  const auto kinds = one_or_more(entry.child("shape"));
  if (kinds.empty()) throw entry.child("shape").error("expected a shape");
  for (const ConfigNode& kind : kinds) check_shape(kind);
  const auto number = entry.find("number");
  const auto count = number ? static_cast<std::size_t>(number->whole_number(1, 10'000)) : 1;
  std::vector<Placed> places;
  if (const auto state = entry.find("state")) {
    if (is_list_of_lists(*state))
      for (const ConfigNode& item : state->items()) places.push_back(read_state(item));
    else
      places.push_back(read_state(*state));
  } else if (!number) {
    places.emplace_back();
  }
  if (places.size() < count)
    throw entry.error("expected a state for each of " + std::to_string(count) + " obstacles");
  for (std::size_t i = 0; i < count; ++i)
    if (!is_unobstructed(entry, i))
      add_shape(kinds[std::min(i, kinds.size() - 1)], places[i], shapes);
}

std::optional<Vec2> first_place(const ConfigNode& robot, const char* key) {
  const auto node = robot.find(key);
  if (!node) return std::nullopt;
  return read_state(is_list_of_lists(*node) ? node->items().front() : *node).p;
}

Bounds read_world(const std::optional<ConfigNode>& world) {
  if (!world) return {{0, 0}, {kDefaultSide_m, kDefaultSide_m}};
  world->allow_only(kWorldKeys);
  if (const auto map = world->find("obstacle_map")) throw map->error("an obstacle map is not read");
  const auto side_m = [&](const char* key) {
    const auto side = world->find(key);
    return side ? side->number(kSmallestRadius, kFar) : kDefaultSide_m;
  };
  const auto offset = world->find("offset");
  const Vec2 lower_left = offset ? read_xy(*offset) : Vec2(0, 0);
  return {lower_left, lower_left + Vec2(side_m("width"), side_m("height"))};
}

}  // namespace

ForeignWorld read_ir_sim(const ConfigNode& root) {
  root.allow_only({"world", "robot", "obstacle", "gui"});
  ForeignWorld read;
  read.bounds = read_world(root.find("world"));
  if (const auto obstacles = root.find("obstacle"))
    for (const ConfigNode& entry : one_or_more(*obstacles)) add_obstacles(entry, read.shapes);
  const auto robots = root.find("robot");
  for (const ConfigNode& robot : robots ? one_or_more(*robots) : std::vector<ConfigNode>{}) {
    read.start = first_place(robot, "state");
    read.goal = first_place(robot, "goal");
    if (read.start && read.goal) break;
  }
  return read;
}

}  // namespace voronaut
