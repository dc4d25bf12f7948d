#include "voronaut/environments/formats/ir_sim.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "voronaut/environments/formats/csv_table.h"
#include "voronaut/environments/formats/foreign_yaml.h"
#include "voronaut/environments/generators/placement.h"

namespace voronaut {
namespace {

constexpr double kDefaultSide_m = 10;  // of IR-SIM's world
constexpr double kStandardRadius_m = 0.2;

// The keys that IR-SIM documents (docs/source/yaml_config). Most are about motion and plots and are
// not read; one that looks like a misspelt one of these would change the world.
const std::vector<std::string> kRootKeys = {"world", "robot", "obstacle", "gui", "custom", "irsim"};
const std::vector<std::string> kWorldKeys = {
    "name",         "height",      "width",   "step_time",          "sample_time",
    "offset",       "step_mode",   "status",  "control_mode",       "collision_mode",
    "obstacle_map", "mdownsample", "fog_map", "fog_map_resolution", "plot"};
const std::vector<std::string> kObjectKeys = {
    "number",     "distribution",   "shape",    "state",     "unobstructed", "goal",
    "name",       "kinematics",     "velocity", "state_dim", "vel_dim",      "group",
    "group_name", "vel_min",        "vel_max",  "acce",      "angle_range",  "goal_threshold",
    "behavior",   "group_behavior", "role",     "static",    "sensors",      "fov",
    "fov_radius", "arrive_mode",    "color",    "plot",      "description"};

struct Placed {
  Vec2 p = Vec2::Zero();
  double theta_rad = 0;

  Vec2 heading() const { return unit_vector(theta_rad); }
  Vec2 world(const Vec2& local) const { return p + turned(local, heading()); }
  Placed of(const Placed& inner) const { return {world(inner.p), theta_rad + inner.theta_rad}; }
};

// Where IR-SIM puts an object without a state, and where it sends one without a goal.
const Placed kStandardState{{1, 1}, 0};
const Placed kStandardGoal{{1, 9}, 0};

// [x, y], [x, y, theta] or longer: what comes after theta is not read, what is missing is 0.
Placed read_state(const ConfigNode& node) {
  const std::vector<ConfigNode> values = node.items();
  if (values.size() < 2) throw node.error("expected [x, y, theta]");
  Placed placed;
  placed.p = {values[0].number(-kFarthestCoordinate, kFarthestCoordinate),
              values[1].number(-kFarthestCoordinate, kFarthestCoordinate)};
  if (values.size() > 2) placed.theta_rad = values[2].number(-1e3, 1e3);
  return placed;
}

std::vector<ConfigNode> one_or_more(const std::optional<ConfigNode>& node) {
  if (!node) return {};
  return node->is_list() ? node->items() : std::vector{*node};
}

bool is_list_of_lists(const ConfigNode& node) {
  const auto items = node.items();
  return !items.empty() && items.front().is_list();
}

// Of a state, a list of states, or a list of lists of them.
Placed first_state(const ConfigNode& node) {
  return is_list_of_lists(node) ? first_state(node.items().front()) : read_state(node);
}

Vec2 read_xy(const ConfigNode& node) {
  const auto xy = node.numbers(2, "[x, y]", -kFarthestCoordinate, kFarthestCoordinate);
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

double size_of(const ConfigNode& shape, const char* key, double standard_m) {
  const auto size = find_given(shape, key);
  return size ? size->number(kSmallestRadius, kLargestRadius) : standard_m;
}

// A shape without a name is a circle. What is drawn at random is refused, and so are keys that
// would change the shape and are not read: a wheelbase moves it.
std::string kind_of(const ConfigNode& shape) {
  const std::vector<std::string> kinds = {"circle", "rectangle", "polygon", "linestring",
                                          "compound"};
  if (const auto random = find_given(shape, "random_shape"); random && read_yaml_flag(*random))
    throw random->error("a shape drawn at random is not read");
  shape.allow_only({"name", "radius", "center", "length", "width", "vertices", "parts", "pose",
                    "random_shape", "is_convex"});
  const auto name = find_given(shape, "name");
  return name ? kinds[name->choice(kinds)] : kinds.front();
}

void add_line(const ConfigNode& shape, const Placed& at, Shapes& shapes) {
  const auto corners = read_vertices(shape, at, 2);
  for (std::size_t i = 1; i < corners.size(); ++i) {
    if (corners[i] == corners[i - 1]) throw shape.error("repeats a vertex");
    shapes.segments.push_back({corners[i - 1], corners[i]});
  }
}

void add_shape(const ConfigNode& shape, const Placed& at, Shapes& shapes);

void add_parts(const ConfigNode& shape, const Placed& at, Shapes& shapes) {
  for (const ConfigNode& part : shape.child("parts").items()) {
    const auto pose = find_given(part, "pose");
    if (kind_of(part) == "compound") throw part.error("a compound in a compound");
    add_shape(part, pose ? at.of(read_state(*pose)) : at, shapes);
  }
}

void add_shape(const ConfigNode& shape, const Placed& at, Shapes& shapes) {
  const std::string kind = kind_of(shape);
  if (kind == "circle") {
    const auto center = find_given(shape, "center");
    const Vec2 p = at.world(center ? read_xy(*center) : Vec2(0, 0));
    shapes.circles.push_back({p, size_of(shape, "radius", kStandardRadius_m)});
  } else if (kind == "rectangle") {
    shapes.polygons.push_back(
        box(at.p, size_of(shape, "length", 1), size_of(shape, "width", 1), at.heading()));
  } else if (kind == "polygon") {
    shapes.polygons.push_back(read_polygon(shape, at));
  } else if (kind == "compound") {
    add_parts(shape, at, shapes);
  } else {
    add_line(shape, at, shapes);
  }
}

// The one of several, of which the last repeats.
template <class T>
const T& of_index(const std::vector<T>& values, std::size_t index) {
  return values[std::min(index, values.size() - 1)];
}

// `unobstructed` of one obstacle of the entry: nothing collides with it, and IR-SIM's lidar sees
// through it.
bool is_unobstructed(const ConfigNode& entry, std::size_t index) {
  const auto flags = one_or_more(find_given(entry, "unobstructed"));
  return !flags.empty() && read_yaml_flag(of_index(flags, index));
}

// Whether IR-SIM places the objects of the entry itself, at random or in a circle.
bool is_placed_by_rule(const ConfigNode& entry) {
  const auto distribution = find_given(entry, "distribution");
  const auto name = distribution ? find_given(*distribution, "name") : std::nullopt;
  return name && name->text() != "manual";
}

std::vector<Placed> read_states(const ConfigNode& entry) {
  const auto state = find_given(entry, "state");
  if (!state) return {kStandardState};
  if (!is_list_of_lists(*state)) return {read_state(*state)};
  std::vector<Placed> states;
  for (const ConfigNode& item : state->items()) states.push_back(read_state(item));
  return states;
}

void add_obstacles(const ConfigNode& entry, Shapes& shapes) {
  refuse_misspelt(entry, kObjectKeys);
  if (is_placed_by_rule(entry))
    throw entry.child("distribution")
        .error(
            "obstacles that IR-SIM places itself, at random or in a circle, are not read: give "
            "manual and their states");
  const auto kinds = one_or_more(find_given(entry, "shape"));
  for (const ConfigNode& kind : kinds) kind_of(kind);
  const auto number = find_given(entry, "number");
  const auto count = number ? static_cast<std::size_t>(number->whole_number(0, 10'000)) : 1;
  const std::vector<Placed> states = read_states(entry);
  for (std::size_t i = 0; i < count; ++i) {
    if (is_unobstructed(entry, i)) continue;
    if (kinds.empty())
      shapes.circles.push_back({of_index(states, i).p, kStandardRadius_m});
    else
      add_shape(of_index(kinds, i), of_index(states, i), shapes);
  }
}

// What a robot is, where it is one disc about its origin or one convex polygon around it. Shapes
// that are not read for obstacles either tell nothing, so neither do those with a wheelbase, which
// moves a body ahead of its rear axle.
std::optional<RobotBody> body_of(const std::vector<ConfigNode>& kinds) {
  if (kinds.empty()) return RobotBody{kStandardRadius_m};
  const ConfigNode& shape = kinds.front();
  Shapes alone;
  try {
    add_shape(shape, {}, alone);
  } catch (const ConfigError&) {
    return std::nullopt;
  }
  if (alone.size() != 1 || !alone.segments.empty()) return std::nullopt;
  if (!alone.circles.empty()) {
    const Circle& disc = alone.circles.front();
    if (disc.center != Vec2(0, 0)) return std::nullopt;
    return RobotBody{disc.radius_m};
  }
  RobotBody body{0, alone.polygons.front().vertices};
  if (!body_problem(body.corners_body).empty()) return std::nullopt;
  return body;
}

// The first robot that IR-SIM does not place itself.
void read_robot(const std::vector<ConfigNode>& robots, ForeignWorld& read) {
  for (const ConfigNode& robot : robots) {
    refuse_misspelt(robot, kObjectKeys);
    if (read.start || is_placed_by_rule(robot)) continue;
    const auto state = find_given(robot, "state");
    const auto goal = find_given(robot, "goal");
    const Placed start = state ? first_state(*state) : kStandardState;
    read.start = start.p;
    read.start_heading_rad = start.theta_rad;
    read.goal = (goal ? first_state(*goal) : kStandardGoal).p;
    read.robot = body_of(one_or_more(find_given(robot, "shape")));
  }
}

Bounds read_world(const std::optional<ConfigNode>& world) {
  if (!world) return {{0, 0}, {kDefaultSide_m, kDefaultSide_m}};
  refuse_misspelt(*world, kWorldKeys);
  if (const auto map = find_given(*world, "obstacle_map"))
    throw map->error("an obstacle map is not read");
  const auto side_m = [&](const char* key) {
    const auto side = find_given(*world, key);
    return side ? side->number(kSmallestRadius, kFarthestCoordinate) : kDefaultSide_m;
  };
  const auto offset = find_given(*world, "offset");
  const Vec2 lower_left = offset ? read_xy(*offset) : Vec2(0, 0);
  return {lower_left, lower_left + Vec2(side_m("width"), side_m("height"))};
}

}  // namespace

ForeignWorld read_ir_sim(const ConfigNode& root) {
  if (const auto nested = find_given(root, "irsim")) return read_ir_sim(*nested);
  refuse_misspelt(root, kRootKeys);
  ForeignWorld read;
  read.bounds = read_world(find_given(root, "world"));
  for (const ConfigNode& entry : one_or_more(find_given(root, "obstacle")))
    add_obstacles(entry, read.shapes);
  read_robot(one_or_more(find_given(root, "robot")), read);
  return read;
}

}  // namespace voronaut
