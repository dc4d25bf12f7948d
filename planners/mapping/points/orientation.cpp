#include "voronaut/planners/mapping/points/orientation.h"

#include <array>
#include <cstddef>

namespace voronaut {
namespace {

// A sum of doubles without rounding: components that do not overlap, smallest first (Shewchuk,
// grow-expansion, theorem 10).
class ExactSum {
 public:
  void add(double value) {
    for (std::size_t i = 0; i < size_; ++i) {
      const double sum = value + component_[i];
      const double from_component = sum - value;
      const double from_value = sum - from_component;
      component_[i] = (value - from_value) + (component_[i] - from_component);
      value = sum;
    }
    component_[size_++] = value;
  }

  void add_product(double a, double b) {
    const double product = a * b;
    add(std::fma(a, b, -product));
    add(product);
  }

  double sign() const {
    for (std::size_t i = size_; i-- > 0;) {
      if (component_[i] != 0) return component_[i] > 0 ? 1 : -1;
    }
    return 0;
  }

 private:
  std::array<double, 12> component_{};
  std::size_t size_ = 0;
};

}  // namespace

double orientation_exact(const Vec2& a, const Vec2& b, const Vec2& c) {
  ExactSum turn;
  turn.add_product(a.x(), b.y());
  turn.add_product(b.x(), c.y());
  turn.add_product(c.x(), a.y());
  turn.add_product(-a.y(), b.x());
  turn.add_product(-b.y(), c.x());
  turn.add_product(-c.y(), a.x());
  return turn.sign();
}

}  // namespace voronaut
