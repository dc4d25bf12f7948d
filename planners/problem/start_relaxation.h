#pragma once

#include <array>
#include <cstddef>

#include "voronaut/environments/shapes/geometry.h"

// How close a motion may come to a known point, when the start itself is closer than the clearance
// asked for: inside the disc of radius clearance_m around the start what the start has is enough,
// outside the full clearance holds. So a vehicle that drifted too close may leave, but not pass
// another obstacle at less.
namespace voronaut {

// One straight piece of a motion and the clearance it must keep.
struct ClearancePiece {
  Vec2 a;
  Vec2 b;
  double clearance_m = 0;
};

// At most three pieces: before, inside and after the disc.
struct ClearancePieces {
  std::array<ClearancePiece, 3> piece;
  std::size_t count = 0;
};

class StartRelaxation {
 public:
  // No relaxation: clearance_m everywhere.
  explicit StartRelaxation(double clearance_m)
      : clearance_m_(clearance_m), inside_m_(clearance_m) {}

  // start_clearance_m: distance from the start to the closest known point (any value
  // >= clearance_m: no relaxation).
  StartRelaxation(double clearance_m, const Vec2& start, double start_clearance_m);

  bool active() const { return inside_m_ < clearance_m_; }
  double clearance_at_m(const Vec2& p) const;
  ClearancePieces split(const Vec2& a, const Vec2& b) const;

 private:
  double clearance_m_;
  double inside_m_;
  Vec2 start_ = Vec2::Zero();
};

}  // namespace voronaut
