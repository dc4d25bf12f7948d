#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "voronaut/environments/config/config_node.h"
#include "voronaut/environments/generators/world_generators.h"
#include "voronaut/environments/shapes/geometry.h"
#include "voronaut/environments/shapes/shapes.h"

// What is flown: a world, a start and a goal. A scenario source describes one or, with a generator,
// one for every seed.
namespace voronaut {

class World;

struct Scenario {
  std::string name;
  std::string group;  // what is reported together, like all worlds of one data set
  std::shared_ptr<const World> world;
  Vec2 start_world = Vec2::Zero();
  double start_height_m = 0;
  double cruise_height_m = 1;
  Vec2 goal_world = Vec2::Zero();
  Vec2 start_heading = Vec2::UnitX();  // unit; towards the goal unless the source says otherwise
  double goal_tolerance_m = 0.2;
};

// Where foreign data sets lie: one folder with a folder for each of them inside.
struct DataLocation {
  std::string folder;  // empty: not given
  std::string origin;  // who named it, for messages: "--data" or "VORONAUT_DATA"

  // The argument if it is not empty, else the environment variable VORONAUT_DATA if it is set.
  static DataLocation find(const std::string& data_argument);
};

// What a source says beside the world, its start and its goal.
struct TaskConfig {
  std::string name;
  std::string group;
  double start_height_m = 0;
  double cruise_height_m = 1;
  double goal_tolerance_m = 0.2;

  template <class Visitor>
  void visit(Visitor& v) {
    v.text("name", name);
    v.text("group", group);
    v.number("start_height_m", start_height_m, 0, 100);
    v.number("cruise_height_m", cruise_height_m, 0, 100);
    v.number("goal_tolerance_m", goal_tolerance_m, 0.01, 10);
  }
};

// A parsed and checked source of scenarios. Immutable; copies share the world.
class ScenarioSpec {
 public:
  // One world for every seed. Start and goal must be well placed (placement_problem).
  static ScenarioSpec fixed(TaskConfig task, std::shared_ptr<const World> world, const Vec2& start,
                            const Vec2& goal, std::optional<double> start_heading_rad = {});
  // A new world for every seed.
  static ScenarioSpec generated(TaskConfig task, WorldGenerator generator,
                                std::optional<double> start_heading_rad = {});

  const std::string& name() const { return task_.name; }
  const std::string& group() const { return task_.group; }
  // Whether the world depends on the seed.
  bool random() const { return generator_.has_value(); }
  // Everything that decides what instantiate() returns, the group apart, as text: equal texts,
  // equal scenarios. Long for a fixed world (it lists every shape), meant to be hashed.
  std::string definition() const;

  // Throws ConfigError if a generator finds no world, or places start or goal badly.
  Scenario instantiate(std::uint64_t world_seed) const;

 private:
  TaskConfig task_;
  std::optional<double> start_heading_rad_;
  std::optional<WorldGenerator> generator_;
  std::shared_ptr<const World> world_;  // fixed ones have it, with
  Vec2 start_ = Vec2::Zero();
  Vec2 goal_ = Vec2::Zero();
};

// What is wrong with a start or goal there, "" if nothing: "(9, 0) lies outside the bounds ...",
// "(0, 0) lies inside an obstacle". The body's radius is the trial's business.
std::string placement_problem(const World& world, const Vec2& p);

// Reads one entry of a list of scenarios, or the root of a scenario file. It is one of
//   file: other.yaml            a scenario file, beside the file that names it
//   world: {circles: [[x, y, r], ..], boxes: [[xmin, ymin, xmax, ymax], ..],
//           polygons: [[[x, y], ..], ..], segments: [[[x, y], [x, y]], ..],
//           wkt: "POLYGON((..))"}, or a list of such texts (formats/wkt.h)
//   world_file: arena.map       a foreign file (formats/foreign_formats.h), beside the file that
//                               names it; `format` where the file does not tell; `bounds`, `start`
//                               and `goal` where it has none or others are wanted, or
//                               `queries: arena.map.scen`, or
//                               `queries: {file: arena.map.scen, pick: [17]}`, or a selection
//                               (formats/query_selection.h) instead of `pick`
//   generator: {name: forest, density_per_m2: 0.1, ..}
//   dataset: barn               (formats/data_sets.h) one scenario for each world, or those of
//                               `pick`, or of the selection `queries`, up to `limit`
// `world` needs bounds: [[xmin, ymin], [xmax, ymax]], start: [x, y], goal: [x, y]. All but `file`
// take the keys of TaskConfig, all but `dataset` start_heading_rad. Throws ConfigError.
std::vector<ScenarioSpec> read_scenarios(const ConfigNode& entry, const DataLocation& data);

}  // namespace voronaut
