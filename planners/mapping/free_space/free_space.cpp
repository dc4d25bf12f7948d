#include "voronaut/planners/mapping/free_space/free_space.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "voronaut/planners/mapping/free_space/row_words.h"

namespace voronaut {

using row_words::ceil_of;
using row_words::floor_of;

namespace {

constexpr double kRounding_cells = 1e-6;

// An edge with its lower end first; slope in columns per row.
struct SlantedEdge {
  Vec2 low, high;
  double slope;

  SlantedEdge(const Vec2& a, const Vec2& b)
      : low(a.y() <= b.y() ? a : b), high(a.y() <= b.y() ? b : a) {
    const double height = high.y() - low.y();
    slope = height > 0 ? (high.x() - low.x()) / height : 0;
  }
};

// Columns that shapes cover anywhere within a row, in cells.
struct RowExtent {
  double from = std::numeric_limits<double>::infinity();
  double to = -std::numeric_limits<double>::infinity();

  void add(double low, double high) {
    from = std::min(from, low);
    to = std::max(to, high);
  }

  void add_disc(int row, const Vec2& center, double radius) {
    const double away = std::max({0.0, row - center.y(), center.y() - (row + 1)});
    if (away > radius) return;
    const double half = std::sqrt(radius * radius - away * away);
    add(center.x() - half, center.x() + half);
  }

  void add_edge(int row, const SlantedEdge& e) {
    if (e.high.y() < row || e.low.y() > row + 1) return;
    const double x_low = e.low.x() + (std::max<double>(row, e.low.y()) - e.low.y()) * e.slope;
    const double x_high =
        e.high.y() > row + 1 ? e.low.x() + (row + 1 - e.low.y()) * e.slope : e.high.x();
    add(std::min(x_low, x_high), std::max(x_low, x_high));
  }
};

}  // namespace

FreeSpace::FreeSpace(const Bounds& bounds_world, const FreeSpaceConfig& config)
    : cell_m_(config.cell_m), origin_(bounds_world.min) {
  const Vec2 size = (bounds_world.max - bounds_world.min) / cell_m_;
  if (!(size.minCoeff() > 0) || !(size.maxCoeff() <= kCellsMax)) {
    throw std::invalid_argument("FreeSpace: bounds must have between 1 and " +
                                std::to_string(static_cast<int>(kCellsMax)) + " cells a side");
  }
  columns_ = static_cast<int>(std::ceil(size.x()));
  rows_ = static_cast<int>(std::ceil(size.y()));
}

void FreeSpace::update(const Scan& scan) {
  if (scan.size() < 2) return;
  star_.trace(scan, to_cells(scan.sensor_world.p_world), cell_m_);
  raster_.fill(star_, columns_, rows_, free_);
}

void FreeSpace::mark_disc(const Vec2& p_world, double radius_m) {
  const Vec2 center = to_cells(p_world);
  const double radius = radius_m / cell_m_;
  const int first = std::max(0, ceil_of(center.y() - radius));
  const int last = std::min(rows_ - 1, floor_of(center.y() + radius) - 1);
  for (int row = first; row <= last; ++row) {
    const double away = std::max(center.y() - row, row + 1 - center.y());  // of its farther edge
    const double half = std::sqrt(std::max(0.0, radius * radius - away * away));
    const int from = std::max(0, ceil_of(center.x() - half));
    const int to = std::min(columns_ - 1, floor_of(center.x() + half) - 1);
    if (from <= to) free_.set(row, from, to);
  }
}

bool FreeSpace::is_free(const Vec2& p_world) const {
  const Vec2 cell = to_cells(p_world);
  if (cell.y() < 0 || cell.y() >= rows_) return false;
  return row_is_free(static_cast<int>(cell.y()), cell.x(), cell.x());
}

bool FreeSpace::row_is_free(int row, double column_from, double column_to) const {
  if (row < 0 || row >= rows_ || column_from < 0 || column_to >= columns_) return false;
  return free_.all_set(row, static_cast<int>(column_from), static_cast<int>(column_to));
}

// Of all cells in the box around a swept disc, in cells: most often that decides.
bool FreeSpace::box_is_free(const Vec2& a, const Vec2& b, double radius) const {
  const double reach = radius + kRounding_cells;
  const double left = std::min(a.x(), b.x()) - reach, right = std::max(a.x(), b.x()) + reach;
  const double low = std::min(a.y(), b.y()) - reach, high = std::max(a.y(), b.y()) + reach;
  if (!(left >= 0 && low >= 0 && right < columns_ && high < rows_)) return false;
  return free_.all_set(static_cast<int>(low), static_cast<int>(high), static_cast<int>(left),
                       static_cast<int>(right));
}

bool FreeSpace::swept_disc_is_free(const Vec2& a_world, const Vec2& b_world,
                                   double radius_m) const {
  const Vec2 a = to_cells(a_world), b = to_cells(b_world);
  const double radius = radius_m / cell_m_;
  if (box_is_free(a, b, radius)) return true;
  const Vec2 along = b - a;
  const double length = along.norm();
  const Vec2 side = length > 0 ? Vec2(left_of(along) * (radius / length)) : Vec2(0, 0);

  const SlantedEdge right(a - side, b - side), left(a + side, b + side);

  const int first = floor_of(std::min(a.y(), b.y()) - radius);
  const int last = floor_of(std::max(a.y(), b.y()) + radius);
  for (int row = first; row <= last; ++row) {
    // The swept disc is the convex hull of its two ends and its two sides; so is its extent in a
    // row.
    RowExtent extent;
    extent.add_disc(row, a, radius);
    extent.add_disc(row, b, radius);
    extent.add_edge(row, right);
    extent.add_edge(row, left);
    if (extent.from <= extent.to && !row_is_free(row, extent.from, extent.to)) return false;
  }
  return true;
}

bool FreeSpace::convex_is_free(std::span<const Vec2> corners_world, double grown_m) const {
  const double radius = grown_m / cell_m_;
  Vec2 low = to_cells(corners_world.front()), high = low;
  for (const Vec2& corner : corners_world) {
    low = low.cwiseMin(to_cells(corner));
    high = high.cwiseMax(to_cells(corner));
  }
  if (box_is_free(low, high, radius)) return true;
  const std::size_t n = corners_world.size();
  for (int row = floor_of(low.y() - radius); row <= floor_of(high.y() + radius); ++row) {
    RowExtent extent;
    for (std::size_t i = 0; i < n; ++i) {
      const Vec2 a = to_cells(corners_world[i]), b = to_cells(corners_world[(i + 1) % n]);
      const Vec2 along = b - a;
      const double length = along.norm();
      const Vec2 outwards = length > 0 ? Vec2(left_of(along) * (-radius / length)) : Vec2(0, 0);
      extent.add_disc(row, a, radius);
      extent.add_edge(row, SlantedEdge(a + outwards, b + outwards));
    }
    if (extent.from <= extent.to && !row_is_free(row, extent.from, extent.to)) return false;
  }
  return true;
}

// A cell lies within a convex polygon if its corners do.
void FreeSpace::mark_convex(std::span<const Vec2> corners_world) {
  Vec2 low = to_cells(corners_world.front()), high = low;
  for (const Vec2& corner : corners_world) {
    low = low.cwiseMin(to_cells(corner));
    high = high.cwiseMax(to_cells(corner));
  }
  const auto holds = [&](const Vec2& cell) {
    for (std::size_t i = 0; i < corners_world.size(); ++i) {
      const Vec2 a = to_cells(corners_world[i]);
      const Vec2 along = to_cells(corners_world[(i + 1) % corners_world.size()]) - a;
      if (cross(along, cell - a) < 0) return false;
    }
    return true;
  };
  for (int row = std::max(0, ceil_of(low.y())); row < std::min<double>(rows_, high.y()); ++row) {
    for (int column = std::max(0, ceil_of(low.x())); column < std::min<double>(columns_, high.x());
         ++column) {
      const Vec2 cell(column, row);
      if (holds(cell) && holds(cell + Vec2(1, 0)) && holds(cell + Vec2(0, 1)) &&
          holds(cell + Vec2(1, 1)))
        free_.set(row, column, column);
    }
  }
}

}  // namespace voronaut
