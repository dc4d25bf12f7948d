#include "voronaut/planners/mapping/free_space/star_raster.h"

#include <algorithm>

namespace voronaut {

using row_words::bits_from;
using row_words::bits_up_to;
using row_words::floor_of;
using row_words::word_of;

namespace {

constexpr std::size_t kWordsAtOnce = 1 << 16;  // a megabyte

// Adds what the outline encloses in one column of words to `known`, leaving zeros behind.
void merge(std::uint64_t* __restrict inside, std::uint64_t* __restrict touched,
           std::uint64_t* __restrict carry, std::uint64_t* __restrict known, std::size_t rows) {
  for (std::size_t i = 0; i < rows; ++i) {
    const std::uint64_t within = inside[i] ^ carry[i];
    carry[i] = 0 - (within >> (row_words::kBits - 1));
    known[i] |= within & ~touched[i];
    inside[i] = touched[i] = 0;
  }
}

}  // namespace

void StarRaster::fill(const ScanStar::Outline& star, int columns, int rows, BitTiles& bits) {
  const ScanStar::Box& box = star.box;
  // Places on an edge are rounded: they may leave the box of its ends by one column.
  const int low_column = box.low_column - 1, high_column = box.high_column + 1;
  first_word_ = word_of(std::max(0, low_column));
  words_ = word_of(std::min(columns - 1, high_column)) - first_word_ + 1;
  first_row_ = std::max(0, box.low_row);
  const int end_row = std::min(rows - 1, box.high_row) + 1;
  if (words_ <= 0) return;
  const int rows_at_once =
      static_cast<int>(std::max<std::size_t>(1, kWordsAtOnce / static_cast<std::size_t>(words_)));
  const bool all_inside = low_column >= 0 && box.low_row >= 0 && high_column < columns &&
                          box.high_row < rows && end_row - first_row_ <= rows_at_once;
  for (; first_row_ < end_row; first_row_ += rows_at_once) {
    rows_ = static_cast<std::size_t>(std::min(rows_at_once, end_row - first_row_));
    fill_window(star.corners, all_inside, columns, bits);
  }
}

void StarRaster::fill_window(std::span<const Corner> corners, bool all_inside, int columns,
                             BitTiles& bits) {
  const std::size_t size = rows_ * static_cast<std::size_t>(words_);
  if (inside_.size() < size) {
    inside_.resize(size);
    touched_.resize(size);
  }
  const Corner& first = corners.front();
  touch_clipped(first.row, first.column, first.column);
  if (all_inside) {
    for (std::size_t i = 1; i < corners.size(); ++i) draw_edge(corners[i - 1], corners[i]);
  } else {
    for (std::size_t i = 1; i < corners.size(); ++i) draw_clipped(corners[i - 1], corners[i]);
    end_at_column(columns);
  }
  commit(bits);
}

// Touches a row from where an edge enters it, in the word at index `at`, to a column in another
// word, whose index is returned.
[[gnu::noinline, gnu::cold]] std::size_t StarRaster::touch_words(std::size_t at, int word,
                                                                 int column, std::uint64_t entry) {
  const int last = word_of(column);
  if (word < last) {
    touched_[at] |= entry;
    for (at += rows_; ++word < last; at += rows_) touched_[at] = ~0ULL;
    touched_[at] |= bits_up_to(column);
  } else {
    touched_[at] |= ~(entry << 1);
    for (at -= rows_; --word > last; at -= rows_) touched_[at] = ~0ULL;
    touched_[at] |= bits_from(column);
  }
  return at;
}

inline void StarRaster::touch(int row, int column, int other) {
  const int from = std::min(column, other), to = std::max(column, other);
  const std::size_t at = index(word_of(from), row);
  if (word_of(from) == word_of(to)) {
    touched_[at] |= bits_from(from) & bits_up_to(to);
  } else {
    touch_words(at, word_of(from), to, bits_from(from));
  }
}

// Draws an edge from row to row, all of it in the window.
[[gnu::always_inline]] inline void StarRaster::climb(const Corner& low, const Corner& high) {
  std::uint64_t* const inside = inside_.data();
  std::uint64_t* const touched = touched_.data();
  const double low_x = low.x, low_y = low.y;
  const double slope = (high.x - low_x) / (high.y - low_y);  // columns per row
  const bool rightwards = slope >= 0;
  int word = word_of(low.column);
  std::size_t at = index(word, low.row);
  std::size_t last = at + static_cast<std::size_t>(high.row - low.row);
  std::uint64_t entry = bits_from(low.column);
  double y = low.row;
  while (at != last) {
    y += 1;
    const int column = static_cast<int>(low_x + (y - low_y) * slope);
    const std::uint64_t exit = bits_from(column);
    if (word_of(column) != word) [[unlikely]] {
      const std::size_t there = touch_words(at, word, column, entry);
      last += there - at;
      at = there;
      word = word_of(column);
    } else {
      touched[at] |= rightwards ? entry ^ exit << 1 : exit ^ entry << 1;
    }
    inside[++at] ^= exit;
    entry = exit;
  }
  // Where it ends is given: what was computed before may lie on either side of that.
  const std::uint64_t end = bits_from(high.column);
  if (word_of(high.column) == word) {
    touched[at] |= std::max(entry, end) ^ std::min(entry, end) << 1;
  } else {
    touch_words(at, word, high.column, entry);
  }
}

// The cell of `from` is touched already.
[[gnu::always_inline]] inline void StarRaster::draw_edge(const Corner& from, const Corner& to) {
  if (from.row != to.row) {
    const bool rising = from.row < to.row;
    climb(rising ? from : to, rising ? to : from);
  } else if (from.column != to.column) {  // most edges are shorter than a cell
    touch(from.row, from.column, to.column);
  }
}

// The same, where an edge may leave the window.
void StarRaster::draw_clipped(const Corner& from, const Corner& to) {
  const auto in_window = [this](const Corner& c) {
    return c.row >= first_row_ && c.row < end_row() && c.column > first_column() &&
           c.column < last_column();
  };
  if (in_window(from) && in_window(to)) return draw_edge(from, to);
  const bool rising = from.row <= to.row;
  const Corner &low = rising ? from : to, &high = rising ? to : from;
  if (high.row < first_row_ || low.row >= end_row()) return;
  const double slope = (high.x - low.x) / (high.y - low.y);
  const auto column_at = [&](int y) { return floor_of(low.x + (y - low.y) * slope); };
  const int first = std::max(low.row, first_row_);
  int entry = first == low.row ? low.column : column_at(first);
  for (int row = first; row < std::min(high.row + 1, end_row()); ++row) {
    const int exit = row < high.row ? column_at(row + 1) : high.column;
    if (row > low.row && entry <= last_column()) {
      const int column = std::max(entry, first_column());
      inside_[index(word_of(column), row)] ^= bits_from(column);
    }
    touch_clipped(row, entry, exit);
    entry = exit;
  }
}

void StarRaster::touch_clipped(int row, int column, int other) {
  if (row < first_row_ || row >= end_row()) return;
  const int from = std::max(std::min(column, other), first_column());
  const int to = std::min(std::max(column, other), last_column());
  if (from <= to) touch(row, from, to);
}

// Whatever lies behind the last column counts as touched.
void StarRaster::end_at_column(int columns) {
  const int last = columns - 1;
  if (word_of(last) != first_word_ + words_ - 1) return;
  const std::size_t at = index(word_of(last), first_row_);
  for (std::size_t i = 0; i < rows_; ++i) touched_[at + i] |= ~bits_up_to(last);
}

void StarRaster::commit(BitTiles& bits) {
  for (std::size_t done = 0; done < rows_;) {
    const int row = first_row_ + static_cast<int>(done);
    const auto row_in_tile = static_cast<std::size_t>(row % BitTiles::kSide);
    const std::size_t rows = std::min(rows_ - done, BitTiles::kSide - row_in_tile);
    bits.row_to_write(word_of(row), first_word_, words_, tiles_);
    carry_.assign(rows, 0);
    for (std::size_t w = 0; w < tiles_.size(); ++w) {
      const std::size_t at = w * rows_ + done;
      merge(&inside_[at], &touched_[at], carry_.data(), tiles_[w]->data() + row_in_tile, rows);
    }
    done += rows;
  }
}

}  // namespace voronaut
