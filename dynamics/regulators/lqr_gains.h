#pragma once

// Printed by dynamics/regulators/lqr_gains.py, which says how. Not written by hand.

#include <array>
#include <cstddef>

namespace voronaut::lqr_gains {

// Of a chain of N integrators: what one unit of the cost is worth in each state and in the
// input; the gain K; the cost matrix P, row by row.
template <int N>
struct Solution {
  std::array<double, N> state_worth;
  double input_worth;
  std::array<double, N> k;
  std::array<double, std::size_t{N} * N> p;
};

// clang-format off
// velocity 1 m/s, acceleration 2.5 m/s^2, jerk 25 m/s^3; 200 m/s^4
inline constexpr Solution<3> kCorrected = {
    .state_worth = {1, 2.5, 25},
    .input_worth = 200,
    .k = {200, 115.162305339, 17.1558914277},
    .p = {0.575811526697, 0.0857794571385, 0.005,
          0.0857794571385, 0.0443928001741, 0.00287905763348,
          0.005, 0.00287905763348, 0.000428897285692}};

// velocity 1 m/s, acceleration 2.5 m/s^2, jerk 20 m/s^3; 120 m/s^4
inline constexpr Solution<3> kPrinted = {
    .state_worth = {1, 2.5, 20},
    .input_worth = 120,
    .k = {120, 74.637665775, 13.6115881347},
    .p = {0.621980548125, 0.113429901123, 0.00833333333333,
          0.113429901123, 0.0622178587408, 0.00518317123437,
          0.00833333333333, 0.00518317123437, 0.000945249176024}};

// height 0.5 m, climb 1.35 m/s; 4.5 m/s^2
inline constexpr Solution<2> kHeight = {
    .state_worth = {0.5, 1.35},
    .input_worth = 4.5,
    .k = {9, 5.39547135208},
    .p = {2.39798726759, 0.444444444444,
          0.444444444444, 0.266443029732}};

// heading 0.5 rad, yaw rate 0.67 rad/s; 1.125 rad/s^2
inline constexpr Solution<2> kYaw = {
    .state_worth = {0.5, 0.67},
    .input_worth = 1.125,
    .k = {2.25, 2.7054374594},
    .p = {4.80966659449, 1.77777777778,
          1.77777777778, 2.13762959755}};

// clang-format on

}  // namespace voronaut::lqr_gains
