#pragma once

#include <cstdint>

// Rows of cells as bits of 64-bit words: cell `column` is bit column mod 64 of word column / 64.
namespace voronaut::row_words {

inline constexpr int kBitsLog2 = 6;
inline constexpr int kBits = 1 << kBitsLog2;

inline int word_of(int column) { return column >> kBitsLog2; }
// Of the word of `column`: the cells from it on, and those up to it, both with it.
inline std::uint64_t bits_from(int column) { return ~0ULL << (column & (kBits - 1)); }
inline std::uint64_t bits_up_to(int column) {
  return ~0ULL >> (kBits - 1 - (column & (kBits - 1)));
}

// std::floor() is a call without SSE4.1.
inline int floor_of(double x) {
  const int truncated = static_cast<int>(x);
  return truncated - (x < truncated ? 1 : 0);
}
inline int ceil_of(double x) { return -floor_of(-x); }

}  // namespace voronaut::row_words
