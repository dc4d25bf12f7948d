#pragma once

#include "voronaut/environments/generators/generated_world.h"

// Halls with walls across, each with one gap. The hall is closed: there is no way around.
namespace voronaut {

// Walls across a hall, gaps wherever they are drawn.
struct WallsConfig {
  int walls = 3;
  double gap_m = 1.5;
  double hall_width_m = 10;
  double spacing_m = 4;

  template <class Visitor>
  void visit(Visitor& v) {
    v.count("walls", walls, 1, 100, "Walls across the hall");
    v.number("gap_m", gap_m, 0.05, 10, "Free width of the gap in each");
    v.number("hall_width_m", hall_width_m, 2, 100, "Width of the hall");
    v.number("spacing_m", spacing_m, 1.5, 20,
             "From wall to wall, and before the first and behind the last");
  }
};

// Walls so thick that a gap is a corridor, of a stated free width that does not vary: for the edge
// of what can be passed. With a gap narrower than twice the clearance asked for, no path exists.
struct NarrowGapsConfig {
  double gap_m = 0.9;
  double thickness_m = 0.4;
  int walls = 1;
  double hall_width_m = 6;
  double spacing_m = 3;

  template <class Visitor>
  void visit(Visitor& v) {
    v.number("gap_m", gap_m, 0.05, 5, "Free width of the gap in each");
    v.number("thickness_m", thickness_m, 0.01, 5, "Of a wall: length of the gap");
    v.count("walls", walls, 1, 50, "Walls across the hall");
    v.number("hall_width_m", hall_width_m, 2, 100, "Width of the hall");
    v.number("spacing_m", spacing_m, 1.5, 20,
             "From wall to wall, and before the first and behind the last");
  }
};

WorldDraw draw_world(const WallsConfig& config, Random& random);
WorldDraw draw_world(const NarrowGapsConfig& config, Random& random);

}  // namespace voronaut
