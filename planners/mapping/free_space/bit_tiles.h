#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "voronaut/planners/mapping/free_space/row_words.h"

namespace voronaut {

// One bit per cell of a lattice without limits, in tiles of 64 x 64 cells, a word a row. A tile is
// made when somebody wants to write to it; what has none reads as zeros. Memory: 512 bytes per tile
// and 16 to 32 for its slot, whatever the extent.
class BitTiles {
 public:
  static constexpr int kSide = row_words::kBits;
  using Tile = std::array<std::uint64_t, kSide>;  // by row; bit i is column i

  // The tile of a row and a column of tiles, zeros if nobody wrote to it. O(1).
  const Tile& at(int row, int column) const {
    const std::uint32_t tile = find(row, column).tile;
    return tile == kNone ? kZeros : tiles_[tile];
  }

  // The columns [from, to] of a row of cells, or of the rows [low_row, high_row].
  void set(int row, int from, int to);
  bool all_set(int row, int from, int to) const {
    const int word = row_words::word_of(from);
    if (word != row_words::word_of(to)) return all_set(row, row, from, to);
    const std::uint64_t wanted = row_words::bits_from(from) & row_words::bits_up_to(to);
    const Tile& tile = at(row_words::word_of(row), word);
    return (wanted & ~tile[static_cast<std::size_t>(row & (kSide - 1))]) == 0;
  }
  bool all_set(int low_row, int high_row, int from, int to) const;

  // Makes those that are missing among the tiles [first, first + count) of a row of tiles and
  // points at all of them; valid until the next call.
  void row_to_write(int row, int first, int count, std::vector<Tile*>& tiles);

  std::size_t set_bits() const;  // O(tiles)

 private:
  static constexpr std::uint32_t kNone = 0xffff'ffff;
  static const Tile kZeros;
  struct Slot {
    std::int32_t row = 0, column = 0;
    std::uint32_t tile = kNone;
  };

  std::size_t first_slot(int row, int column) const {
    const std::uint64_t key =
        std::uint64_t{static_cast<std::uint32_t>(row)} << 32 | static_cast<std::uint32_t>(column);
    return static_cast<std::size_t>((key * 0x9e37'79b9'7f4a'7c15) >> shift_);
  }
  // Its slot, or the free one that would become it.
  const Slot& find(int row, int column) const {
    const Slot* slot = &slots_[first_slot(row, column)];
    while (slot->tile != kNone && (slot->column != column || slot->row != row))
      slot = slot == &slots_.back() ? slots_.data() : slot + 1;
    return *slot;
  }
  Slot& find(int row, int column) {
    return const_cast<Slot&>(std::as_const(*this).find(row, column));
  }
  void make(int row, int column);

  static constexpr int kFirstSlotsLog2 = 5;
  int shift_ = 64 - kFirstSlotsLog2;
  std::vector<Slot> slots_{std::size_t{1} << kFirstSlotsLog2};  // a power of two, half full
  std::vector<Tile> tiles_;
};

}  // namespace voronaut
