#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace voronaut {

// A grey image: rows from the top, columns from the left, values from 0 (black) to `white`.
struct GreyImage {
  int columns = 0;
  int rows = 0;
  int white = 255;  // up to 4 * 65535, for the sum of four channels
  std::vector<std::uint32_t> values;
  std::vector<bool> unknown;  // pixels that say nothing; empty: there are none

  bool is_unknown(int column, int row) const {
    return !unknown.empty() && unknown[index(column, row)];
  }

  int value(int column, int row) const { return static_cast<int>(values[index(column, row)]); }
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(column);
  }
};

// A PGM image, plain (P2) or raw (P5), with comments; https://netpbm.sourceforge.net/doc/pgm.html.
// Throws ConfigError, also where more
// than the end of a line is left over; in raw data there are no lines to name.
GreyImage parse_pgm(std::string_view bytes, const std::string& file);

}  // namespace voronaut
