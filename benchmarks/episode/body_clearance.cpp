#include "voronaut/benchmarks/episode/body_clearance.h"

#include "voronaut/environments/shapes/convex_distance.h"

namespace voronaut {

void BodyClearance::add(const VehicleState& state, double clearance_m) {
  const double of_disc_m = std::max(0.0, clearance_m - radius_m_);
  if (of_disc_m >= smallest_m_) return;
  if (footprint_.is_disc()) {
    smallest_m_ = of_disc_m;
    return;
  }
  place_corners(footprint_.corners_body, state.p_world.head<2>(), state.heading_world(),
                corners_world_);
  smallest_m_ = voronaut::clearance_m(shapes_, corners_world_, smallest_m_);
}

}  // namespace voronaut
