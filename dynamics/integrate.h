#pragma once

#include <array>
#include <cstddef>

namespace voronaut {

// One step of the classical Runge-Kutta method of order 4 for the autonomous system x' = f(x): the
// state after h. `f` maps an array to an array; inputs held over the step are its captures.
template <std::size_t N, class Derivative>
std::array<double, N> rk4_step(const std::array<double, N>& x, double h, Derivative&& f) {
  using State = std::array<double, N>;
  const auto moved = [&x](double by, const State& slope) {
    State y;
    for (std::size_t i = 0; i < N; ++i) y[i] = x[i] + by * slope[i];
    return y;
  };
  const State k1 = f(x);
  const State k2 = f(moved(0.5 * h, k1));
  const State k3 = f(moved(0.5 * h, k2));
  const State k4 = f(moved(h, k3));
  State next;
  const double sixth = h / 6;
  for (std::size_t i = 0; i < N; ++i) {
    next[i] = x[i] + sixth * ((k1[i] + k4[i]) + 2 * (k2[i] + k3[i]));
  }
  return next;
}

}  // namespace voronaut
