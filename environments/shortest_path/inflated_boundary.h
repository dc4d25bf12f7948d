#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "voronaut/environments/shortest_path/common_tangent.h"
#include "voronaut/environments/world.h"

// The rims of obstacles grown by the radius of a vehicle: what its shortest paths wind around.
namespace voronaut {

// A part of a disc's rim on which the centre of the vehicle may be.
struct FreeArc {
  std::uint32_t disc = 0;
  double from_quarters = 0;
  double span_quarters = 4;  // counter-clockwise from there; 4 is the whole rim

  bool whole() const { return span_quarters >= 4; }
  // Quarter turns from the start of the arc to a direction, clamped to the arc within the
  // tolerance; negative if the direction lies outside.
  double position(double quarters) const;
};

// Discs around circles (their radius grown), corners and wall ends (the radius alone), and the free
// arcs of their rims, exact up to `tolerance` x radius: no obstacle is closer to the centre of the
// vehicle, and it is within the bounds.
class InflatedBoundary {
 public:
  InflatedBoundary(const World& world, double radius_m, double tolerance);

  std::span<const Disc> discs() const { return discs_; }
  const FreeArc& arc(std::uint32_t index) const { return arcs_[index]; }
  std::size_t arc_count() const { return arcs_.size(); }

  // Adds a point that paths may start or end in. Returns its disc, of radius 0.
  std::uint32_t add_point(const Vec2& p);

  struct ArcRange {
    std::uint32_t begin, end;
  };
  // The arcs of a disc; found when first asked for. O(p^2) in the primitives that touch the rim.
  ArcRange arcs_of(std::uint32_t disc);

 private:
  bool is_free(const Disc& disc, const Vec2& direction) const;
  std::vector<double> crossings_of(const Disc& disc) const;
  ArcRange find_arcs(std::uint32_t disc);

  const World& world_;
  double radius_m_;
  double reach_m_;  // the radius less its tolerance
  double same_point_m_;
  std::vector<Disc> discs_;
  std::vector<FreeArc> arcs_;
  std::vector<ArcRange> arcs_of_;  // by disc; begin > end: not known yet
};

}  // namespace voronaut
