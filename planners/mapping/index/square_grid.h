#pragma once

#include <bit>
#include <cstdint>

namespace voronaut {

// A square cell of the plane. The coordinates are biased, so that they never are negative.
struct Cell {
  std::uint32_t x = 0;
  std::uint32_t y = 0;
  bool operator==(const Cell&) const = default;
};

// Which cell a place lies in.
class SquareGrid {
 public:
  static constexpr double kLargestCellIndex = 1 << 29;
  // A cell may be wider than cell_m by this share, by rounding at the largest index.
  static constexpr double kWidthMargin = 1 + 1e-6;

  explicit constexpr SquareGrid(double cell_m) : cell_m_(cell_m), cells_per_m_(1 / cell_m) {}

  double cell_m() const { return cell_m_; }

  // Cell i lies around i * cell_m. Monotone in both coordinates, which is all that boxes need, for
  // |x|, |y| < kLargestCellIndex cells; any cell for other numbers and NaN.
  Cell cell_of(double x, double y) const { return {index_of(x), index_of(y)}; }

 private:
  // Next to 2^52 a double is an integer, and its low bits are that integer's: one addition rounds,
  // biases by 2^31 and converts.
  std::uint32_t index_of(double coordinate_m) const {
    constexpr double kBias = 0x1p52 + 0x1p31;
    return static_cast<std::uint32_t>(
        std::bit_cast<std::uint64_t>(coordinate_m * cells_per_m_ + kBias));
  }

  double cell_m_;
  double cells_per_m_;
};

}  // namespace voronaut
