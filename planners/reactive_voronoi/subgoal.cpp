#include "voronaut/planners/reactive_voronoi/subgoal.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace voronaut {
namespace {

using Config = ReactiveVoronoiConfig;

// Two candidates this close to equally remote are a tie (an obstacle of one point): rounding must
// not choose.
constexpr double kTie_m = 1e-9;

// Grows with the angle from `reference` to v, counter-clockwise in (-180, 180] deg; its values are
// in (-2, 2].
double turn_from(const Vec2& reference, const Vec2& v) {
  const double x = reference.dot(v);
  const double y = cross(reference, v);
  const double size = std::abs(x) + std::abs(y);
  if (size == 0) return 0;
  if (x >= 0) return y / size;
  return (y < 0 ? -2 : 2) - y / size;
}

// How far across the line of sight the subgoal lies. The way to a point s aside of another at
// distance d passes that one at d s / sqrt(d^2 + s^2): s = sqrt(2) margin, the published length,
// keeps the margin from d = sqrt(2) margin on, closer ones need more.
double sideways_m(double distance_m, double margin_m) {
  constexpr double kMost = 10;  // margins: as good as straight across
  const double published_m = std::sqrt(2.0) * margin_m;
  if (distance_m >= published_m) return published_m;
  const double tangent_sq = distance_m * distance_m - margin_m * margin_m;
  if (tangent_sq <= 0) return kMost * margin_m;
  return std::min(kMost * margin_m, margin_m * distance_m / std::sqrt(tangent_sq));
}

}  // namespace

double distance_to_points_m(const Vec2& p, std::span<const Vec2> points) {
  double best_sq = std::numeric_limits<double>::infinity();
  for (const Vec2& each : points) best_sq = std::min(best_sq, (each - p).squaredNorm());
  return std::sqrt(best_sq);
}

Vec2 extreme_point(const RelevantObstacle& obstacle, Side side, const Vec2& vehicle,
                   Config::Extremes extremes) {
  const std::vector<Vec2>& points = obstacle.points_world;
  if (extremes == Config::Extremes::stored_order)
    return side == Side::left ? points.back() : points.front();
  const Vec2 reference = obstacle.closest_world - vehicle;
  const auto by_turn = [&](const Vec2& a, const Vec2& b) {
    return turn_from(reference, a - vehicle) < turn_from(reference, b - vehicle);
  };
  const auto [rightmost, leftmost] = std::minmax_element(points.begin(), points.end(), by_turn);
  return side == Side::left ? *leftmost : *rightmost;
}

Vec2 bypass_subgoal(const RelevantObstacle& obstacle, Side side, const Vec2& vehicle,
                    const Config& config) {
  const Vec2 extreme = extreme_point(obstacle, side, vehicle, config.extremes);
  const double margin_m = config.safety_margin_m;
  const Vec2 sight = extreme - vehicle;
  Vec2 increment(-margin_m, margin_m);
  if (config.offset == Config::Offset::line_of_sight && sight.squaredNorm() > 0)
    increment = sideways_m(sight.norm(), margin_m) * left_of(sight.normalized());
  const std::array<Vec2, 2> candidate{extreme + increment, extreme - increment};
  const double remote_0_m = distance_to_points_m(candidate[0], obstacle.points_world);
  const double remote_1_m = distance_to_points_m(candidate[1], obstacle.points_world);
  if (std::abs(remote_0_m - remote_1_m) > kTie_m)
    return remote_0_m > remote_1_m ? candidate[0] : candidate[1];
  const bool first_is_left = cross(sight, increment) >= 0;
  return first_is_left == (side == Side::left) ? candidate[0] : candidate[1];
}

Vec2 between_subgoal(const RelevantObstacle& first, const RelevantObstacle& second) {
  return 0.5 * (first.closest_world + second.closest_world);
}

}  // namespace voronaut
