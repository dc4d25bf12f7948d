#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "voronaut/benchmarks/micro/peers/measured_scan.h"

namespace voronaut::micro {

// A dense grid of log odds over given bounds. Returns raise their cell; with `carve`, every beam
// lowers the cells it crosses (Bresenham), misses too. It says where something is and where not,
// but no clusters, no extreme points, no gaps.
class OccupancyGrid {
 public:
  OccupancyGrid(const Bounds& bounds, double cell_m, bool carve)
      : origin_(bounds.min), cells_per_m_(1 / cell_m), carve_(carve) {
    const Vec2 size = bounds.max - bounds.min;
    columns_ = static_cast<int>(size.x() * cells_per_m_) + 1;
    rows_ = static_cast<int>(size.y() * cells_per_m_) + 1;
    cells_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
  }

  void insert(const MeasuredScan& scan) {
    const Vec2 from = scan.scan.sensor_world.p_world;
    if (carve_) {
      for (std::size_t i = 0; i < scan.scan.size(); ++i) carve(from, scan.scan.point_world(i));
    }
    for (const Vec2& p : scan.returns_world) change(column(p.x()), row(p.y()), kHit);
  }
  std::size_t size() const { return cells_.size(); }

 private:
  static constexpr int kHit = 8;
  static constexpr int kMiss = -4;
  static constexpr int kLimit = 100;

  int column(double x) const { return static_cast<int>((x - origin_.x()) * cells_per_m_); }
  int row(double y) const { return static_cast<int>((y - origin_.y()) * cells_per_m_); }
  void change(int x, int y, int by) {
    if (x < 0 || y < 0 || x >= columns_ || y >= rows_) return;
    std::int8_t& cell = cells_[static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) +
                               static_cast<std::size_t>(x)];
    cell = static_cast<std::int8_t>(std::clamp(cell + by, -kLimit, kLimit));
  }
  void carve(const Vec2& from, const Vec2& to) {
    int x = column(from.x());
    int y = row(from.y());
    const int end_x = column(to.x());
    const int end_y = row(to.y());
    const int dx = std::abs(end_x - x);
    const int dy = -std::abs(end_y - y);
    const int step_x = x < end_x ? 1 : -1;
    const int step_y = y < end_y ? 1 : -1;
    int error = dx + dy;
    while (x != end_x || y != end_y) {
      change(x, y, kMiss);
      const int twice = 2 * error;
      if (twice >= dy) {
        error += dy;
        x += step_x;
      }
      if (twice <= dx) {
        error += dx;
        y += step_y;
      }
    }
  }

  Vec2 origin_;
  double cells_per_m_;
  bool carve_;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<std::int8_t> cells_;
};

}  // namespace voronaut::micro
