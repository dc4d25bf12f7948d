#include "voronaut/planners/voronoi/boundary_sampling.h"

#include <algorithm>
#include <cmath>

namespace voronaut {
namespace {

constexpr int kHalvings = 6;
// The border crosses the sides of a cell at points at most a diagonal apart; half of that, and the
// last step of the halving, and some.
constexpr double kClearancePerCell = 0.75;

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
  const auto halve = [&](Vec2 valid, Vec2 invalid) {
    for (int k = 0; k < kHalvings; ++k) {
      const Vec2 middle = 0.5 * (valid + invalid);
      (is_valid(middle) ? valid : invalid) = middle;
    }
    samples.points.push_back(invalid);
  };
  const auto compare = [&](bool valid_a, const Vec2& a, bool valid_b, const Vec2& b) {
    if (valid_a != valid_b) valid_a ? halve(a, b) : halve(b, a);
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
