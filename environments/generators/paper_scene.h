#pragma once

#include "voronaut/environments/generators/generated_world.h"

// Scenes like those of the papers: a few large circles about the straight way to the goal.
namespace voronaut {

// The quadrotor paper flies from (0, 0) to (10, 10), 14.142 m at 45 deg, among circles of 0.5 and
// 1 m. A scene is drawn at bearing 0 and then turned, so scenes of one seed are turns of each other
// at every bearing (the bounds, which stay axis-aligned, excepted).
struct PaperSceneConfig {
  double bearing_rad = 0;
  double distance_m = 14.142;
  int circles_min = 2;
  int circles_max = 7;
  double radius_small_m = 0.5;
  double radius_large_m = 1;
  double gap_min_m = 1.2;
  double spread_m = 2.5;
  int clusters = 0;
  double cluster_radius_m = 3;
  double end_clearance_m = 1;
  double margin_m = 4;

  template <class Visitor>
  void visit(Visitor& v) {
    v.number("bearing_rad", bearing_rad, -10, 10, "Of the goal from the start");
    v.number("distance_m", distance_m, 4, 100, "From start to goal");
    v.count("circles_min", circles_min, 0, 100, "Fewest circles");
    v.count("circles_max", circles_max, 0, 100, "Most circles");
    v.number("radius_small_m", radius_small_m, 0.01, 5, "One of the two radii");
    v.number("radius_large_m", radius_large_m, 0.01, 5, "The other one");
    v.number("gap_min_m", gap_min_m, 0, 10, "Between any two surfaces");
    v.number("spread_m", spread_m, 0.1, 20, "Of the centres to both sides of the line");
    v.count("clusters", clusters, 0, 100,
            "Circles gather about so many places, in turn; 0: anywhere along the line");
    v.number("cluster_radius_m", cluster_radius_m, 0.1, 20,
             "Of their centres from such a place, along either axis");
    v.number("end_clearance_m", end_clearance_m, 0.1, 5, "Of start and goal from any surface");
    v.number("margin_m", margin_m, 1, 20, "Of the bounds from the scene");
  }
};

// A circle so close to the goal that a repulsive field pushes the vehicle off it ("goals
// nonreachable with obstacles nearby", https://doi.org/10.1109/70.880813), and a few on the way.
struct GoalSideConfig {
  double bearing_rad = 0;
  double distance_m = 10;
  double goal_gap_min_m = 0.5;
  double goal_gap_max_m = 0.8;
  double radius_min_m = 0.5;
  double radius_max_m = 1;
  int others = 2;
  double gap_min_m = 1.2;
  double spread_m = 2;

  template <class Visitor>
  void visit(Visitor& v) {
    v.number("bearing_rad", bearing_rad, -10, 10, "Of the goal from the start");
    v.number("distance_m", distance_m, 6, 100, "From start to goal");
    v.number("goal_gap_min_m", goal_gap_min_m, 0.01, 5,
             "Smallest gap from the goal to its neighbour's surface");
    v.number("goal_gap_max_m", goal_gap_max_m, 0.01, 5, "Largest such gap");
    v.number("radius_min_m", radius_min_m, 0.01, 5, "Smallest circle");
    v.number("radius_max_m", radius_max_m, 0.01, 5, "Largest circle");
    v.count("others", others, 0, 50, "Circles on the way");
    v.number("gap_min_m", gap_min_m, 0, 10, "Between any two surfaces");
    v.number("spread_m", spread_m, 0.1, 20, "Of the centres to both sides of the line");
  }
};

WorldDraw draw_world(const PaperSceneConfig& config, Random& random);
WorldDraw draw_world(const GoalSideConfig& config, Random& random);

}  // namespace voronaut
