// The horizontal loop linearised at hover, sampled: why the literal law cannot fly, and where
// pd_rate puts the poles.
#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

#include <Eigen/Eigenvalues>
#include <gmock/gmock.h>

#include "voronaut/dynamics/regulators/pd_rate.h"
#include "voronaut/tests/dynamics/closed_loop.h"

namespace voronaut::testing {
namespace {

using InertiaSet = QuadrotorConfig::InertiaSet;
using Poles = PdRateConfig::Poles;
using Complex = std::complex<double>;

constexpr double kGravity = 9.81;

PdRateConfig poles_of(Poles poles) {
  PdRateConfig config;
  config.poles = poles;
  return config;
}

// Pitch acceleration per rad/s of demand, at hover.
double kappa(const QuadrotorConfig& c) {
  return 2 * c.thrust_factor_N_s2 * c.arm_m * c.hover_rotor_speed_rad_s() / c.inertia_kg_m2().y();
}

// Eigenvalues of one sample of V' = g theta, theta' = q, q' = kappa u (exact, u held) under
// u = -kp V - kd (V - V_previous)/T - kq q, applied at once or one sample later.
std::vector<Complex> sampled_poles(double kappa, double kp, double kd, double kq, bool delayed) {
  const double t = kPeriod_s;
  Eigen::Matrix<double, 1, 5> law;  // of V, theta, q, previous V, pending u
  law << -kp - kd / t, 0, -kq, kd / t, 0;
  Eigen::Matrix<double, 5, 5> a = Eigen::Matrix<double, 5, 5>::Zero();
  a.row(0) << 1, kGravity * t, kGravity * t * t / 2, 0, 0;
  a.row(1) << 0, 1, t, 0, 0;
  a.row(2) << 0, 0, 1, 0, 0;
  a.row(3) << 1, 0, 0, 0, 0;
  a.row(4) = law;
  Eigen::Matrix<double, 3, 1> input(kGravity * kappa * t * t * t / 6, kappa * t * t / 2, kappa * t);
  Eigen::Matrix<double, 1, 5> applied = law;
  if (delayed) applied << 0, 0, 0, 0, 1;
  a.topRows<3>() += input * applied;
  const Eigen::EigenSolver<Eigen::Matrix<double, 5, 5>> solver(a, false);
  return {solver.eigenvalues().begin(), solver.eigenvalues().end()};
}

double spectral_radius(const std::vector<Complex>& poles) {
  double largest = 0;
  for (const Complex& z : poles) largest = std::max(largest, std::abs(z));
  return largest;
}

TEST(LiteralLaw, IsUnstableForEveryChoiceOfGains) {
  int tried = 0;
  for (const InertiaSet inertia : {InertiaSet::corrected, InertiaSet::printed}) {
    for (const bool delayed : {false, true}) {
      for (int i = 0; i <= 40; ++i) {
        for (int j = 0; j <= 40; ++j) {
          const double kp = std::pow(10.0, -4 + 0.2 * i);
          const double kd = std::pow(10.0, -4 + 0.2 * j);
          const double radius =
              spectral_radius(sampled_poles(kappa(quadrotor_with(inertia)), kp, kd, 0, delayed));
          ASSERT_GT(radius, 1) << "kp " << kp << ", kd " << kd << ", delayed " << delayed;
          ++tried;
        }
      }
    }
  }
  EXPECT_EQ(tried, 4 * 41 * 41);
}

struct GainRow {
  InertiaSet inertia;
  Poles poles;
  double kp, kd, kq, k;
  Complex slow, fast;  // continuous equivalents log(z)/T of the sampled poles
};

const GainRow kGainTable[] = {
    {InertiaSet::corrected, Poles::corrected, 37.435, 20.964, 27.176, 1.786, -2.44, {-9.6, 7.2}},
    {InertiaSet::printed, Poles::printed, 239.58, 149.74, 248.25, 1.600, -2.43, {-8.8, 3.5}},
    {InertiaSet::printed, Poles::printed_soft, 107.81, 86.25, 188.03, 1.250, -1.95, {-6.3, 2.7}},
};

TEST(PdRateGains, AreThoseOfTheTable) {
  for (const GainRow& row : kGainTable) {
    const PdRateGains gains = place_poles(poles_of(row.poles), quadrotor_with(row.inertia));
    EXPECT_NEAR(gains.kp / row.kp, 1, 1e-4);
    EXPECT_NEAR(gains.kd / row.kd, 1, 1e-4);
    EXPECT_NEAR(gains.kq / row.kq, 1, 1e-4);
    EXPECT_NEAR(gains.velocity_gain_1_s(), row.k, 1e-3);
    EXPECT_NEAR(gains.height_kp, 97.93, 0.01);
    EXPECT_NEAR(gains.height_kd, 58.76, 0.01);
    const double heavier = row.inertia == InertiaSet::printed ? 10 : 1;
    EXPECT_NEAR(gains.yaw_k, 17.007 * heavier, 0.01);
    EXPECT_NEAR(gains.yaw_kr, 20.408 * heavier, 0.01);
  }
}

TEST(PdRateGains, ByDefaultFollowTheInertiaSet) {
  for (const GainRow& row : {kGainTable[0], kGainTable[1]}) {
    EXPECT_EQ(place_poles({}, quadrotor_with(row.inertia)).kq,
              place_poles(poles_of(row.poles), quadrotor_with(row.inertia)).kq);
  }
}

TEST(PdRateGains, CustomPolesAreTakenFromTheConfig) {
  PdRateConfig custom = poles_of(Poles::custom);
  custom.velocity_pole_rad_s = 2;
  custom.attitude_pole_rad_s = 6;
  custom.attitude_damping = 0.9;
  const QuadrotorConfig vehicle = quadrotor_with(InertiaSet::printed);
  EXPECT_EQ(place_poles(custom, vehicle).kd,
            place_poles(poles_of(Poles::printed_soft), vehicle).kd);
}

TEST(PdRateGains, PutTheSampledPolesWhereTheTableSays) {
  for (const GainRow& row : kGainTable) {
    const QuadrotorConfig vehicle = quadrotor_with(row.inertia);
    const PdRateGains g = place_poles(poles_of(row.poles), vehicle);
    std::vector<Complex> poles = sampled_poles(kappa(vehicle), g.kp, g.kd, g.kq, true);
    EXPECT_LT(spectral_radius(poles), 1);
    // The three slowest; the others come from the difference and the delay.
    std::sort(poles.begin(), poles.end(),
              [](const Complex& a, const Complex& b) { return std::abs(a) > std::abs(b); });
    const Complex slow = std::log(poles[0]) / kPeriod_s;
    const Complex fast = std::log(poles[1]) / kPeriod_s;
    EXPECT_NEAR(slow.real(), row.slow.real(), 0.006);
    EXPECT_NEAR(slow.imag(), 0, 1e-9);
    EXPECT_NEAR(fast.real(), row.fast.real(), 0.06);
    EXPECT_NEAR(std::abs(fast.imag()), row.fast.imag(), 0.06);
  }
}

// Largest and smallest factor on a gain at which the sampled loop is still stable.
double stability_limit(const GainRow& row, bool all_gains, bool upwards) {
  const QuadrotorConfig vehicle = quadrotor_with(row.inertia);
  const PdRateGains g = place_poles(poles_of(row.poles), vehicle);
  const auto stable = [&](double factor) {
    const double other = all_gains ? factor : 1;
    return spectral_radius(
               sampled_poles(kappa(vehicle), g.kp * other, g.kd * other, g.kq * factor, true)) < 1;
  };
  double good = 1;
  double bad = upwards ? 100 : 0;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (good + bad);
    (stable(middle) ? good : bad) = middle;
  }
  return good;
}

TEST(PdRateGains, LeaveAFactorOfFiveUpAndOfFourDown) {
  const double up[] = {5.387, 5.906, 7.804};
  const double gyro_down[] = {0.2472, 0.2125, 0.1873};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(stability_limit(kGainTable[i], true, true), up[i], 0.001);
    EXPECT_NEAR(stability_limit(kGainTable[i], false, false), gyro_down[i], 0.001);
  }
}

TEST(PdRateGains, AreStableExactlyUpToRouthsBound) {
  // Continuous loop s^3 + kappa kq s^2 + K kd s + K kp.
  const QuadrotorConfig vehicle;
  const double k = kappa(vehicle);
  const PdRateGains g = place_poles({}, vehicle);
  for (const double share : {0.5, 0.99, 1.01, 2.0}) {
    const double kp = share * k * g.kq * g.kd;
    Eigen::Matrix3d companion;
    companion << -k * g.kq, -kGravity * k * g.kd, -kGravity * k * kp, 1, 0, 0, 0, 1, 0;
    const double rightmost =
        Eigen::EigenSolver<Eigen::Matrix3d>(companion, false).eigenvalues().real().maxCoeff();
    EXPECT_EQ(rightmost < 0, share < 1) << share;
  }
}

}  // namespace
}  // namespace voronaut::testing
