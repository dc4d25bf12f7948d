#include "voronaut/planners/mapping/free_space/free_space.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace voronaut {

namespace {

constexpr int kWordBits = 64;
constexpr unsigned kInWord = kWordBits - 1;
constexpr double kChord_rad = 0.07;

// std::floor() is a call without SSE4.1.
int floor_of(double x) {
  const int truncated = static_cast<int>(x);
  return truncated - (x < truncated ? 1 : 0);
}
int ceil_of(double x) { return -floor_of(-x); }

std::uint64_t bits_from(unsigned column) { return ~0ULL << (column & kInWord); }
std::uint64_t bits_to(unsigned column) { return ~0ULL >> (kInWord - (column & kInWord)); }  // incl.

// Sets the columns [from, to] of a row.
void set_columns(std::uint64_t* row, unsigned from, unsigned to) {
  const unsigned first = from / kWordBits, last = to / kWordBits;
  if (first == last) {
    row[first] |= bits_from(from) & bits_to(to);
    return;
  }
  row[first] |= bits_from(from);
  for (unsigned w = first + 1; w < last; ++w) row[w] = ~0ULL;
  row[last] |= bits_to(to);
}

// Bit i of the result is the parity of bits 0..i.
std::uint64_t running_parity(std::uint64_t bits) {
  for (int shift = 1; shift < kWordBits; shift *= 2) bits ^= bits << shift;
  return bits;
}

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

// How far a beam has shown empty. The surface between two beams may stand out towards the sensor: a
// right-angled corner by half their spacing.
double free_length_m(const Scan& scan, std::size_t i, double half_spacing_rad) {
  const double range_m = scan.range_m[i];
  if (range_m == scan.max_range_m) return range_m;
  return scan.is_return(i) ? range_m * (1 - half_spacing_rad) : 0;
}

}  // namespace

FreeSpace::FreeSpace(const Bounds& bounds_world, const FreeSpaceConfig& config)
    : cell_m_(config.cell_m), origin_(bounds_world.min) {
  const Vec2 size = (bounds_world.max - bounds_world.min) / cell_m_;
  constexpr double kMaxSide = 100'000;
  if (!(size.minCoeff() > 0) || size.maxCoeff() > kMaxSide) {
    throw std::invalid_argument("FreeSpace: bounds must have between 1 and 100000 cells a side");
  }
  columns_ = static_cast<int>(std::ceil(size.x()));
  rows_ = static_cast<int>(std::ceil(size.y()));
  words_per_row_ = (columns_ + kWordBits - 1) / kWordBits;
  free_.assign(static_cast<std::size_t>(words_per_row_) * static_cast<std::size_t>(rows_), 0);
}

void FreeSpace::update(const Scan& scan) {
  if (scan.size() < 2) return;
  trace_star(scan);
  if (!open_window()) return;
  for (std::size_t i = 0; i + 1 < outline_.size(); ++i) draw_edge(outline_[i], outline_[i + 1]);
  draw_edge(outline_.back(), outline_.front());
  commit_window();
}

void FreeSpace::trace_star(const Scan& scan) {
  outline_.clear();
  const bool full = scan.beams->full_circle();
  const Vec2 sensor = to_cells(scan.sensor_world.p_world);
  const double half_spacing_rad = 0.5 * scan.beams->bearing_step_rad;
  const std::size_t n = scan.size();
  const std::size_t triangles = full ? n : n - 1;
  if (!full) outline_.push_back(sensor);

  // Where nothing is in range, one chord spans several beams, a millimetre inside their arc.
  const auto chorded_max = static_cast<int>(kChord_rad / scan.beams->bearing_step_rad);
  int chorded = 0;

  double length_m = free_length_m(scan, 0, half_spacing_rad);
  Vec2 direction = scan.direction_world(0) / cell_m_;
  for (std::size_t i = 0; i < triangles; ++i) {
    const std::size_t next = i + 1 < n ? i + 1 : 0;
    const double next_length_m = free_length_m(scan, next, half_spacing_rad);
    const Vec2 next_direction = scan.direction_world(next) / cell_m_;
    const double both_m = std::min(length_m, next_length_m);
    const Vec2 corner = sensor + both_m * direction;
    if (outline_.empty() || corner != outline_.back()) outline_.push_back(corner);
    const Vec2 next_corner = sensor + both_m * next_direction;
    const bool nothing_in_range = both_m == scan.max_range_m;
    if (nothing_in_range && chorded > 0 && chorded < chorded_max) {
      outline_.back() = next_corner;
      ++chorded;
    } else {
      outline_.push_back(next_corner);
      chorded = nothing_in_range ? 1 : 0;
    }
    length_m = next_length_m;
    direction = next_direction;
  }
}

bool FreeSpace::open_window() {
  Vec2 low = outline_.front(), high = outline_.front();
  for (const Vec2& p : outline_) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  // Rows may be cut off by the bounds; columns are kept whole, or parity would be lost.
  window_.first_row = std::max(0, floor_of(low.y()));
  window_.rows = std::min(rows_ - 1, floor_of(high.y())) - window_.first_row + 1;
  const auto word_of = [](double column) { return floor_of(column / kWordBits); };
  window_.first_word = word_of(low.x());
  window_.words = word_of(high.x() + 1) - window_.first_word + 1;
  if (window_.rows <= 0) return false;
  const auto size =
      static_cast<std::size_t>(window_.rows) * static_cast<std::size_t>(window_.words);
  window_.parity.assign(size, 0);
  window_.touched.assign(size, 0);
  return true;
}

void FreeSpace::draw_edge(const Vec2& from, const Vec2& to) {
  const bool rising = from.y() <= to.y();
  const Vec2 &a = rising ? from : to, &b = rising ? to : from;
  const int first = floor_of(a.y()), last = floor_of(b.y());
  if (first == last) return draw_in_row(first, a, b);  // most edges are shorter than a cell
  const double slope = (b.x() - a.x()) / (b.y() - a.y());
  const auto x_at = [&](double y) { return a.x() + (y - a.y()) * slope; };
  const int first_drawn = std::max(first, window_.first_row);
  const int last_drawn = std::min(last, window_.first_row + window_.rows - 1);
  double x_enters = first < first_drawn ? x_at(first_drawn) : a.x();
  for (int row = first_drawn; row <= last_drawn; ++row) {
    const double x_leaves = row < last ? x_at(row + 1) : b.x();
    touch(row, x_enters, x_leaves);
    x_enters = x_leaves;
    const double middle = row + 0.5;
    if (a.y() <= middle && middle < b.y()) cross_middle(row, x_at(middle));
  }
}

void FreeSpace::draw_in_row(int row, const Vec2& a, const Vec2& b) {
  if (row < window_.first_row || row >= window_.first_row + window_.rows) return;
  touch(row, a.x(), b.x());
  const double middle = row + 0.5;
  if (a.y() <= middle && middle < b.y())
    cross_middle(row, a.x() + (middle - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
}

// The outline runs through this row between two abscissas.
void FreeSpace::touch(int row, double x, double x_other) {
  const int shift = window_.first_word * kWordBits;  // columns may be negative outside the bounds
  int from = floor_of(x) - shift, to = floor_of(x_other) - shift;
  if (from > to) std::swap(from, to);
  set_columns(window_.row(window_.touched, row), static_cast<unsigned>(from),
              static_cast<unsigned>(to));
}

// The outline crosses the middle of this row.
void FreeSpace::cross_middle(int row, double x) {
  const int shift = window_.first_word * kWordBits;
  const auto column =
      static_cast<unsigned>(ceil_of(x - 0.5) - shift);  // first centre not left of it
  window_.row(window_.parity, row)[column / kWordBits] ^= 1ULL << (column & kInWord);
}

void FreeSpace::commit_window() {
  for (int row = window_.first_row; row < window_.first_row + window_.rows; ++row) {
    const std::uint64_t* parity = window_.row(window_.parity, row);
    const std::uint64_t* touched = window_.row(window_.touched, row);
    std::uint64_t* known = free_.data() + static_cast<std::size_t>(row) * words_per_row_;
    std::uint64_t carry = 0;  // all ones while inside
    for (int w = 0; w < window_.words; ++w) {
      const std::uint64_t inside = parity[w] == 0 ? carry : running_parity(parity[w]) ^ carry;
      carry = 0 - (inside >> (kWordBits - 1));
      const int word = window_.first_word + w;
      if (word < 0 || word >= words_per_row_) continue;
      std::uint64_t seen = inside & ~touched[w];
      if (word == words_per_row_ - 1) seen &= bits_to(columns_ - 1);
      known[word] |= seen;
    }
  }
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
    if (from <= to) {
      set_columns(free_.data() + static_cast<std::size_t>(row) * words_per_row_,
                  static_cast<unsigned>(from), static_cast<unsigned>(to));
    }
  }
}

bool FreeSpace::is_free(const Vec2& p_world) const {
  const Vec2 cell = to_cells(p_world);
  if (cell.y() < 0 || cell.y() >= rows_) return false;
  return row_is_free(static_cast<int>(cell.y()), cell.x(), cell.x());
}

bool FreeSpace::row_is_free(int row, double column_from, double column_to) const {
  if (row < 0 || row >= rows_ || column_from < 0 || column_to >= columns_) return false;
  const int from = static_cast<int>(column_from), to = static_cast<int>(column_to);
  const std::uint64_t* known = free_.data() + static_cast<std::size_t>(row) * words_per_row_;
  const int first = from / kWordBits, last = to / kWordBits;
  for (int w = first; w <= last; ++w) {
    std::uint64_t wanted = ~0ULL;
    if (w == first) wanted &= bits_from(from);
    if (w == last) wanted &= bits_to(to);
    if ((known[w] & wanted) != wanted) return false;
  }
  return true;
}

bool FreeSpace::swept_disc_is_free(const Vec2& a_world, const Vec2& b_world,
                                   double radius_m) const {
  const Vec2 a = to_cells(a_world), b = to_cells(b_world);
  const double radius = radius_m / cell_m_;
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

std::size_t FreeSpace::free_cells() const {
  std::size_t count = 0;
  for (const std::uint64_t word : free_) count += static_cast<std::size_t>(std::popcount(word));
  return count;
}

}  // namespace voronaut
