#include "voronaut/planners/mapping/free_space/free_space.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

#include "voronaut/planners/mapping/free_space/row_words.h"

namespace voronaut {

using row_words::bits_from;
using row_words::bits_up_to;
using row_words::ceil_of;
using row_words::floor_of;
using row_words::word_of;

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

// In the units of a lattice.
class FreeSpace::SweptDisc {
 public:
  SweptDisc(const Vec2& a, const Vec2& b, double radius)
      : a_(a),
        b_(b),
        radius_(radius),
        right_(a - side(), b - side()),
        left_(a + side(), b + side()) {}

  int first_row() const { return floor_of(std::min(a_.y(), b_.y()) - radius_); }
  int last_row() const { return floor_of(std::max(a_.y(), b_.y()) + radius_); }
  // The swept disc is the convex hull of its two ends and its two sides; so is its extent in a row.
  RowExtent in_row(int row) const {
    RowExtent extent;
    extent.add_disc(row, a_, radius_);
    extent.add_disc(row, b_, radius_);
    extent.add_edge(row, right_);
    extent.add_edge(row, left_);
    return extent;
  }

 private:
  Vec2 side() const {
    const Vec2 along = b_ - a_;
    const double length = along.norm();
    return length > 0 ? Vec2(left_of(along) * (radius_ / length)) : Vec2(0, 0);
  }

  Vec2 a_, b_;
  double radius_;
  SlantedEdge right_, left_;
};

// A convex polygon grown by a radius, in the units of a lattice.
class FreeSpace::GrownPolygon {
 public:
  GrownPolygon(const FreeSpace& space, const Lattice& lattice, std::span<const Vec2> corners_world,
               double grown_m)
      : radius_(grown_m / lattice.side_m) {
    corners_.reserve(corners_world.size());
    for (const Vec2& corner : corners_world) corners_.push_back(space.in(lattice, corner));
    const Bounds box = bounds_of(corners_);
    low_ = box.min;
    high_ = box.max;
  }

  const Vec2& low() const { return low_; }
  const Vec2& high() const { return high_; }
  double radius() const { return radius_; }
  int first_row() const { return floor_of(low_.y() - radius_); }
  int last_row() const { return floor_of(high_.y() + radius_); }
  RowExtent in_row(int row) const {
    RowExtent extent;
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      const Vec2 &a = corners_[i], &b = corners_[(i + 1) % corners_.size()];
      const Vec2 along = b - a;
      const double length = along.norm();
      const Vec2 outwards = length > 0 ? Vec2(left_of(along) * (-radius_ / length)) : Vec2(0, 0);
      extent.add_disc(row, a, radius_);
      extent.add_edge(row, SlantedEdge(a + outwards, b + outwards));
    }
    return extent;
  }

 private:
  std::vector<Vec2> corners_;
  Vec2 low_, high_;
  double radius_;
};

FreeSpace::Lattice::Lattice(const Vec2& size_m, double side) : side_m(side) {
  const Vec2 size = size_m / side;
  if (!(size.minCoeff() > 0) || !(size.maxCoeff() <= kCellsMax)) {
    throw std::invalid_argument("FreeSpace: bounds must have between 1 and " +
                                std::to_string(static_cast<int>(kCellsMax)) + " cells a side");
  }
  columns = static_cast<int>(std::ceil(size.x()));
  rows = static_cast<int>(std::ceil(size.y()));
}

void FreeSpace::Lattice::mark_disc(const Vec2& center, double radius) {
  const int first = std::max(0, ceil_of(center.y() - radius));
  const int last = std::min(rows - 1, floor_of(center.y() + radius) - 1);
  for (int row = first; row <= last; ++row) {
    const double away = std::max(center.y() - row, row + 1 - center.y());  // of its farther edge
    const double half = std::sqrt(std::max(0.0, radius * radius - away * away));
    const int from = std::max(0, ceil_of(center.x() - half));
    const int to = std::min(columns - 1, floor_of(center.x() + half) - 1);
    if (from <= to) free.set(row, from, to);
  }
}

// A cell lies within a convex polygon if its corners do.
void FreeSpace::Lattice::mark_convex(std::span<const Vec2> corners) {
  const auto [low, high] = bounds_of(corners);
  for (int row = std::max(0, ceil_of(low.y())); row < std::min<double>(rows, high.y()); ++row) {
    for (int column = std::max(0, ceil_of(low.x())); column < std::min<double>(columns, high.x());
         ++column) {
      const Vec2 cell(column, row);
      if (voronaut::holds(corners, cell) && voronaut::holds(corners, cell + Vec2(1, 0)) &&
          voronaut::holds(corners, cell + Vec2(0, 1)) &&
          voronaut::holds(corners, cell + Vec2(1, 1)))
        free.set(row, column, column);
    }
  }
}

bool FreeSpace::Lattice::is_free(const Vec2& p) const {
  if (p.y() < 0 || !holds(static_cast<int>(p.y()), p.x(), p.x())) return false;
  return free.all_set(static_cast<int>(p.y()), static_cast<int>(p.x()), static_cast<int>(p.x()));
}

// Of all cells in the box around a swept disc: most often that decides.
bool FreeSpace::Lattice::box_is_free(const Vec2& a, const Vec2& b, double radius) const {
  const double reach = radius + kRounding_cells;
  const double left = std::min(a.x(), b.x()) - reach, right = std::max(a.x(), b.x()) + reach;
  const double low = std::min(a.y(), b.y()) - reach, high = std::max(a.y(), b.y()) + reach;
  if (!(left >= 0 && low >= 0 && right < columns && high < rows)) return false;
  return free.all_set(static_cast<int>(low), static_cast<int>(high), static_cast<int>(left),
                      static_cast<int>(right));
}

FreeSpace::FreeSpace(const Bounds& bounds_world, const FreeSpaceConfig& config)
    : origin_(bounds_world.min),
      splits_(config.splits),
      near_m_(config.near_m),
      cells_(bounds_world.max - bounds_world.min, config.cell_m),
      parts_(bounds_world.max - bounds_world.min, config.cell_m / config.splits) {
  if (splits_ < 1 || splits_ > kSplitsMax || !std::has_single_bit(static_cast<unsigned>(splits_)))
    throw std::invalid_argument("FreeSpace: splits must be 1, 2, 4 or 8");
}

void FreeSpace::update(const Scan& scan) {
  if (scan.size() < 2) return;
  const Vec2& p = scan.sensor_world.p_world;
  sees_whole_ = !has_parts() || !sees_whole_;
  if (sees_whole_) {
    raster_.fill(star_.trace(scan, in(cells_, p), cells_.side_m), cells_.columns, cells_.rows,
                 cells_.free);
    return;
  }
  // Of a cell on the outline no place is farther from it than the cell's diagonal.
  const double depth_m = std::numbers::sqrt2 * (cells_.side_m + parts_.side_m);
  for (std::size_t beam = 0;;) {
    const ScanStar::Outline part =
        star_.trace_near(scan, in(parts_, p), parts_.side_m, near_m_, depth_m, beam);
    if (part.corners.empty()) return;
    raster_.fill(part, parts_.columns, parts_.rows, parts_.free);
  }
}

void FreeSpace::mark_disc(const Vec2& p_world, double radius_m) {
  cells_.mark_disc(in(cells_, p_world), radius_m / cells_.side_m);
  if (has_parts()) parts_.mark_disc(in(parts_, p_world), radius_m / parts_.side_m);
}

void FreeSpace::mark_convex(std::span<const Vec2> corners_world) {
  std::vector<Vec2> corners;
  for (Lattice* lattice : {&cells_, &parts_}) {
    if (lattice == &parts_ && !has_parts()) break;
    corners.clear();
    for (const Vec2& corner : corners_world) corners.push_back(in(*lattice, corner));
    lattice->mark_convex(corners);
  }
}

bool FreeSpace::is_free(const Vec2& p_world) const {
  return cells_.is_free(in(cells_, p_world)) ||
         (has_parts() && parts_.is_free(in(parts_, p_world)));
}

bool FreeSpace::swept_disc_is_free(const Vec2& a_world, const Vec2& b_world,
                                   double radius_m) const {
  const Vec2 a = in(cells_, a_world), b = in(cells_, b_world);
  const double radius = radius_m / cells_.side_m;
  if (cells_.box_is_free(a, b, radius)) return true;
  return is_free(SweptDisc(a, b, radius), [&] {
    return SweptDisc(in(parts_, a_world), in(parts_, b_world), radius_m / parts_.side_m);
  });
}

bool FreeSpace::convex_is_free(std::span<const Vec2> corners_world, double grown_m) const {
  const GrownPolygon grown(*this, cells_, corners_world, grown_m);
  return cells_.box_is_free(grown.low(), grown.high(), grown.radius()) ||
         is_free(grown, [&] { return GrownPolygon(*this, parts_, corners_world, grown_m); });
}

template <class Region, class InParts>
bool FreeSpace::is_free(const Region& region, const InParts& in_parts) const {
  std::optional<Region> fine;
  const int last = region.last_row();
  for (int row = region.first_row(); row <= last; ++row) {
    const RowExtent extent = region.in_row(row);
    if (extent.from > extent.to) continue;
    if (!cells_.holds(row, extent.from, extent.to)) return false;
    const int from = static_cast<int>(extent.from), to = static_cast<int>(extent.to);
    if (cells_.free.all_set(row, from, to)) continue;
    if (!has_parts()) return false;
    if (!fine) fine.emplace(in_parts());
    if (!parts_are_free(row, from, to, *fine)) return false;
  }
  return true;
}

// Of the unknown ones among the cells [column_from, column_to] of a row, the parts touched. The
// parts of a cell are consecutive bits of consecutive words of one tile.
template <class Region>
bool FreeSpace::parts_are_free(int row, int column_from, int column_to,
                               const Region& region) const {
  struct Columns {
    int from, to;
  };
  std::array<Columns, kSplitsMax> touched;
  bool looked_up = false;
  const int first_row = row * splits_;
  for (int column = column_from; column <= column_to; ++column) {
    if (cells_.free.all_set(row, column, column)) continue;
    const int first = column * splits_, last = first + splits_ - 1;
    const std::uint64_t* const known = parts_.free.at(word_of(first_row), word_of(first)).data() +
                                       (first_row & (BitTiles::kSide - 1));
    std::uint64_t any = 0;
    for (int i = 0; i < splits_; ++i) any |= known[i];
    if ((any & bits_from(first) & bits_up_to(last)) == 0) return false;
    for (int i = 0; i < splits_ && !looked_up; ++i) {
      const RowExtent extent = region.in_row(first_row + i);
      const bool none = extent.from > extent.to;
      touched[static_cast<std::size_t>(i)] = {none ? 0 : floor_of(extent.from),
                                              none ? -1 : floor_of(extent.to)};
    }
    looked_up = true;
    for (int i = 0; i < splits_; ++i) {
      const Columns& columns = touched[static_cast<std::size_t>(i)];
      const int from = std::max(columns.from, first), to = std::min(columns.to, last);
      if (from > to) continue;
      if ((bits_from(from) & bits_up_to(to) & ~known[i]) != 0) return false;
    }
  }
  return true;
}

}  // namespace voronaut
