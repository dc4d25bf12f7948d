#pragma once

#include "voronaut/environments/generators/generated_world.h"

// Concave walls in which a planner without memory stays. The goal lies along +x unless said.
namespace voronaut {

// A U, open towards the start, across the straight way.
struct UTrapConfig {
  double width_min_m = 3;
  double width_max_m = 6;
  double depth_min_m = 2;
  double depth_max_m = 5;
  double shift_max_m = 1;

  template <class Visitor>
  void visit(Visitor& v) {
    v.number("width_min_m", width_min_m, 1, 50, "Narrowest U");
    v.number("width_max_m", width_max_m, 1, 50, "Widest U");
    v.number("depth_min_m", depth_min_m, 0.5, 50, "Shallowest U");
    v.number("depth_max_m", depth_max_m, 0.5, 50, "Deepest U");
    v.number("shift_max_m", shift_max_m, 0, 20,
             "Of the U's axis from the straight way, to either side");
  }
};

// A room around the start whose only door faces away from the goal, with lips that lead inwards.
struct BugTrapConfig {
  double side_min_m = 5;
  double side_max_m = 8;
  double door_min_m = 1.2;
  double door_max_m = 1.8;
  double lip_m = 1.5;

  template <class Visitor>
  void visit(Visitor& v) {
    v.number("side_min_m", side_min_m, 4, 50, "Smallest room");
    v.number("side_max_m", side_max_m, 4, 50, "Largest room");
    v.number("door_min_m", door_min_m, 0.2, 3, "Narrowest door, free width");
    v.number("door_max_m", door_max_m, 0.2, 3, "Widest door, free width");
    v.number("lip_m", lip_m, 0, 3, "Length of the walls that lead inwards from the door");
  }
};

// A square spiral with the start in its heart and the goal outside; mirrored, turned by quarters
// and the goal on any of its four sides, as drawn.
struct SpiralConfig {
  int arms = 7;
  double corridor_min_m = 1.6;
  double corridor_max_m = 2.2;

  template <class Visitor>
  void visit(Visitor& v) {
    v.count("arms", arms, 4, 40, "Straight walls");
    v.number("corridor_min_m", corridor_min_m, 0.3, 10, "Narrowest corridor");
    v.number("corridor_max_m", corridor_max_m, 0.3, 10, "Widest corridor");
  }
};

// The goal inside a closed ring of walls: no path exists, which is the right answer.
struct EnclosedGoalConfig {
  double distance_m = 10;
  int corners_min = 3;
  int corners_max = 8;
  double ring_radius_min_m = 1.2;
  double ring_radius_max_m = 2.5;

  template <class Visitor>
  void visit(Visitor& v) {
    v.number("distance_m", distance_m, 6, 100, "From start to goal");
    v.count("corners_min", corners_min, 3, 50, "Fewest corners of the ring");
    v.count("corners_max", corners_max, 3, 50, "Most corners of the ring");
    v.number("ring_radius_min_m", ring_radius_min_m, 1, 5, "Smallest ring");
    v.number("ring_radius_max_m", ring_radius_max_m, 1, 5, "Largest ring");
  }
};

WorldDraw draw_world(const UTrapConfig& config, Random& random);
WorldDraw draw_world(const BugTrapConfig& config, Random& random);
WorldDraw draw_world(const SpiralConfig& config, Random& random);
WorldDraw draw_world(const EnclosedGoalConfig& config, Random& random);

}  // namespace voronaut
