#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "voronaut/planners/mapping/free_space/bit_tiles.h"
#include "voronaut/planners/mapping/free_space/row_words.h"
#include "voronaut/planners/mapping/free_space/scan_star.h"

namespace voronaut {

// Sets the bits of the cells that lie wholly within a star: those whose row its outline has entered
// and not left again, and that the outline does not run through.
class StarRaster {
 public:
  // Cells from (0, 0) to (columns - 1, rows - 1) are set, no others. O(corners + rows that edges
  // cross + words of the box around the star); no allocation in steady state.
  void fill(const ScanStar::Outline& star, int columns, int rows, BitTiles& bits);

 private:
  using Corner = ScanStar::Corner;

  void fill_window(std::span<const Corner> corners, bool all_inside, int columns, BitTiles& bits);
  void draw_edge(const Corner& from, const Corner& to);
  void draw_clipped(const Corner& from, const Corner& to);
  void climb(const Corner& low, const Corner& high);
  void touch(int row, int column, int other);
  void touch_clipped(int row, int column, int other);
  std::size_t touch_words(std::size_t at, int word, int column, std::uint64_t entry);
  void end_at_column(int columns);
  void commit(BitTiles& bits);

  int end_row() const { return first_row_ + static_cast<int>(rows_); }
  int first_column() const { return first_word_ * row_words::kBits; }
  int last_column() const { return (first_word_ + words_) * row_words::kBits - 1; }
  std::size_t index(int word, int row) const {
    return static_cast<std::size_t>(word - first_word_) * rows_ +
           static_cast<std::size_t>(row - first_row_);
  }

  // The window: whole words of cells, one column of words after the other.
  int first_row_ = 0, first_word_ = 0;
  int words_ = 0;
  std::size_t rows_ = 0;
  // Both all zeros between two stars. `inside` is flipped from where an edge comes into a row from
  // below up to the end of the word; `touched` are the cells that the outline runs through.
  std::vector<std::uint64_t> inside_, touched_;
  std::vector<std::uint64_t> carry_;    // scratch, by row: all ones while inside
  std::vector<BitTiles::Tile*> tiles_;  // scratch
};

}  // namespace voronaut
