#pragma once

#include "voronaut/environments/shapes/geometry.h"

// Discs, the tangents that they have in common, and directions around them. A disc is travelled
// around counter-clockwise (turn +1, it lies on the left) or clockwise (turn -1).
namespace voronaut {

// Directions in counter-clockwise order, one per quarter turn, in [0, 4): no trigonometry. The
// direction (1, 0) is 0, (0, 1) is 1.
double quarter_turns(const Vec2& direction);
// The unit vector back from it; any real number, modulo 4.
Vec2 direction_at(double quarters);
// How far counter-clockwise from one to the other, in [0, 4).
double quarters_ahead(double from, double to);

struct Disc {
  Vec2 center;
  double radius_m = 0;
};

struct CommonTangent {
  Vec2 depart;  // unit, from the centre of the disc that it leaves to the point of contact
  Vec2 arrive;  // the same at the disc that it reaches
  double length_m = 0;
};

// The tangent on which one leaves a disc and gets to another. Discs that touch, and points on the
// rim of a disc, have one without length that turns the path over: within `tolerance` x their
// distance. False where one disc holds the other, or turns differ and they overlap.
bool common_tangent(const Disc& from, int from_turn, const Disc& to, int to_turn, double tolerance,
                    CommonTangent& tangent);

// Directions that differ by less, in quarter turns or radians, are the same but for rounding.
constexpr double kSameDirection = 1e-8;

// Angle from one unit vector to another in the sense of the turn, in [0, 2 pi - kSameDirection).
double turned_rad(const Vec2& from, const Vec2& to, int turn);
// A bound of it from below, without trigonometry.
double turned_at_least_rad(const Vec2& from, const Vec2& to, int turn);

}  // namespace voronaut
