#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "voronaut/planners/mapping/cell_tiles.h"

namespace voronaut {

// Which cells have an occupied one within kNearCells, in both directions. One look-up without
// search: tiles that share a word share its bits, so that a cell may be taken for marked, never for
// unmarked. Memory: 8 bytes a word; the owner asks for more words as tiles become occupied.
class NearFilter {
 public:
  static constexpr std::uint32_t kNearCells = 2;

  bool may_be_near(Cell cell) const {
    return (words_[word_of(cell.x >> 3, cell.y >> 3)] >> (8 * (cell.y & 7) + (cell.x & 7)) & 1) !=
           0;
  }

  void mark_around(Cell occupied);

  std::size_t words() const { return words_.size(); }
  // Twice the words, none marked.
  void start_over_larger() {
    words_.assign(2 * words_.size(), 0);
    --shift_;
  }

 private:
  static constexpr int kFirstWordsLog2 = 11;

  std::size_t word_of(std::uint32_t tile_x, std::uint32_t tile_y) const {
    return (tile_x * 0x9e37'79b1U + tile_y * 0x85eb'ca77U) >> shift_;
  }

  int shift_ = 32 - kFirstWordsLog2;
  std::vector<std::uint64_t> words_ = std::vector<std::uint64_t>(std::size_t{1} << kFirstWordsLog2);
};

}  // namespace voronaut
