#include "voronaut/environments/shortest_path/common_tangent.h"

#include <cmath>
#include <numbers>

#include <sleef.h>

namespace voronaut {

double quarter_turns(const Vec2& v) {
  const double share = v.y() / (std::abs(v.x()) + std::abs(v.y()));
  if (v.x() < 0) return 2 - share;
  return share < 0 ? 4 + share : share;
}

Vec2 direction_at(double quarters) {
  const double q = quarters - 4 * std::floor(quarters / 4);
  if (q < 2) return Vec2(1 - q, q < 1 ? q : 2 - q).normalized();
  return Vec2(q - 3, q < 3 ? 2 - q : q - 4).normalized();
}

double quarters_ahead(double from, double to) {
  const double ahead = to - from;
  return ahead < 0 ? std::max(ahead + 4, 0.0) : ahead;
}

bool common_tangent(const Disc& from, int from_turn, const Disc& to, int to_turn, double tolerance,
                    CommonTangent& t) {
  const Vec2 between = to.center - from.center;
  const double distance_sq = between.squaredNorm();
  if (distance_sq == 0) return false;
  // Along the left normal of the direction of travel the centres are this far apart.
  const double across_m = to_turn * to.radius_m - from_turn * from.radius_m;
  const double length_sq = distance_sq - across_m * across_m;
  if (length_sq < -2 * tolerance * distance_sq) return false;
  t.length_m = std::sqrt(std::max(length_sq, 0.0));
  const Vec2 normal = length_sq > 0
                          ? Vec2((t.length_m * left_of(between) + across_m * between) / distance_sq)
                          : Vec2((across_m > 0 ? 1 : -1) * between.normalized());
  t.depart = -from_turn * normal;
  t.arrive = -to_turn * normal;
  return true;
}

double turned_rad(const Vec2& from, const Vec2& to, int turn) {
  const double angle_rad = Sleef_cinz_atan2d1_u10purec(turn * cross(from, to), from.dot(to));
  if (angle_rad < -kSameDirection) return angle_rad + 2 * std::numbers::pi;
  return std::max(angle_rad, 0.0);
}

double turned_at_least_rad(const Vec2& from, const Vec2& to, int turn) {
  if (turn * cross(from, to) < -kSameDirection) return std::numbers::pi;
  // Twice the arc sine of half the chord, its series cut short.
  const double half_chord = (to - from).norm() / 2;
  const double sq = half_chord * half_chord;
  return half_chord * (2 + sq * (1.0 / 3 + sq * (3.0 / 20))) * (1 - 1e-12);
}

}  // namespace voronaut
