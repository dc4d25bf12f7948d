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
  grid_ = CellGrid(area, std::max(cell_m, std::sqrt(size.x() * size.y() / kMaxCells)));
  head_.clear();
  row_start_.assign(static_cast<std::size_t>(grid_.rows()), kNoPoints);
  next_.clear();
  points_.clear();
}

void SiteCells::add(const Vec2& p) {
  std::int32_t& start = row_start_[grid_.row(p.y())];
  if (start == kNoPoints) {
    start = static_cast<std::int32_t>(head_.size());
    head_.resize(head_.size() + static_cast<std::size_t>(grid_.columns()), -1);
  }
  std::int32_t& head = head_[start + grid_.column(p.x())];
  next_.push_back(head);
  head = static_cast<std::int32_t>(points_.size());
  points_.push_back(p);
}

bool SiteCells::swept_disc_is_clear(const Vec2& a, const Vec2& b, double radius_m) const {
  const Vec2 along = b - a;
  const double length_sq = along.squaredNorm();
  const double radius_sq = radius_m * radius_m;
  bool clear = true;
  for_each_near({a, b}, radius_m, [&](std::int32_t k) {
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
  for_each_near({a, b}, radius_m, [&](std::int32_t k) {
    const double sq = distance_sq(points_[k], a, along, length_sq);
    if (sq < deepest_sq) {
      deepest_sq = sq;
      deepest = k;
    }
    return true;
  });
  return deepest;
}

template <class F>
void SiteCells::for_each_near(const Segment& s, double radius_m, F&& f) const {
  constexpr double kRounding_m = 1e-9;
  grid_.for_cells_near(
      s, radius_m + kRounding_m,
      [&](int y, int x0, int x1) {
        for (int i = row_start_[y] + x0; i <= row_start_[y] + x1; ++i)
          for (std::int32_t k = head_[i]; k >= 0; k = next_[k])
            if (!f(k)) return false;
        return true;
      },
      [&](int y) { return row_start_[y] != kNoPoints; });
}

}  // namespace voronaut
