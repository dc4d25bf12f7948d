#pragma once

#include <optional>
#include <string>

#include "voronaut/environments/shapes/robot_body.h"
#include "voronaut/environments/shapes/shapes.h"

// What files of other projects say, in our terms: metres, world frame W.
namespace voronaut {

// Where a grid of square cells lies: column 0 is the left one, row 0 the lowest.
struct CellFrame {
  int columns = 1;
  int rows = 1;
  double cell_size_m = 1;
  Vec2 lower_left = Vec2::Zero();

  // Of the lower left corner of a cell. Equal for equal numbers, so that neighbouring rectangles
  // have the very same edge: no ray and no disc passes between them.
  Vec2 corner(int column, int row) const {
    return {lower_left.x() + column * cell_size_m, lower_left.y() + row * cell_size_m};
  }
  Vec2 center(int column, int row) const {
    return {lower_left.x() + (column + 0.5) * cell_size_m,
            lower_left.y() + (row + 0.5) * cell_size_m};
  }
};

// A world; what the file does not say, the scenario must.
struct ForeignWorld {
  std::optional<Bounds> bounds;
  Shapes shapes;
  std::optional<Vec2> start;
  std::optional<Vec2> goal;
  std::optional<double> start_heading_rad;
  std::optional<RobotBody> robot;
  std::optional<CellFrame> cells;  // if it came as a grid
  int bodies_off_plane = 0;        // left out, because they do not meet the plane of flight
};

// One way through a world that a file of queries names.
struct ForeignQuery {
  std::string name;  // "17": unique in its file for its world
  Vec2 start = Vec2::Zero();
  Vec2 goal = Vec2::Zero();
  int bucket = 0;       // MovingAI's class of length
  double length_m = 0;  // of the file's own reference path; 0: not given
};

// What a map says about places that nobody has seen.
enum class UnknownCells { free, blocked };

// What is taken of bodies in space: where they meet the plane of flight, or all below and above
// them as well, as seen from above.
enum class BodyCut { plane, columns };

// How a file is read, where its format leaves that open. Each format uses some of these.
struct ForeignOptions {
  double cell_size_m = 0.25;
  UnknownCells unknown = UnknownCells::blocked;
  BodyCut cut = BodyCut::plane;
  double height_m = 1;

  template <class Visitor>
  void visit(Visitor& v) {
    v.number("cell_size_m", cell_size_m, 0.001, 1000, "Of a grid that has no size of its own");
    v.choice("unknown", unknown, {{"free", UnknownCells::free}, {"blocked", UnknownCells::blocked}},
             "What unknown cells of a map are taken for");
    v.choice("cut", cut, {{"plane", BodyCut::plane}, {"columns", BodyCut::columns}},
             "What is taken of bodies: where they meet a plane, or all below and above it as well");
    v.number("height_m", height_m, 0, 100,
             "Of that plane; in a scenario its cruise_height_m unless given");
  }
};

}  // namespace voronaut
