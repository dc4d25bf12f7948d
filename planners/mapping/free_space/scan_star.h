#pragma once

#include <span>
#include <vector>

#include "voronaut/environments/sensing/scan.h"

namespace voronaut {

// What one scan has shown empty: the union of the triangles between neighbouring beams, each as
// long as the shorter of its two beams. Kept as the closed outline of that union.
class ScanStar {
 public:
  struct Corner {
    double x, y;      // in cells
    int column, row;  // of its cell
  };
  struct Box {
    int low_column, high_column, low_row, high_row;
  };

  // `sensor` is the place of the range finder in cells, whose sides are cell_m. Two beams or more.
  // O(beams), no allocation in steady state.
  void trace(const Scan& scan, const Vec2& sensor, double cell_m);

  // Counter-clockwise and closed: the first corner is the last one, too.
  std::span<const Corner> corners() const { return {corners_.data(), count_}; }
  const Box& box() const { return box_; }  // of their cells

 private:
  class Pen;
  template <bool full>
  static void draw(const Scan& scan, double cell_m, Pen& pen);
  void round_down();

  std::vector<Corner> corners_;  // the first count_; the others are room
  std::size_t count_ = 0;
  Box box_{};
};

}  // namespace voronaut
