#pragma once

#include "voronaut/environments/generators/generated_world.h"

// Cells with walls between them: rooms with doors, perfect and braided mazes. All are closed.
namespace voronaut {

// A square of rooms. The doors of a random spanning tree join all rooms, further ones open loops;
// each door lies somewhere in its wall.
struct RoomsConfig {
  int rooms = 3;
  double room_side_m = 4;
  double door_m = 1.2;
  double further_doors = 0.3;

  template <class Visitor>
  void visit(Visitor& v) {
    v.count("rooms", rooms, 1, 30, "Per side of the square");
    v.number("room_side_m", room_side_m, 2.5, 30, "Side of a room");
    v.number("door_m", door_m, 0.1, 5, "Free width of a door");
    v.number("further_doors", further_doors, 0, 1,
             "Share of the walls beside the spanning tree that have a door too");
  }
};

// A maze in which one path joins any two cells (depth-first search with random choices), from one
// corner to the opposite one; braided: a share of the walls that are left is taken away.
struct MazeConfig {
  int cells = 8;
  double cell_side_m = 2;
  double opened = 0;

  template <class Visitor>
  void visit(Visitor& v) {
    v.count("cells", cells, 2, 100, "Per side of the square");
    v.number("cell_side_m", cell_side_m, 0.5, 20, "Side of a cell");
    v.number("opened", opened, 0, 1, "Share of the remaining inner walls that is taken away");
  }
};

WorldDraw draw_world(const RoomsConfig& config, Random& random);
WorldDraw draw_world(const MazeConfig& config, Random& random);

}  // namespace voronaut
