#include "voronaut/planners/mapping/free_space/bit_tiles.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace voronaut {

using row_words::word_of;

const BitTiles::Tile BitTiles::kZeros{};

void BitTiles::set(int row, int from, int to) {
  std::vector<Tile*> tiles;
  row_to_write(word_of(row), word_of(from), word_of(to) - word_of(from) + 1, tiles);
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    std::uint64_t bits = ~0ULL;
    if (i == 0) bits &= row_words::bits_from(from);
    if (i + 1 == tiles.size()) bits &= row_words::bits_up_to(to);
    (*tiles[i])[static_cast<std::size_t>(row & (kSide - 1))] |= bits;
  }
}

bool BitTiles::all_set(int low_row, int high_row, int from, int to) const {
  const int last = word_of(to);
  std::uint64_t wanted = row_words::bits_from(from);
  for (int word = word_of(from); word <= last; ++word, wanted = ~0ULL) {
    if (word == last) wanted &= row_words::bits_up_to(to);
    for (int row = low_row; row <= high_row;) {
      const std::uint64_t* const rows = at(word_of(row), word).data();
      const int end = std::min(high_row, row | (kSide - 1)) + 1;
      std::uint64_t bits = wanted;
      for (; row < end; ++row) bits &= rows[row & (kSide - 1)];
      if (bits != wanted) return false;
    }
  }
  return true;
}

void BitTiles::row_to_write(int row, int first, int count, std::vector<Tile*>& tiles) {
  for (int i = 0; i < count; ++i) {
    if (find(row, first + i).tile == kNone) make(row, first + i);
  }
  tiles.resize(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
    tiles[static_cast<std::size_t>(i)] = &tiles_[find(row, first + i).tile];
}

void BitTiles::make(int row, int column) {
  if (2 * (tiles_.size() + 1) > slots_.size()) {
    const std::vector<Slot> smaller = std::exchange(slots_, std::vector<Slot>(2 * slots_.size()));
    --shift_;
    for (const Slot& slot : smaller) {
      if (slot.tile != kNone) find(slot.row, slot.column) = slot;
    }
  }
  find(row, column) = {row, column, static_cast<std::uint32_t>(tiles_.size())};
  tiles_.emplace_back();
}

std::size_t BitTiles::set_bits() const {
  std::size_t count = 0;
  for (const Tile& tile : tiles_) {
    for (const std::uint64_t word : tile) count += static_cast<std::size_t>(std::popcount(word));
  }
  return count;
}

}  // namespace voronaut
