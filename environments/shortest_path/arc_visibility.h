#pragma once

#include <array>

#include "voronaut/environments/shortest_path/inflated_boundary.h"

namespace voronaut {

// How far a disc sees along the tangents that leave a free arc, by sectors of their direction. What
// lies behind an obstacle that shuts a whole sector needs no tangent of its own. A bound from
// above: never says that something in sight is not.
class ArcVisibility {
 public:
  // Tangents of an arc of `disc`, travelled counter-clockwise (turn +1) or clockwise (-1), by a
  // vehicle of radius_m, up to limit_m long. O(cells that the sectors' axes pass).
  ArcVisibility(const ShapeIndex& shapes, const Disc& disc, const FreeArc& arc, int turn,
                double radius_m, double limit_m);

  // Whether any tangent to the disc may be clear: cheap and coarse.
  bool may_reach(const Disc& target) const;
  // Whether the tangent that departs in a direction from the centre may be clear up to its arrival.
  bool may_reach(double depart_quarters, const Vec2& arrival) const;

 private:
  static constexpr int kPerQuarter = 16;
  static constexpr int kSectors = 4 * kPerQuarter;

  struct Sector {
    Vec2 apex;
    Vec2 axis;
    double range_m;   // of its own tangents
    double around_m;  // the farthest within kNeighbours sectors
  };
  static std::size_t sector_of(double quarters) {
    return static_cast<std::size_t>(quarters * kPerQuarter) % kSectors;
  }

  Disc disc_;
  int turn_;
  std::array<Sector, kSectors> sectors_;  // by the direction from the centre to the departure
};

}  // namespace voronaut
