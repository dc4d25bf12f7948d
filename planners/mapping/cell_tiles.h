#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "voronaut/environments/geometry.h"

namespace voronaut {

// A square cell of the plane. The coordinates are biased, so that they never are negative.
struct Cell {
  std::uint32_t x = 0;
  std::uint32_t y = 0;
  bool operator==(const Cell&) const = default;
};

// An unbounded grid that stores one number per occupied cell (the first item of a chain that the
// owner keeps) in tiles of 8 x 8 cells with a bit per cell: asking a box costs one hash look-up per
// tile it overlaps, empty cells nothing. Memory: one tile of 272 bytes per 8 x 8 cells that ever
// were occupied in part.
class CellTiles {
 public:
  static constexpr std::uint32_t kEmpty = 0xffff'ffff;
  static constexpr double kLargestCellIndex = 1 << 29;

  explicit CellTiles(double cell_m);

  double cell_m() const { return cell_m_; }

  // Monotone in both coordinates, which is all that boxes need. |x|, |y| < kLargestCellIndex cells.
  Cell cell_of(double x, double y) const { return {index_of(x), index_of(y)}; }

  // The number stored for a cell, kEmpty if there is none.
  std::uint32_t head(Cell cell) const {
    const std::size_t tile = find(cell.x >> 3, cell.y >> 3);
    return tile == kNoTile ? kEmpty : tiles_[tile].head[bit_of(cell)];
  }
  void set_head(Cell cell, std::uint32_t head);

  // Calls visit(head) for the occupied cells from `low` to `high` (both included) until it returns
  // true; returns whether it did. Row by row of tiles: the order depends on nothing but the cells.
  template <class Visit>
  bool any_of(Cell low, Cell high, const Visit& visit) const {
    for (std::uint32_t y = low.y >> 3; y <= high.y >> 3; ++y) {
      const std::uint64_t rows = rows_from(y == low.y >> 3 ? low.y & 7 : 0) &
                                 rows_up_to(y == high.y >> 3 ? high.y & 7 : 7);
      for (std::uint32_t x = low.x >> 3; x <= high.x >> 3; ++x) {
        const std::size_t found = find(x, y);
        if (found == kNoTile) continue;
        const Tile& tile = tiles_[found];
        std::uint64_t occupied = tile.occupied & rows &
                                 columns_from(x == low.x >> 3 ? low.x & 7 : 0) &
                                 columns_up_to(x == high.x >> 3 ? high.x & 7 : 7);
        for (; occupied != 0; occupied &= occupied - 1) {
          if (visit(tile.head[static_cast<std::size_t>(std::countr_zero(occupied))])) return true;
        }
      }
    }
    return false;
  }

 private:
  static constexpr std::size_t kNoTile = ~std::size_t{0};
  static constexpr std::uint64_t kEachRow = 0x0101'0101'0101'0101;

  struct Tile {
    std::uint64_t occupied = 0;  // bit 8 * (y mod 8) + (x mod 8)
    std::array<std::uint32_t, 64> head;
  };
  struct Slot {
    std::uint64_t key = ~std::uint64_t{0};  // no tile has this one
    std::uint32_t tile = kEmpty;
  };

  static std::uint64_t rows_from(std::uint32_t row) { return ~std::uint64_t{0} << (8 * row); }
  static std::uint64_t rows_up_to(std::uint32_t row) { return ~std::uint64_t{0} >> (56 - 8 * row); }
  static std::uint64_t columns_from(std::uint32_t column) {
    return ((0xffu << column) & 0xffu) * kEachRow;
  }
  static std::uint64_t columns_up_to(std::uint32_t column) {
    return (0xffu >> (7 - column)) * kEachRow;
  }
  static std::size_t bit_of(Cell cell) { return 8 * (cell.y & 7) + (cell.x & 7); }
  static std::uint64_t key_of(std::uint32_t x, std::uint32_t y) {
    return std::uint64_t{x} << 32 | y;
  }

  std::uint32_t index_of(double coordinate_m) const {
    return static_cast<std::uint32_t>(
        static_cast<std::int64_t>(coordinate_m * cells_per_m_ + kLargestCellIndex));
  }
  std::size_t first_slot(std::uint64_t key) const {
    return static_cast<std::size_t>((key * 0x9e37'79b9'7f4a'7c15) >> shift_);
  }
  std::size_t find(std::uint32_t x, std::uint32_t y) const {
    const std::uint64_t key = key_of(x, y);
    std::size_t slot = first_slot(key);
    while (slots_[slot].key != key) {
      if (slots_[slot].tile == kEmpty) return kNoTile;
      slot = (slot + 1) & (slots_.size() - 1);
    }
    return slots_[slot].tile;
  }
  void insert_slot(Slot slot);

  double cell_m_;
  double cells_per_m_;
  int shift_;
  std::vector<Slot> slots_;  // a power of two, at most half full; open addressing
  std::vector<Tile> tiles_;
};

}  // namespace voronaut
