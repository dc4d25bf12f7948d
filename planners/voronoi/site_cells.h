#pragma once

#include <cstdint>
#include <vector>

#include "voronaut/environments/shapes/cell_grid.h"

namespace voronaut {

// Points in a grid of square cells, for exact swept-disc tests at a cost of the cells in reach.
// Adding a point is O(1), the first one in a row of cells O(its cells). Memory: the points and the
// rows of cells that have any.
class SiteCells {
 public:
  // Cells of cell_m, larger if the area would take more than 2^20 of them. Forgets all points.
  // O(rows).
  void reset(const Bounds& area, double cell_m);
  // A point of the area, or beside it by rounding.
  void add(const Vec2& p);
  std::size_t size() const { return points_.size(); }

  // True if no point is closer than radius_m to the segment a-b. O(cells in reach + their points).
  bool swept_disc_is_clear(const Vec2& a, const Vec2& b, double radius_m) const;
  // Index (in the order of adding) of the point deepest within radius_m of the segment, or -1.
  std::int32_t deepest_within(const Vec2& a, const Vec2& b, double radius_m) const;

 private:
  // Calls f(index) for the points of all cells that the swept disc touches, until f returns false.
  template <class F>
  void for_each_near(const Segment& s, double radius_m, F&& f) const;

  CellGrid grid_;
  static constexpr std::int32_t kNoPoints = -1;
  std::vector<std::int32_t> row_start_;  // of a row's cells in head_
  std::vector<std::int32_t> head_;       // of the rows that have points
  std::vector<std::int32_t> next_;
  std::vector<Vec2> points_;
};

}  // namespace voronaut
