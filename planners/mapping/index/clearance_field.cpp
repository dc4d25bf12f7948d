#include "voronaut/planners/mapping/index/clearance_field.h"

#include <algorithm>
#include <cmath>

namespace voronaut {
namespace {

constexpr int kReachBounds = 7;  // cells of bounds that a point lowers to each side
constexpr int kSpan = 2 * kReachBounds + 1;
constexpr int kRowBounds = 16;
constexpr int kHalves = 2;  // of a cell of bounds: a point is known to one when it lowers them
constexpr std::uint8_t kFar = 255;

// Cells are marked as near, or not as touched, by this much more than asked, so that rounding can
// neither lose a point on the rim nor find one.
constexpr double kRoundingMarginM = 1e-6;

// A row of bounds with room before and behind it, for reading a whole row of a tile from any place.
using BoundRow = std::array<std::uint8_t, std::size_t{3} * kRowBounds>;
using BoundMark = std::array<BoundRow, kSpan>;

constexpr int floor_of_root(int square) {
  int root = square;
  while (root > 0 && root > square / root) root = (root + square / root) / 2;
  return root;
}

// In halves, from half `half` of cell 0 to the nearest place of the given cell.
constexpr int halves_to(int cell, int half) {
  if (cell > 0) return kHalves * cell - half - 1;
  return cell < 0 ? half - kHalves * cell - kHalves : 0;
}

// Rounded down to whole units of kReachM / 255.
constexpr std::uint8_t bound_at(int halves_x, int halves_y) {
  const int square = halves_x * halves_x + halves_y * halves_y;
  const int units = floor_of_root(255 * 255 * square) / (kHalves * kReachBounds);
  return static_cast<std::uint8_t>(std::min<int>(units, kFar));
}

constexpr BoundMark mark_from(int half_x, int half_y) {
  BoundMark mark{};
  for (int y = 0; y < kSpan; ++y) {
    mark[y].fill(kFar);
    for (int x = 0; x < kSpan; ++x) {
      mark[y][kRowBounds + x] =
          bound_at(halves_to(x - kReachBounds, half_x), halves_to(y - kReachBounds, half_y));
    }
  }
  return mark;
}

constexpr std::size_t kBoundMarkCount = std::size_t{kHalves} * kHalves;
constexpr std::array<BoundMark, kBoundMarkCount> kBoundMarks{mark_from(0, 0), mark_from(1, 0),
                                                             mark_from(0, 1), mark_from(1, 1)};

void lower(std::uint8_t* row, const std::uint8_t* mark) {
  std::array<std::uint8_t, kRowBounds> bounds;
  std::copy_n(row, kRowBounds, bounds.data());
  for (int i = 0; i < kRowBounds; ++i) bounds[i] = std::min(bounds[i], mark[i]);
  std::copy_n(bounds.data(), kRowBounds, row);
}

}  // namespace

std::uint32_t ClearanceField::tile_to_mark(std::uint32_t tile_x, std::uint32_t tile_y) {
  std::uint32_t& place = tile_at_[place_of(tile_x, tile_y)];
  if (place == 0) {
    place = static_cast<std::uint32_t>(tiles_.size());
    tiles_.emplace_back().owner = {tile_x, tile_y};
  }
  return place;
}

void ClearanceField::add(const Vec2& p) {
  points_.push_back(p);
  mark_around(p);
  if (kPlacesPerTile * tiles_.size() > tile_at_.size()) mark_all_again();
}

void ClearanceField::mark_all_again() {
  while (kPlacesPerTile * tiles_.size() > tile_at_.size()) {
    tile_at_.assign(kGrowth * tile_at_.size(), 0);
    shift_ -= kGrowthLog2;
    tiles_.resize(1);
    for (const Vec2& p : points_) mark_around(p);
  }
}

void ClearanceField::mark_around(const Vec2& p) {
  const Cell cell = grid_.cell_of(p.x(), p.y());
  lower_bounds(cell);
  mark_discs(p, cell);
}

void ClearanceField::lower_bounds(Cell cell) {
  static_assert(kRowBounds == kTileBounds && kReachBounds * kHalves * kCellM == kReachM);
  const BoundMark& mark = kBoundMarks[kHalves * (cell.y % kHalves) + cell.x % kHalves];
  const std::uint32_t left = cell.x / kHalves - kReachBounds;
  const std::uint32_t bottom = cell.y / kHalves - kReachBounds;
  for (std::uint32_t x = left / kTileBounds; x <= (left + kSpan - 1) / kTileBounds; ++x) {
    for (std::uint32_t y = bottom / kTileBounds; y <= (bottom + kSpan - 1) / kTileBounds; ++y) {
      const std::uint32_t from = std::max(bottom, y * kTileBounds);
      const std::uint32_t to = std::min(bottom + kSpan, (y + 1) * kTileBounds);
      Tile& tile = tiles_[tile_to_mark(x, y)];
      std::uint8_t* row = tile.bound.data() + std::size_t{from % kTileBounds} * kTileBounds;
      const std::uint32_t before = kTileBounds * (x + 1) - left;
      const std::uint8_t* lowered = mark[from - bottom].data() + before;
      for (std::uint32_t i = from; i < to; ++i, row += kTileBounds, lowered += sizeof(BoundRow)) {
        lower(row, lowered);
      }
    }
  }
}

// Row by row of cells: how far to each side of p they are within the radius in part, or whole.
void ClearanceField::mark_discs(const Vec2& p, Cell own) {
  const double near_m = radius_m_ + kRoundingMarginM;
  const double touched_m = std::max(0.0, radius_m_ - kRoundingMarginM);
  const std::uint32_t first = grid_.cell_of(p.x(), p.y() - near_m).y;
  const std::uint32_t last = grid_.cell_of(p.x(), p.y() + near_m).y;
  const std::uint32_t left = grid_.cell_of(p.x() - near_m, 0).x / kTileCells;
  const double in_own_m = p.y() - kCellM * std::nearbyint(p.y() / kCellM) + kCellM / 2;
  double low_m = -in_own_m - kCellM * (own.y - first);  // the lower edge of the row, seen from p
  RowOfTiles tiles{};
  for (std::uint32_t row = first; row <= last; ++row, low_m += kCellM) {
    if (row == first || row % kTileCells == 0) {
      tiles = {tile_to_mark(left, row / kTileCells), tile_to_mark(left + 1, row / kTileCells),
               Cell{left, row / kTileCells}};
    }
    const double high_m = low_m + kCellM;
    const double closest_m = std::max({low_m, -high_m, 0.0});
    const double farthest_m = std::max(-low_m, high_m);
    const double near_sq = near_m * near_m - closest_m * closest_m;
    const double touched_sq = touched_m * touched_m - farthest_m * farthest_m;
    if (near_sq > 0) {
      const double aside_m = std::sqrt(near_sq) + kRoundingMarginM;
      mark(&Tile::near, tiles, row, grid_.cell_of(p.x() - aside_m, 0).x,
           grid_.cell_of(p.x() + aside_m, 0).x + 1);
    }
    if (touched_sq > 0) {
      const double aside_m = std::sqrt(touched_sq) - kRoundingMarginM;
      mark(&Tile::touched, tiles, row, grid_.cell_of(p.x() - aside_m, 0).x + 1,
           grid_.cell_of(p.x() + aside_m, 0).x);
    }
  }
}

void ClearanceField::mark(std::array<std::uint32_t, kTileCells> Tile::*bits,
                          const RowOfTiles& tiles, std::uint32_t row, std::uint32_t begin,
                          std::uint32_t end) {
  if (begin >= end) return;
  const std::uint64_t run = (std::uint64_t{1} << (end - begin)) - 1;
  const std::uint64_t columns = run << (begin - kTileCells * tiles.first.x);
  const auto set = [&](std::uint32_t tile, std::uint64_t marks, Cell owner) {
    Tile& marked = tiles_[tile];
    if (bits == &Tile::near || marked.owner == owner) {
      (marked.*bits)[row % kTileCells] |= static_cast<std::uint32_t>(marks);
    }
  };
  set(tiles.left, columns, tiles.first);
  set(tiles.right, columns >> kTileCells, {tiles.first.x + 1, tiles.first.y});
}

}  // namespace voronaut
