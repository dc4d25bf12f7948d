#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

#include "voronaut/planners/mapping/index/square_grid.h"

namespace voronaut {

// Which of the 8 x 8 cells of a tile lie from or up to a row or column: bit 8 * row + column.
namespace tile_masks {

using Masks = std::array<std::uint64_t, 8>;

template <class Mask>
constexpr Masks each(Mask mask) {
  return {mask(0), mask(1), mask(2), mask(3), mask(4), mask(5), mask(6), mask(7)};
}

inline constexpr std::uint64_t kAll = ~std::uint64_t{0};
inline constexpr std::uint64_t kEachRow = 0x0101'0101'0101'0101;
inline constexpr Masks kRowsFrom = each([](int row) { return kAll << (8 * row); });
inline constexpr Masks kRowsUpTo = each([](int row) { return kAll >> (56 - 8 * row); });
inline constexpr Masks kColumnsFrom =
    each([](int column) { return ((0xffu << column) & 0xffu) * kEachRow; });
inline constexpr Masks kColumnsUpTo =
    each([](int column) { return (0xffu >> (7 - column)) * kEachRow; });

}  // namespace tile_masks

// An unbounded grid that stores one number per occupied cell (the first item of a chain that the
// owner keeps) in tiles of 8 x 8 cells with a bit per cell: asking a box costs one hash look-up per
// tile it overlaps, empty cells nothing. Memory: 256 bytes per 8 x 8 cells that ever
// were occupied in part, which never move, and 64 to 128 for its slot.
class CellTiles {
 public:
  static constexpr std::uint32_t kEmpty = 0xffff'ffff;

  explicit CellTiles(double cell_m);
  CellTiles(const CellTiles& other);
  CellTiles(CellTiles&&) noexcept = default;
  CellTiles& operator=(const CellTiles& other) { return *this = CellTiles(other); }
  CellTiles& operator=(CellTiles&&) noexcept = default;
  ~CellTiles() = default;

  double cell_m() const { return grid_.cell_m(); }
  Cell cell_of(double x, double y) const { return grid_.cell_of(x, y); }

  // Makes `item` the number of its cell and returns the one it replaces, kEmpty if there was none.
  std::uint32_t replace_head(Cell cell, std::uint32_t item);

  // Calls visit(head) for the occupied cells from `low` to `high` (both included) until it returns
  // true; returns whether it did. Row by row of tiles: the order depends on nothing but the cells.
  template <class Visit>
  bool any_of(Cell low, Cell high, const Visit& visit) const {
    using namespace tile_masks;
    if (((low.x ^ high.x) | (low.y ^ high.y)) < 8) {
      return any_in(find(low.x >> 3, low.y >> 3),
                    kRowsFrom[low.y & 7] & kRowsUpTo[high.y & 7] & kColumnsFrom[low.x & 7] &
                        kColumnsUpTo[high.x & 7],
                    visit);
    }
    const std::uint64_t first_columns = kColumnsFrom[low.x & 7];
    const std::uint64_t last_columns = kColumnsUpTo[high.x & 7];
    const std::uint32_t first_x = low.x >> 3;
    const std::uint32_t last_x = high.x >> 3;
    const std::uint32_t last_y = high.y >> 3;
    std::uint64_t rows = kRowsFrom[low.y & 7];
    for (std::uint32_t y = low.y >> 3; y <= last_y; ++y, rows = kAll) {
      if (y == last_y) rows &= kRowsUpTo[high.y & 7];
      std::uint64_t cells = rows & first_columns;
      for (std::uint32_t x = first_x; x <= last_x; ++x, cells = rows) {
        if (x == last_x) cells &= last_columns;
        if (any_in(find(x, y), cells, visit)) return true;
      }
    }
    return false;
  }

 private:
  static constexpr std::uint64_t kNoKey = ~std::uint64_t{0};  // no tile has this one
  using Heads = std::array<std::uint32_t, 64>;
  struct alignas(32) Slot {
    std::uint64_t key = kNoKey;
    std::uint64_t occupied = 0;  // bit 8 * (y mod 8) + (x mod 8)
    Heads* heads = nullptr;      // heads_[tile]
    std::uint64_t tile = 0;
  };

  template <class Visit>
  bool any_in(const Slot& slot, std::uint64_t cells, const Visit& visit) const {
    for (cells &= slot.occupied; cells != 0; cells &= cells - 1) {
      if (visit((*slot.heads)[static_cast<std::size_t>(std::countr_zero(cells))])) return true;
    }
    return false;
  }

  static std::uint32_t bit_of(Cell cell) { return 8 * (cell.y & 7) + (cell.x & 7); }
  static std::uint64_t key_of(std::uint32_t x, std::uint32_t y) {
    return std::uint64_t{x} << 32 | y;
  }
  std::size_t first_slot(std::uint64_t key) const {
    return static_cast<std::size_t>((key * 0x9e37'79b9'7f4a'7c15) >> shift_);
  }
  // The slot of a tile, or one without any cells.
  const Slot& find(std::uint32_t x, std::uint32_t y) const {
    const std::uint64_t key = key_of(x, y);
    const Slot* slot = slots_.data() + first_slot(key);
    while (slot->key != key && slot->key != kNoKey) slot = next(slot);
    return *slot;
  }
  const Slot* next(const Slot* slot) const {
    return slot + 1 == slots_.data() + slots_.size() ? slots_.data() : slot + 1;
  }
  Slot& find_or_make(std::uint32_t x, std::uint32_t y) {
    const Slot& slot = find(x, y);
    if (slot.key == kNoKey) return make(x, y);
    return slots_[static_cast<std::size_t>(&slot - slots_.data())];
  }
  Slot& make(std::uint32_t x, std::uint32_t y);
  void insert(const Slot& slot);

  SquareGrid grid_;
  int shift_;
  std::vector<Slot> slots_;  // a power of two, at most half full; open addressing
  std::deque<Heads> heads_;  // of each tile
};

}  // namespace voronaut
