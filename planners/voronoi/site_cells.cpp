#include "voronaut/planners/voronoi/site_cells.h"

#include <algorithm>
#include <cmath>

namespace voronaut {
namespace {

constexpr double kMaxCells = 1 << 20;

// Squared distance of p to the segment from a along `along` (squared length length_sq).
double distance_sq(const Vec2& p, const Vec2& a, const Vec2& along, double length_sq) {
  const Vec2 from_a = p - a;
  const double t = length_sq > 0 ? std::clamp(from_a.dot(along) / length_sq, 0.0, 1.0) : 0.0;
  return (from_a - t * along).squaredNorm();
}

}  // namespace

void SiteCells::reset(const Bounds& area, double cell_m) {
  const Vec2 size = area.max - area.min;
  min_ = area.min;
  cell_m_ = std::max(cell_m, std::sqrt(size.x() * size.y() / kMaxCells));
  columns_ = static_cast<int>(size.x() / cell_m_) + 1;
  rows_ = static_cast<int>(size.y() / cell_m_) + 1;
  head_.clear();
  row_start_.assign(static_cast<std::size_t>(rows_), kNoPoints);
  next_.clear();
  points_.clear();
}

void SiteCells::add(const Vec2& p) {
  std::int32_t& start = row_start_[row(p.y())];
  if (start == kNoPoints) {
    start = static_cast<std::int32_t>(head_.size());
    head_.resize(head_.size() + static_cast<std::size_t>(columns_), -1);
  }
  std::int32_t& head = head_[start + column(p.x())];
  next_.push_back(head);
  head = static_cast<std::int32_t>(points_.size());
  points_.push_back(p);
}

bool SiteCells::swept_disc_is_clear(const Vec2& a, const Vec2& b, double radius_m) const {
  const Vec2 along = b - a;
  const double length_sq = along.squaredNorm();
  const double radius_sq = radius_m * radius_m;
  bool clear = true;
  for_each_near(a, b, radius_m, [&](std::int32_t k) {
    clear = distance_sq(points_[k], a, along, length_sq) >= radius_sq;
    return clear;
  });
  return clear;
}

std::int32_t SiteCells::deepest_within(const Vec2& a, const Vec2& b, double radius_m) const {
  const Vec2 along = b - a;
  const double length_sq = along.squaredNorm();
  double deepest_sq = radius_m * radius_m;
  std::int32_t deepest = -1;
  for_each_near(a, b, radius_m, [&](std::int32_t k) {
    const double sq = distance_sq(points_[k], a, along, length_sq);
    if (sq < deepest_sq) {
      deepest_sq = sq;
      deepest = k;
    }
    return true;
  });
  return deepest;
}

namespace {

struct Span {
  double left, right;
};

// Narrowed to the part of a segment, given by its lower end and slope, between two heights.
Span between(const Span& x, const Vec2& lower, double slope, double from, double to) {
  const double x1 = lower.x() + slope * (from - lower.y());
  const double x2 = lower.x() + slope * (to - lower.y());
  return {std::max(x.left, std::min(x1, x2)), std::min(x.right, std::max(x1, x2))};
}

}  // namespace

template <class F>
void SiteCells::for_each_near(const Vec2& a, const Vec2& b, double radius_m, F&& f) const {
  const auto [lower, upper] =
      std::minmax(a, b, [](const Vec2& p, const Vec2& q) { return p.y() < q.y(); });
  const double rise = upper.y() - lower.y();
  const double slope = rise > 0 ? (upper.x() - lower.x()) / rise : 0;
  const Span whole{std::min(a.x(), b.x()), std::max(a.x(), b.x())};
  const int last_row = row(upper.y() + radius_m);
  for (int j = row(lower.y() - radius_m); j <= last_row; ++j) {
    if (row_start_[j] == kNoPoints) continue;
    // The part of the segment that is within radius_m of this row's height, padded for rounding.
    Span x = whole;
    if (rise > 0) {
      const double floor_y = min_.y() + j * cell_m_;
      const double from = j == 0 ? lower.y() : std::max(lower.y(), floor_y - radius_m);
      const double to =
          j == rows_ - 1 ? upper.y() : std::min(upper.y(), floor_y + cell_m_ + radius_m);
      x = between(whole, lower, slope, from, to);
    }
    const double reach_m = radius_m + 1e-9;
    if (!visit_row(row_start_[j], column(x.left - reach_m), column(x.right + reach_m), f)) return;
  }
}

template <class F>
bool SiteCells::visit_row(int row_start, int first_column, int last_column, F&& f) const {
  for (int i = row_start + first_column; i <= row_start + last_column; ++i)
    for (std::int32_t k = head_[i]; k >= 0; k = next_[k])
      if (!f(k)) return false;
  return true;
}

int SiteCells::column(double x) const {
  return static_cast<int>(std::clamp((x - min_.x()) / cell_m_, 0.0, columns_ - 1.0));
}

int SiteCells::row(double y) const {
  return static_cast<int>(std::clamp((y - min_.y()) / cell_m_, 0.0, rows_ - 1.0));
}

}  // namespace voronaut
