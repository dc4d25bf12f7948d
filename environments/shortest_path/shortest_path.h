#pragma once

#include <optional>

#include "voronaut/dynamics/path.h"
#include "voronaut/environments/world.h"

namespace voronaut {

// A taut path of a disc's centre: lines, and arcs around what it is pulled against.
struct ShortestPath {
  double length_m = 0;
  Path path;  // from start to goal; empty if they are the same point
};

// Part of the radius that may be missing where the disc passes or touches obstacles and bounds, so
// that paths which touch (all shortest ones do) are not lost to rounding.
constexpr double kShortestPathTolerance = 1e-9;

// The shortest path of a disc of radius_m > 0 from start to goal in the true world, the centre
// within the bounds: privileged knowledge, the reference that planners are measured by. No value:
// there is no path. Exact in both, up to kShortestPathTolerance and rounding.
//
// A* over the tangent graph of the obstacles grown by the radius: circles, corners and wall ends
// become discs; paths run along arcs of their rims and along common tangents (Lozano-Perez and
// Wesley, https://doi.org/10.1145/359156.359164; arcs as in Liu and Arimoto,
// https://doi.org/10.1177/027836499201100605). Tangents are made when their rim is first reached
// and tested against the world when the search comes to them; only discs within an ellipse that can
// hold a better path take part. O(d^2) swept-disc tests at worst in the d discs of the ellipse.
// Throws std::invalid_argument unless radius_m > 0 and finite.
std::optional<ShortestPath> shortest_path(const World& world, const Vec2& start, const Vec2& goal,
                                          double radius_m);

}  // namespace voronaut
