#pragma once

#include "voronaut/environments/world.h"

namespace voronaut {

// How hard a world is: the diameter [m] of the largest disc that gets from start to goal in the
// true world, its centre within the bounds. Twice a distance to an obstacle where the way leads
// between it and the bounds, or where start or goal lie close to it. 0: no disc gets there.
// +infinity: any does.
//
// Obstacles grown by r separate start from goal once they form a closed chain around one of the
// two: a chain whose links cross the straight line from start to goal an odd number of times. Links
// come in the order of their gaps to a union-find that keeps the parity of crossings; the first one
// that closes an odd chain is the narrowest passage. Circles, edges and the outside of the bounds
// are convex or simply connected, so that chains of pairs are all there is to look at (nerve
// theorem). Exact but for rounding. O(n k log n) for n circles and edges and the k of them within
// twice the width of each.
double narrowest_passage_m(const World& world, const Vec2& start, const Vec2& goal);

}  // namespace voronaut
