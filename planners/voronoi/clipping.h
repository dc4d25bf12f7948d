#pragma once

#include <limits>
#include <optional>
#include <utility>

namespace voronaut {

// For which t the number p + t along lies between lo and hi (Liang and Barsky,
// https://doi.org/10.1145/357332.357333): from first to second, unbounded for along = 0; empty if
// it never does.
inline std::optional<std::pair<double, double>> clipped(double p, double along, double lo,
                                                        double hi) {
  if (along == 0) {
    if (p < lo || p > hi) return std::nullopt;
    return std::pair{-kInfinity, kInfinity};
  }
  const double at_lo = (lo - p) / along;
  const double at_hi = (hi - p) / along;
  return at_lo > at_hi ? std::pair{at_hi, at_lo} : std::pair{at_lo, at_hi};
}

}  // namespace voronaut
