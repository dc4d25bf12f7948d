#include "voronaut/planners/voronoi/boundary_sampling.h"

#include <algorithm>
#include <cmath>

namespace voronaut {
namespace {

constexpr int kHalvings = 6;
// The border crosses the sides of a cell at points at most a diagonal apart; half of that, and the
// last step of the halving, and some.
constexpr double kClearancePerCell = 0.75;

// A point of the border between two neighbours of which one is valid: the last invalid one of the
// halving.
void halve_if_different(bool valid_a, Vec2 a, bool valid_b, Vec2 b,
                        const std::function<bool(const Vec2&)>& is_valid,
                        std::vector<Vec2>& border) {
  if (valid_a == valid_b) return;
  Vec2& valid = valid_a ? a : b;
  Vec2& invalid = valid_a ? b : a;
  for (int k = 0; k < kHalvings; ++k) {
    const Vec2 middle = 0.5 * (valid + invalid);
    (is_valid(middle) ? valid : invalid) = middle;
  }
  border.push_back(invalid);
}

}  // namespace

BoundarySamples sample_boundary(const std::function<bool(const Vec2&)>& is_valid,
                                const Bounds& area, int cells, const std::function<bool()>& stop) {
  BoundarySamples samples;
  const Vec2 size = area.max - area.min;
  const double cell_m = size.maxCoeff() / cells;
  samples.clearance_m = kClearancePerCell * cell_m;
  const int columns = std::max(1, static_cast<int>(std::ceil(size.x() / cell_m)));
  const int rows = std::max(1, static_cast<int>(std::ceil(size.y() / cell_m)));
  const auto node = [&](int i, int j) -> Vec2 {
    return (area.min + cell_m * Vec2(i, j)).cwiseMin(area.max);
  };
  const auto compare = [&](bool valid_a, const Vec2& a, bool valid_b, const Vec2& b) {
    halve_if_different(valid_a, a, valid_b, b, is_valid, samples.points);
  };

  std::vector<char> below, row(columns + 1);
  for (int j = 0; j <= rows; ++j) {
    if (stop()) return samples;
    for (int i = 0; i <= columns; ++i) row[i] = is_valid(node(i, j));
    for (int i = 0; i < columns; ++i) compare(row[i], node(i, j), row[i + 1], node(i + 1, j));
    if (j > 0)
      for (int i = 0; i <= columns; ++i) compare(below[i], node(i, j - 1), row[i], node(i, j));
    below = row;
  }
  samples.complete = true;
  return samples;
}

}  // namespace voronaut
