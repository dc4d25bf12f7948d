#pragma once

#include <vector>

#include "voronaut/dynamics/catalog.h"
#include "voronaut/environments/shapes/shape_index.h"

namespace voronaut {

// What the surface of a body keeps from shapes on its way, at the least: exact for a disc and for a
// convex polygon as it is turned. Shares no code with the referee.
class BodyClearance {
 public:
  // The index must outlive it.
  BodyClearance(const ShapeIndex& shapes, const VehicleSpec& vehicle)
      : shapes_(shapes), radius_m_(vehicle.body_radius_m), footprint_(vehicle.footprint) {}

  // `clearance_m`: the distance of the body's origin from the nearest shape. O(1) where no shape is
  // nearer than one was before.
  void add(const VehicleState& state, double clearance_m);

  double smallest_m() const { return smallest_m_; }  // 0: a contact; infinite: no shapes

 private:
  const ShapeIndex& shapes_;
  double radius_m_;
  Footprint footprint_;
  double smallest_m_ = kInfinity;
  std::vector<Vec2> corners_world_;  // scratch
};

}  // namespace voronaut
