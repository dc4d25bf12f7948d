#pragma once

#include <span>

#include "voronaut/environments/shapes/geometry.h"

// Khatib's artificial potential field: O. Khatib, "Real-time obstacle avoidance for manipulators
// and mobile robots", Int. J. Robotics Research 5(1), 1986, doi 10.1177/027836498600500106.
namespace voronaut {

// Gains of a vehicle of unit mass. With these the push of one obstacle balances the pull of a
// distant goal 0.655 m before it.
struct PotentialConfig {
  double attraction_gain = 1;
  double attraction_saturation_m = 1;
  double repulsion_gain = 0.5;
  double influence_distance_m = 1.5;

  template <class Visitor>
  void visit(Visitor& v) {
    v.number("attraction_gain", attraction_gain, 1e-6, 1e6,
             "k_p in N/m: pull of the goal per distance");
    v.number("attraction_saturation_m", attraction_saturation_m, 1e-3, 1e6,
             "A goal farther than this pulls no harder");
    v.number("repulsion_gain", repulsion_gain, 0, 1e6, "eta in N m^3: push of obstacles");
    v.number("influence_distance_m", influence_distance_m, 1e-3, 1e4,
             "rho_0: what is farther does not push");
  }
};

// U = k_p d^2 / 2 and F = -k_p (p - goal); beyond the saturation distance the force keeps its size,
// which is what the paper's limit on the velocity towards the goal comes to.
double attraction_potential(const Vec2& p, const Vec2& goal, const PotentialConfig& config);
Vec2 attraction_force(const Vec2& p, const Vec2& goal, const PotentialConfig& config);

// FIRAS, with rho the distance to the closest point of the obstacle:
// U = eta / 2 (1/rho - 1/rho_0)^2, F = eta (1/rho - 1/rho_0) / rho^2 grad rho for rho <= rho_0,
// else zero. Infinite and zero at rho = 0.
double repulsion_potential(const Vec2& p, const Vec2& closest, const PotentialConfig& config);
Vec2 repulsion_force(const Vec2& p, const Vec2& closest, const PotentialConfig& config);

// Sums over the goal and the closest points of the obstacles.
double total_potential(const Vec2& p, const Vec2& goal, std::span<const Vec2> closest,
                       const PotentialConfig& config);
Vec2 total_force(const Vec2& p, const Vec2& goal, std::span<const Vec2> closest,
                 const PotentialConfig& config);

}  // namespace voronaut
