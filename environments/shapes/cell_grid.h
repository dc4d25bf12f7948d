#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "voronaut/environments/shapes/geometry.h"

namespace voronaut {

// Square cells over an area, row by row from its lower left corner; places outside belong to no
// cell. Holds no contents. An empty grid has no cells.
class CellGrid {
 public:
  // Inclusive on both sides; empty if x0 > x1 or y0 > y1.
  struct Range {
    int x0, y0, x1, y1;
  };

  CellGrid() = default;
  CellGrid(const Bounds& area, double cell_m);

  double cell_m() const { return cell_m_; }
  int columns() const { return columns_; }
  int rows() const { return rows_; }
  std::size_t size() const {
    return static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
  }
  std::size_t cell(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(x);
  }

  // Outside the grid these are -1 or 0, and columns() or rows(); either below it.
  int column(double x) const { return index((x - origin_.x()) * cells_per_m_, columns_); }
  int row(double y) const { return index((y - origin_.y()) * cells_per_m_, rows_); }
  // The cells that an area touches.
  Range cells_in(const Bounds& area) const;
  // Calls cells(y, x0, x1), inclusive, row by row, for cells that hold every place within pad_m of
  // the segment, until it returns false; returns the last answer. Rows y that have none,
  // !has_any(y), are left out.
  template <class OnCells, class OnRow>
  bool for_cells_near(const Segment& s, double pad_m, OnCells&& cells, OnRow&& has_any) const;
  template <class OnCells>
  bool for_cells_near(const Segment& s, double pad_m, OnCells&& cells) const {
    return for_cells_near(s, pad_m, cells, [](int) { return true; });
  }

  // Where a ray is on its way through the cells: Amanatides and Woo, "A Fast Voxel Traversal
  // Algorithm for Ray Tracing", Eurographics 1987.
  class Walk {
   public:
    // The ray p + t direction, 0 <= t <= range_m; `direction` is a unit vector.
    Walk(const CellGrid& grid, const Vec2& p, const Vec2& direction, double range_m);

    bool inside() const { return x_ != end_x_ && y_ != end_y_ && entered_m_ <= range_m_; }
    int x() const { return x_; }
    int y() const { return y_; }
    // Where the ray leaves the cell.
    double leave_m() const { return std::min(next_x_m_, next_y_m_); }
    void advance() {
      entered_m_ = leave_m();
      if (next_x_m_ < next_y_m_) {
        x_ += step_x_;
        next_x_m_ += across_x_m_;
      } else {
        y_ += step_y_;
        next_y_m_ += across_y_m_;
      }
    }

   private:
    int x_ = 0, y_ = 0, step_x_ = 1, step_y_ = 1;
    int end_x_ = 0, end_y_ = 0;               // first column and row past the grid
    double next_x_m_ = 0, next_y_m_ = 0;      // where the ray leaves the column, the row
    double across_x_m_ = 0, across_y_m_ = 0;  // ray length per column, row
    double entered_m_ = 0;                    // where it entered the cell it is in
    double range_m_ = 0;
  };

 private:
  // Truncation instead of a floor: what lies up to a cell before the grid counts as its first cell.
  static int index(double cells, int count) {
    return static_cast<int>(std::clamp(cells, -1.0, static_cast<double>(count)));
  }
  double enters_at_m(const Vec2& from, const Vec2& per_m) const;

  Vec2 origin_ = Vec2::Zero();
  double cell_m_ = 1;
  double cells_per_m_ = 1;
  int columns_ = 0;
  int rows_ = 0;
};

template <class OnCells, class OnRow>
bool CellGrid::for_cells_near(const Segment& s, double pad_m, OnCells&& cells,
                              OnRow&& has_any) const {
  // From the lower end up, in cells.
  const bool rises = s.a.y() <= s.b.y();
  const Vec2 lower = ((rises ? s.a : s.b) - origin_) * cells_per_m_;
  const Vec2 along = ((rises ? s.b : s.a) - origin_) * cells_per_m_ - lower;
  const double pad = pad_m * cells_per_m_;
  const double left = std::min(lower.x(), lower.x() + along.x());
  const double right = std::max(lower.x(), lower.x() + along.x());
  // One that hardly rises is looked at as a whole in each row.
  const bool steep = along.y() > 1e-9;
  const double slope = steep ? along.x() / along.y() : 0;
  const int last_row = std::min(index(lower.y() + along.y() + pad, rows_), rows_ - 1);
  for (int y = std::max(index(lower.y() - pad, rows_), 0); y <= last_row; ++y) {
    if (!has_any(y)) continue;
    double from = left;
    double to = right;
    if (steep) {
      // The part of the segment from which the row can be reached.
      const double at_bottom = lower.x() + slope * (y - pad - lower.y());
      const double at_top = at_bottom + slope * (1 + 2 * pad);
      from = std::max(left, std::min(at_bottom, at_top));
      to = std::min(right, std::max(at_bottom, at_top));
    }
    const int x0 = std::max(index(from - pad, columns_), 0);
    const int x1 = std::min(index(to + pad, columns_), columns_ - 1);
    if (x0 <= x1 && !cells(y, x0, x1)) return false;
  }
  return true;
}

}  // namespace voronaut
