#include "voronaut/planners/voronoi/free_places.h"

#include <algorithm>
#include <cmath>

namespace voronaut {
namespace {

class Collector {
 public:
  Collector(std::span<const Vec2> points, const Bounds& area, const Vec2& p, double within_m,
            double clearance_m, double margin_m)
      : area_(area),
        p_(p),
        within_sq_(within_m * within_m),
        clearance_sq_(clearance_m * clearance_m),
        radius_m_(clearance_m + margin_m) {
    const double reach_m = within_m + radius_m_;
    for (const Vec2& q : points)
      if ((q - p).squaredNorm() <= reach_m * reach_m) near_.push_back(q);
  }

  std::vector<Vec2> collect() {
    offer(p_);
    for (std::size_t i = 0; i < near_.size(); ++i) {
      const Vec2 from_point = p_ - near_[i];
      if (from_point.squaredNorm() > 0) offer(near_[i] + radius_m_ * from_point.normalized());
      for (std::size_t k = 0; k < i; ++k) offer_crossings(near_[i], near_[k]);
      offer_border(near_[i]);
    }
    std::stable_sort(found_.begin(), found_.end(), [this](const Vec2& a, const Vec2& b) {
      return (a - p_).squaredNorm() < (b - p_).squaredNorm();
    });
    return found_;
  }

 private:
  void offer(const Vec2& x) {
    if ((x - p_).squaredNorm() > within_sq_ || !area_.contains(x)) return;
    if (std::all_of(near_.begin(), near_.end(),
                    [&](const Vec2& q) { return (q - x).squaredNorm() >= clearance_sq_; }))
      found_.push_back(x);
  }

  void offer_crossings(const Vec2& a, const Vec2& b) {
    const Vec2 half = 0.5 * (b - a);
    const double height_sq = radius_m_ * radius_m_ - half.squaredNorm();
    if (height_sq < 0 || half.squaredNorm() == 0) return;
    const Vec2 aside = std::sqrt(height_sq / half.squaredNorm()) * left_of(half);
    offer(a + half + aside);
    offer(a + half - aside);
  }

  void offer_border(const Vec2& a) {
    for (int axis = 0; axis < 2; ++axis) {
      for (const double side : {area_.min[axis], area_.max[axis]}) {
        const double aside_sq = radius_m_ * radius_m_ - (side - a[axis]) * (side - a[axis]);
        if (aside_sq < 0) continue;
        for (const double sign : {-1.0, 1.0}) {
          Vec2 x = a;
          x[axis] = side;
          x[1 - axis] += sign * std::sqrt(aside_sq);
          offer(x);
        }
      }
    }
  }

  const Bounds& area_;
  Vec2 p_;
  double within_sq_;
  double clearance_sq_;
  double radius_m_;
  std::vector<Vec2> near_;
  std::vector<Vec2> found_;
};

}  // namespace

std::vector<Vec2> closest_free_places(std::span<const Vec2> points, const Bounds& area,
                                      const Vec2& p, double within_m, double clearance_m,
                                      double margin_m) {
  return Collector(points, area, p, within_m, clearance_m, margin_m).collect();
}

}  // namespace voronaut
