#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "voronaut/environments/shapes/geometry.h"
#include "voronaut/planners/mapping/index/square_grid.h"

namespace voronaut {

// What the points added so far mean for a disc of one radius, in cells of the plane: where it
// touches no point wherever in the cell it is, where it touches one for sure, and how far the
// nearest point is at least. So most of what a planner asks is told by a look or a few; what is
// told neither way is left to the points. Memory: about 600 bytes per 4 x 4 m within 2 m of a
// point.
//
// Tiles of cells are found by one look-up without search. Some few share their place: they know
// less then, nothing wrong.
class ClearanceField {
 public:
  static constexpr double kLargestRadiusM = 1.5;
  // No bound is larger: nothing is known of points farther away.
  static constexpr double kReachM = 1.75;

  // 0 <= radius_m <= kLargestRadiusM.
  explicit ClearanceField(double radius_m) : radius_m_(radius_m) {}

  double radius_m() const { return radius_m_; }
  std::size_t points() const { return points_.size(); }

  // O(1) on the average: the cells within reach, and all points again whenever the tiles double.
  void add(const Vec2& p);

  enum class Disc { clear, touching, undecided };
  // A disc of radius_m() around p.
  Disc disc_at(const Vec2& p) const {
    const Cell cell = grid_.cell_of(p.x(), p.y());
    const Tile& tile = tile_at(cell);
    const std::uint32_t row = cell.y % kTileCells;
    const std::uint32_t column = cell.x % kTileCells;
    if ((tile.near[row] >> column & 1) == 0) return Disc::clear;
    const bool touched = (tile.touched[row] >> column & 1) != 0 && tile.owner == tile_of(cell);
    return touched ? Disc::touching : Disc::undecided;
  }

  // No added point is closer to p than this. Not larger than kReachM; less than the true distance
  // by 0.54 m at most.
  double bound_m(const Vec2& p) const {
    const Cell cell = grid_.cell_of(p.x(), p.y());
    const std::uint32_t row = cell.y % kTileCells / 2;
    return kUnitM * tile_at(cell).bound[row * kTileBounds + cell.x % kTileCells / 2];
  }

 private:
  static constexpr double kCellM = 0.125;
  static constexpr std::uint32_t kTileCells = 32;
  static constexpr std::uint32_t kTileBounds = kTileCells / 2;  // in each direction
  // Less than it is by more than rounding can move a place.
  static constexpr double kUnitM = (1 - 1e-6) * kReachM / 255;

  static constexpr int kFirstPlacesLog2 = 10;
  static constexpr std::size_t kPlacesPerTile = 16;  // at least, so that few tiles share one
  static constexpr int kGrowthLog2 = 2;
  static constexpr std::size_t kGrowth = 1 << kGrowthLog2;

  struct Tile {
    Tile() { bound.fill(255); }
    std::array<std::uint8_t, std::size_t{kTileBounds} * kTileBounds> bound;
    // By row, a bit per cell: whether some place in it has a point within radius_m_, and whether
    // every place has (that of the tile that was here first only).
    std::array<std::uint32_t, kTileCells> near{};
    std::array<std::uint32_t, kTileCells> touched{};
    Cell owner;
  };

  std::size_t place_of(std::uint32_t tile_x, std::uint32_t tile_y) const {
    return (tile_x * 0x9e37'79b1U + tile_y * 0x85eb'ca77U) >> shift_;
  }
  static Cell tile_of(Cell cell) { return {cell.x / kTileCells, cell.y / kTileCells}; }
  const Tile& tile_at(Cell cell) const {
    return tiles_[tile_at_[place_of(cell.x / kTileCells, cell.y / kTileCells)]];
  }
  // Two neighbours in x: a disc of kLargestRadiusM around any place of the left one fits in.
  struct RowOfTiles {
    std::uint32_t left;
    std::uint32_t right;
    Cell first;
  };

  std::uint32_t tile_to_mark(std::uint32_t tile_x, std::uint32_t tile_y);  // its index
  void mark_all_again();
  void mark_around(const Vec2& p);
  void lower_bounds(Cell cell);
  void mark_discs(const Vec2& p, Cell own);
  // Columns `begin` to `end` - 1 of a row; at most as many as a tile has.
  void mark(std::array<std::uint32_t, kTileCells> Tile::*bits, const RowOfTiles& tiles,
            std::uint32_t row, std::uint32_t begin, std::uint32_t end);

  double radius_m_;
  SquareGrid grid_{kCellM};
  int shift_ = 32 - kFirstPlacesLog2;
  std::vector<std::uint32_t> tile_at_ =
      std::vector<std::uint32_t>(std::size_t{1} << kFirstPlacesLog2);
  std::vector<Tile> tiles_ = std::vector<Tile>(1);  // the first is that of places out of reach
  std::vector<Vec2> points_;
};

}  // namespace voronaut
