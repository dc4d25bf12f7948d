// What lqr_gains.py printed solves its Riccati equations, and the sampled loop bears the delay.
#include "voronaut/dynamics/regulators/lqr_gains.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

namespace voronaut::testing {
namespace {

template <int N>
using Square = Eigen::Matrix<double, N, N>;

// x1' = x2, ... xN' = u.
template <int N>
Square<N> chain() {
  Square<N> a = Square<N>::Zero();
  for (int i = 0; i + 1 < N; ++i) a(i, i + 1) = 1;
  return a;
}

template <int N>
struct Matrices {
  explicit Matrices(const lqr_gains::Solution<N>& solution) {
    for (int i = 0; i < N; ++i) {
      q(i, i) = 1 / (solution.state_worth[i] * solution.state_worth[i]);
      k(i) = solution.k[i];
      for (int j = 0; j < N; ++j) p(i, j) = solution.p[i * N + j];
    }
    r = 1 / (solution.input_worth * solution.input_worth);
  }
  Square<N> q = Square<N>::Zero();
  Square<N> p;
  Eigen::Matrix<double, 1, N> k;
  double r;
};

template <int N>
void expect_solved(const lqr_gains::Solution<N>& solution) {
  const Matrices<N> m(solution);
  const Square<N> a = chain<N>();
  const Eigen::Matrix<double, N, 1> pb = m.p.col(N - 1);
  const Square<N> residual = a.transpose() * m.p + m.p * a - pb * pb.transpose() / m.r + m.q;
  EXPECT_LT(residual.cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_LT((m.p - m.p.transpose()).cwiseAbs().maxCoeff(), 1e-11);
  EXPECT_GT(m.p.llt().matrixL().determinant(), 0);
  EXPECT_LT((pb.transpose() / m.r - m.k).cwiseAbs().maxCoeff(), 1e-8 * m.k.maxCoeff());
  // The stabilising solution of the two.
  Square<N> closed = a;
  closed.row(N - 1) -= m.k;
  EXPECT_LT(closed.eigenvalues().real().maxCoeff(), -1);
}

TEST(LqrGains, SolveTheirRiccatiEquations) {
  expect_solved(lqr_gains::kCorrected);
  expect_solved(lqr_gains::kPrinted);
  expect_solved(lqr_gains::kHeight);
  expect_solved(lqr_gains::kYaw);
}

// Spectral radius of a sample of the chain whose input is held, and acts one sample late.
template <int N>
double sampled_radius(const lqr_gains::Solution<N>& solution, double period_s, double factor) {
  // Powers of the chain are finite sums: exp(A T) and its integral, exactly.
  Square<N + 1> power = Square<N + 1>::Identity();
  Square<N + 1> sampled = Square<N + 1>::Identity();
  const Square<N + 1> a = chain<N + 1>();
  for (int n = 1; n <= N; ++n) {
    power = power * a * (period_s / n);
    sampled += power;
  }
  for (int i = 0; i < N; ++i) sampled(N, i) = -factor * solution.k[i];
  sampled(N, N) = 0;  // the input that is pending
  return sampled.eigenvalues().cwiseAbs().maxCoeff();
}

template <int N>
void expect_stable_when_sampled(const lqr_gains::Solution<N>& solution) {
  for (const double period_s : {0.005, 0.01, 0.02}) {
    for (const double factor : {0.6, 1.0, 1.7}) {
      EXPECT_LT(sampled_radius(solution, period_s, factor), 1) << period_s << " x" << factor;
    }
  }
}

TEST(LqrGains, StabiliseTheSampledLoopWithItsDelayAndSomeErrorOfTheGains) {
  expect_stable_when_sampled(lqr_gains::kCorrected);
  expect_stable_when_sampled(lqr_gains::kPrinted);
  expect_stable_when_sampled(lqr_gains::kHeight);
  expect_stable_when_sampled(lqr_gains::kYaw);
}

}  // namespace
}  // namespace voronaut::testing
