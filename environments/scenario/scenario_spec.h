#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "voronaut/environments/generators/world_generators.h"
#include "voronaut/environments/scenario/scenario.h"

// A source of scenarios: it describes one or, with a generator, one for every seed.
namespace voronaut {

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
  double barn_length_m = 0;  // of a course of BARN, as its data set tells; 0: no course of it
  std::optional<RobotBody> robot = std::nullopt;  // as the scenario's file tells it

  template <class Visitor>
  void visit(Visitor& v) {
    v.text("name", name,
           "Of the scenario; a file's is called like the file, a generator's like its family");
    v.text("group", group, "What is reported together; nothing: the name");
    v.number("start_height_m", start_height_m, 0, 100, "Height at which it starts");
    v.number("cruise_height_m", cruise_height_m, 0, 100,
             "Height at which it flies; wheeled vehicles drive at 0");
    v.number("goal_tolerance_m", goal_tolerance_m, 0.01, 10,
             "An arrival is closer to the goal than this");
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

  // The same for vehicles of which none keeps more than this when planning
  // (WorldGenerator::admit_for).
  ScenarioSpec admitting(double planning_clearance_m) const;

  const std::string& name() const { return task_.name; }
  const std::string& group() const { return task_.group; }
  const std::optional<RobotBody>& robot() const { return task_.robot; }
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

}  // namespace voronaut
