#pragma once

#include <span>
#include <vector>

#include "voronaut/environments/sensing/scan.h"

namespace voronaut {

// What one scan has shown empty: the union of the triangles between neighbouring beams, each as
// long as the shorter of its two beams. Kept as the closed outline of that union.
class ScanStar {
 public:
  // `sensor` is the place of the range finder in cells, whose sides are cell_m. Two beams or more.
  // O(beams), no allocation in steady state.
  void trace(const Scan& scan, const Vec2& sensor, double cell_m);

  // Counter-clockwise, in cells; the last corner leads back to the first.
  std::span<const Vec2> corners() const { return {corners_.data(), count_}; }
  const Vec2& low() const { return low_; }  // of the box around all corners
  const Vec2& high() const { return high_; }

 private:
  void measure(const Vec2& sensor);

  std::vector<Vec2> corners_;  // the first count_; the others are room
  std::size_t count_ = 0;
  Vec2 low_, high_;
};

}  // namespace voronaut
