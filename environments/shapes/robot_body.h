#pragma once

#include <string>
#include <vector>

#include "voronaut/environments/shapes/geometry.h"

namespace voronaut {

// A robot as files of other projects tell it, seen from above in its own frame (x forward, y left):
// a disc, or a convex polygon, counter-clockwise, with the origin inside.
struct RobotBody {
  double radius_m = 0;               // of the disc; without meaning for a polygon
  std::vector<Vec2> corners_body{};  // empty: the disc
};

// Why these are not the corners of a strictly convex polygon that has the origin inside, in either
// orientation; empty if they are. Turns them counter-clockwise. O(v log v).
std::string body_problem(std::vector<Vec2>& corners_body);

}  // namespace voronaut
