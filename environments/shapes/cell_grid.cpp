#include "voronaut/environments/shapes/cell_grid.h"

#include <cmath>
#include <limits>

namespace voronaut {
CellGrid::CellGrid(const Bounds& area, double cell_m)
    : origin_(area.min),
      cell_m_(cell_m),
      cells_per_m_(1 / cell_m),
      columns_(static_cast<int>((area.max.x() - area.min.x()) / cell_m) + 1),
      rows_(static_cast<int>((area.max.y() - area.min.y()) / cell_m) + 1) {}

CellGrid::Range CellGrid::cells_in(const Bounds& area) const {
  return {std::max(column(area.min.x()), 0), std::max(row(area.min.y()), 0),
          std::min(column(area.max.x()), columns_ - 1), std::min(row(area.max.y()), rows_ - 1)};
}

// Where a ray from outside gets into both slabs of the grid, +infinity if it does not.
double CellGrid::enters_at_m(const Vec2& from, const Vec2& per_m) const {
  double enter_m = 0;
  double leave_m = kInfinity;
  const Vec2 size_m(columns_ * cell_m_, rows_ * cell_m_);
  for (const int axis : {0, 1}) {
    if (std::isinf(per_m[axis])) {
      if (from[axis] < 0 || from[axis] >= size_m[axis]) return kInfinity;
      continue;
    }
    const double low_m = -from[axis] * per_m[axis];
    const double high_m = (size_m[axis] - from[axis]) * per_m[axis];
    enter_m = std::max(enter_m, std::min(low_m, high_m));
    leave_m = std::min(leave_m, std::max(low_m, high_m));
  }
  return enter_m <= leave_m ? enter_m : kInfinity;
}

CellGrid::Walk::Walk(const CellGrid& grid, const Vec2& p, const Vec2& direction, double range_m)
    : range_m_(range_m) {
  if (grid.size() == 0) return;  // end_x_ == x_: never inside
  const Vec2 from = p - grid.origin_;
  const Vec2 per_m(1 / direction.x(), 1 / direction.y());
  Vec2 entry = from;
  if (from.x() < 0 || from.y() < 0 || from.x() >= grid.columns_ * grid.cell_m_ ||
      from.y() >= grid.rows_ * grid.cell_m_) {
    entered_m_ = grid.enters_at_m(from, per_m);
    if (!(entered_m_ <= range_m)) return;
    entry += entered_m_ * direction;
  }
  x_ = std::clamp(static_cast<int>(entry.x() * grid.cells_per_m_), 0, grid.columns_ - 1);
  y_ = std::clamp(static_cast<int>(entry.y() * grid.cells_per_m_), 0, grid.rows_ - 1);
  const bool right = direction.x() >= 0;
  const bool up = direction.y() >= 0;
  step_x_ = right ? 1 : -1;
  step_y_ = up ? 1 : -1;
  end_x_ = right ? grid.columns_ : -1;
  end_y_ = up ? grid.rows_ : -1;
  across_x_m_ = grid.cell_m_ * std::abs(per_m.x());
  across_y_m_ = grid.cell_m_ * std::abs(per_m.y());
  // A ray along an axis never leaves its row or column.
  next_x_m_ = direction.x() == 0 ? kInfinity : (grid.cell_m_ * (x_ + right) - from.x()) * per_m.x();
  next_y_m_ = direction.y() == 0 ? kInfinity : (grid.cell_m_ * (y_ + up) - from.y()) * per_m.y();
}

}  // namespace voronaut
