#include "voronaut/environments/scenario/scenario_spec.h"

#include <cstdlib>
#include <utility>

#include "voronaut/environments/config/config_node.h"
#include "voronaut/environments/generators/placement.h"
#include "voronaut/environments/world.h"

namespace voronaut {
namespace {

std::string point_text(const Vec2& p) {
  return "(" + number_text(p.x()) + ", " + number_text(p.y()) + ")";
}

std::string world_text(const World& world) {
  std::string text = "bounds " + point_text(world.bounds().min) + point_text(world.bounds().max);
  for (const Circle& circle : world.shapes().circles)
    text += ";circle " + point_text(circle.center) + number_text(circle.radius_m);
  for (const Segment& segment : world.shapes().segments)
    text += ";segment " + point_text(segment.a) + point_text(segment.b);
  for (const Polygon& polygon : world.shapes().polygons) {
    text += ";polygon ";
    for (const Vec2& vertex : polygon.vertices) text += point_text(vertex);
  }
  return text;
}

std::string robot_text(const RobotBody& robot) {
  std::string text = "robot " + number_text(robot.radius_m);
  for (const Vec2& corner : robot.corners_body) text += point_text(corner);
  return text + ";";
}

Scenario scenario_of(const TaskConfig& task, std::shared_ptr<const World> world, const Vec2& start,
                     const Vec2& goal, std::optional<double> heading_rad) {
  Scenario scenario;
  scenario.name = task.name;
  scenario.group = task.group;
  scenario.world = std::move(world);
  scenario.start_world = start;
  scenario.start_height_m = task.start_height_m;
  scenario.cruise_height_m = task.cruise_height_m;
  scenario.goal_world = goal;
  scenario.goal_tolerance_m = task.goal_tolerance_m;
  scenario.barn_length_m = task.barn_length_m;
  scenario.robot = task.robot;
  if (heading_rad)
    scenario.start_heading = unit_vector(*heading_rad);
  else if (start != goal)
    scenario.start_heading = (goal - start).normalized();
  return scenario;
}

}  // namespace

DataLocation DataLocation::find(const std::string& data_argument) {
  if (!data_argument.empty()) return {data_argument, "--data"};
  const char* variable = std::getenv("VORONAUT_DATA");
  if (variable != nullptr && *variable != '\0') return {variable, "VORONAUT_DATA"};
  return {};
}

std::string placement_problem(const World& world, const Vec2& p) {
  if (!world.bounds().contains(p))
    return point_text(p) + " lies outside the bounds " + point_text(world.bounds().min) + " to " +
           point_text(world.bounds().max);
  if (world.clearance_m(p) <= 0) return point_text(p) + " lies inside an obstacle";
  return "";
}

ScenarioSpec ScenarioSpec::fixed(TaskConfig task, std::shared_ptr<const World> world,
                                 const Vec2& start, const Vec2& goal,
                                 std::optional<double> start_heading_rad) {
  ScenarioSpec spec;
  spec.task_ = std::move(task);
  spec.start_heading_rad_ = start_heading_rad;
  spec.world_ = std::move(world);
  spec.start_ = start;
  spec.goal_ = goal;
  return spec;
}

ScenarioSpec ScenarioSpec::generated(TaskConfig task, WorldGenerator generator,
                                     std::optional<double> start_heading_rad) {
  ScenarioSpec spec;
  spec.task_ = std::move(task);
  spec.start_heading_rad_ = start_heading_rad;
  spec.generator_ = std::move(generator);
  return spec;
}

ScenarioSpec ScenarioSpec::admitting(double planning_clearance_m) const {
  ScenarioSpec spec = *this;
  if (spec.generator_) spec.generator_->admit_for(planning_clearance_m);
  return spec;
}

std::string ScenarioSpec::definition() const {
  TaskConfig ungrouped = task_;
  ungrouped.group.clear();
  std::string text = canonical_text(ungrouped);
  if (start_heading_rad_) text += "start_heading_rad=" + number_text(*start_heading_rad_) + ";";
  if (task_.barn_length_m > 0) text += "barn_length_m=" + number_text(task_.barn_length_m) + ";";
  if (task_.robot) text += robot_text(*task_.robot);
  if (generator_) return text + canonical_text(generator_->entries());
  return text + "start " + point_text(start_) + ";goal " + point_text(goal_) + ";" +
         world_text(*world_) + ";";
}

Scenario ScenarioSpec::instantiate(std::uint64_t world_seed) const {
  if (!generator_) return scenario_of(task_, world_, start_, goal_, start_heading_rad_);
  const GeneratedWorld drawn = generator_->generate(world_seed);
  auto world = std::make_shared<const World>(drawn.bounds, drawn.shapes);
  for (const Vec2& p : {drawn.start, drawn.goal})
    if (const std::string problem = placement_problem(*world, p); !problem.empty())
      throw generator_->error("seed " + std::to_string(world_seed) + ": " + problem);
  return scenario_of(task_, std::move(world), drawn.start, drawn.goal, start_heading_rad_);
}

}  // namespace voronaut
