#pragma once

#include "voronaut/environments/generators/generated_world.h"

// Fields of round posts with a way straight through: forest, regular grid, thin posts.
namespace voronaut {

enum class Crossing { corners, sides };

// Trees uniform in the square [0, side_m]^2; start and goal outside it, a way around it is free.
struct ForestConfig {
  double density_per_m2 = 0.1;
  double side_m = 20;
  double radius_min_m = 0.3;
  double radius_max_m = 0.6;
  double gap_min_m = 0.2;
  double outside_m = 1;
  double margin_m = 3;
  Crossing crossing = Crossing::corners;

  template <class Visitor>
  void visit(Visitor& v) {
    v.number("density_per_m2", density_per_m2, 0, 1, "Posts per area of the field");
    v.number("side_m", side_m, 1, 200, "Side of the square that they stand in");
    v.number("radius_min_m", radius_min_m, 0.001, 10, "Thinnest post");
    v.number("radius_max_m", radius_max_m, 0.001, 10, "Thickest post");
    v.number("gap_min_m", gap_min_m, 0, 10, "Between any two surfaces");
    v.number("outside_m", outside_m, 0.5, 10, "Of start and goal from the square");
    v.number("margin_m", margin_m, 1, 20, "Of the bounds from the square");
    v.choice("crossing", crossing, {{"corners", Crossing::corners}, {"sides", Crossing::sides}},
             "From corner to corner or from side to side");
  }
};

// Equal posts on a square lattice, spacing and radius drawn once for the world; start and goal on
// opposite sides, each at a height of its own.
struct GridConfig {
  double side_m = 12;
  double spacing_min_m = 2.2;
  double spacing_max_m = 3.2;
  double radius_min_m = 0.3;
  double radius_max_m = 0.5;

  template <class Visitor>
  void visit(Visitor& v) {
    v.number("side_m", side_m, 4, 100, "Side of the square that they stand in");
    v.number("spacing_min_m", spacing_min_m, 0.5, 20, "Closest lattice");
    v.number("spacing_max_m", spacing_max_m, 0.5, 20, "Widest lattice");
    v.number("radius_min_m", radius_min_m, 0.001, 5, "Thinnest post");
    v.number("radius_max_m", radius_max_m, 0.001, 5, "Thickest post");
  }
};

// Posts thinner than the spacing of the beams at range, and walls without thickness or caps that
// point at the start, so that they are seen edge-on.
struct ThinPostsConfig {
  double density_per_m2 = 0.1;
  double side_m = 12;
  double diameter_min_m = 0.03;
  double diameter_max_m = 0.1;
  double gap_min_m = 1.0;
  int edge_on_walls = 4;
  double wall_length_m = 1.5;

  template <class Visitor>
  void visit(Visitor& v) {
    v.number("density_per_m2", density_per_m2, 0, 1, "Posts per area of the field");
    v.number("side_m", side_m, 4, 100, "Side of the square that they stand in");
    v.number("diameter_min_m", diameter_min_m, 0.001, 1, "Thinnest post");
    v.number("diameter_max_m", diameter_max_m, 0.001, 1, "Thickest post");
    v.number("gap_min_m", gap_min_m, 0, 10, "Between any two surfaces");
    v.count("edge_on_walls", edge_on_walls, 0, 100,
            "Walls without thickness that point at the start");
    v.number("wall_length_m", wall_length_m, 0.1, 10, "Length of such a wall");
  }
};

WorldDraw draw_world(const ForestConfig& config, Random& random);
WorldDraw draw_world(const GridConfig& config, Random& random);
WorldDraw draw_world(const ThinPostsConfig& config, Random& random);

}  // namespace voronaut
