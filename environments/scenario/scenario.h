#pragma once

#include <memory>
#include <optional>
#include <string>

#include "voronaut/environments/shapes/geometry.h"
#include "voronaut/environments/shapes/robot_body.h"

namespace voronaut {

class World;

// What is flown: a world, a start and a goal.
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
  std::optional<RobotBody> robot;  // of the file that it comes from, if that tells of one
  double barn_length_m = 0;        // what the BARN challenge counts by; 0: no course of it
};

}  // namespace voronaut
