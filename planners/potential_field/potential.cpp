#include "voronaut/planners/potential_field/potential.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace voronaut {

double attraction_potential(const Vec2& p, const Vec2& goal, const PotentialConfig& config) {
  const double distance_m = (p - goal).norm();
  const double saturation_m = config.attraction_saturation_m;
  if (distance_m <= saturation_m) return 0.5 * config.attraction_gain * distance_m * distance_m;
  return config.attraction_gain * saturation_m * (distance_m - 0.5 * saturation_m);
}

Vec2 attraction_force(const Vec2& p, const Vec2& goal, const PotentialConfig& config) {
  const Vec2 way = goal - p;
  const double distance_m = way.norm();
  if (distance_m <= config.attraction_saturation_m) return config.attraction_gain * way;
  return config.attraction_gain * (config.attraction_saturation_m / distance_m) * way;
}

double repulsion_potential(const Vec2& p, const Vec2& closest, const PotentialConfig& config) {
  const double rho_m = (p - closest).norm();
  if (rho_m > config.influence_distance_m) return 0;
  if (rho_m == 0) return std::numeric_limits<double>::infinity();
  const double excess = 1 / rho_m - 1 / config.influence_distance_m;
  return 0.5 * config.repulsion_gain * excess * excess;
}

Vec2 repulsion_force(const Vec2& p, const Vec2& closest, const PotentialConfig& config) {
  const Vec2 away = p - closest;
  const double rho_m = away.norm();
  if (rho_m > config.influence_distance_m || rho_m == 0) return {0, 0};
  const double excess = 1 / rho_m - 1 / config.influence_distance_m;
  return config.repulsion_gain * excess / (rho_m * rho_m * rho_m) * away;
}

double total_potential(const Vec2& p, const Vec2& goal, std::span<const Vec2> closest,
                       const PotentialConfig& config) {
  double sum = attraction_potential(p, goal, config);
  for (const Vec2& each : closest) sum += repulsion_potential(p, each, config);
  return sum;
}

Vec2 total_force(const Vec2& p, const Vec2& goal, std::span<const Vec2> closest,
                 const PotentialConfig& config) {
  Vec2 sum = attraction_force(p, goal, config);
  for (const Vec2& each : closest) sum += repulsion_force(p, each, config);
  return sum;
}

}  // namespace voronaut
