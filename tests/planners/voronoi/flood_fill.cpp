#include "voronaut/tests/planners/voronoi/flood_fill.h"

#include <algorithm>
#include <cmath>

namespace voronaut::voronoi_test {
namespace {

constexpr double kCell_m = 0.03;

class Grid {
 public:
  Grid(const PointWorld& world, double clearance_m) : min_(world.bounds.min) {
    const Vec2 size = world.bounds.max - world.bounds.min;
    columns_ = static_cast<int>(std::floor(size.x() / kCell_m)) + 1;
    rows_ = static_cast<int>(std::floor(size.y() / kCell_m)) + 1;
    free_.assign(columns_ * rows_, 1);
    const int reach = static_cast<int>(std::ceil(clearance_m / kCell_m)) + 1;
    for (const Vec2& p : world.points) {
      const int ci = column(p.x()), cj = row(p.y());
      for (int j = std::max(0, cj - reach); j <= std::min(rows_ - 1, cj + reach); ++j)
        for (int i = std::max(0, ci - reach); i <= std::min(columns_ - 1, ci + reach); ++i)
          if ((at(i, j) - p).norm() < clearance_m) free_[j * columns_ + i] = 0;
    }
  }

  bool connects(const Vec2& a, const Vec2& b) {
    std::vector<int> stack{row(a.y()) * columns_ + column(a.x())};
    const int end = row(b.y()) * columns_ + column(b.x());
    if (!free_[stack[0]] || !free_[end]) return false;
    free_[stack[0]] = 0;
    while (!stack.empty()) {
      const int cell = stack.back();
      stack.pop_back();
      if (cell == end) return true;
      for (int dj = -1; dj <= 1; ++dj)
        for (int di = -1; di <= 1; ++di) {
          const int i = cell % columns_ + di, j = cell / columns_ + dj;
          if (i < 0 || j < 0 || i >= columns_ || j >= rows_ || !free_[j * columns_ + i]) continue;
          free_[j * columns_ + i] = 0;
          stack.push_back(j * columns_ + i);
        }
    }
    return false;
  }

 private:
  Vec2 at(int i, int j) const { return min_ + kCell_m * Vec2(i, j); }
  int column(double x) const {
    return std::clamp(static_cast<int>(std::lround((x - min_.x()) / kCell_m)), 0, columns_ - 1);
  }
  int row(double y) const {
    return std::clamp(static_cast<int>(std::lround((y - min_.y()) / kCell_m)), 0, rows_ - 1);
  }

  Vec2 min_;
  int columns_;
  int rows_;
  std::vector<char> free_;
};

}  // namespace

Connected flood_fill(const PointWorld& world, double clearance_m) {
  // A point is at most one half diagonal from the node it is rounded to, and a diagonal step is
  // never farther than that from one of its ends; at the border nodes may be a cell short.
  const double hidden_m = 1.5 * kCell_m;
  if (Grid(world, clearance_m + hidden_m).connects(world.start, world.goal)) return Connected::yes;
  if (!Grid(world, clearance_m - hidden_m).connects(world.start, world.goal)) return Connected::no;
  return Connected::too_close_to_call;
}

}  // namespace voronaut::voronoi_test
