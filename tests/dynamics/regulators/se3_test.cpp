// The law against the equations as Lee, Leok and McClamroch print them, in their frame.
#include "voronaut/dynamics/regulators/se3.h"

#include <random>

#include <gtest/gtest.h>

#include "voronaut/tests/dynamics/closed_loop.h"
#include "voronaut/tests/dynamics/models/rotor_wrench.h"

namespace voronaut::testing {
namespace {

using Eigen::Matrix3d;

// From our axes (x, y left, z up) to theirs (y right, z down) and back, in world and body alike.
const Matrix3d kTurned = Vec3(1, -1, -1).asDiagonal();

Vec3 vee(const Matrix3d& m) { return {m(2, 1), m(0, 2), m(1, 0)}; }

// Their f and M for a desired velocity, in their frame; k_x = 0, Wd = 0.
Wrench printed_law(const Matrix3d& r, const Vec3& v, const Vec3& w, const Vec3& v_desired,
                   const Vec3& k_v, const Vec3& b1d, const Vec3& k_r, const Vec3& k_w,
                   const Vec3& j, double m_kg) {
  const Vec3 e3 = Vec3::UnitZ();
  const Vec3 minus_a = k_v.cwiseProduct(v - v_desired) + m_kg * 9.81 * e3;
  const Vec3 b3d = minus_a.normalized();
  const Vec3 b2d = b3d.cross(b1d).normalized();
  Matrix3d rd;
  rd << b2d.cross(b3d), b2d, b3d;
  const Vec3 e_r = 0.5 * vee(rd.transpose() * r - r.transpose() * rd);
  return {minus_a.dot(r * e3),
          -k_r.cwiseProduct(e_r) - k_w.cwiseProduct(w) + w.cross(j.cwiseProduct(w))};
}

TEST(Se3, IsThePrintedLawWhereNoYawIsAskedFor) {
  const QuadrotorConfig vehicle;
  const Se3Config config;
  const MotionLimits unlimited{
      .max_speed_m_s = 100, .max_acceleration_m_s2 = 1000, .max_tilt_rad = 1.2};
  Se3 regulator(config, vehicle, unlimited, kPeriod_s);
  const Vec3 j = vehicle.inertia_kg_m2();
  const double pole = config.attitude_pole_rad_s;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(-1, 1);
  for (int i = 0; i < 500; ++i) {
    VehicleState state;
    state.p_world = {0, 0, 1};
    state.v_world = 0.5 * Vec3(any(random), any(random), any(random));
    // No turning: then what is this project's vanishes.
    state.w_body = Vec3(any(random), any(random), 0);
    state.q_world_body =
        Eigen::Quaterniond(1, 0.1 * any(random), 0.1 * any(random), any(random)).normalized();
    const Eigen::Vector2d v_desired(any(random), any(random));
    const Eigen::Vector2d ahead = state.heading_world();
    Setpoint setpoint{.motion = VelocityCommand{v_desired}, .height_m = 1, .heading_world = ahead};
    const Wrench given = wrench_of(vehicle, regulator.regulate(setpoint, state));

    const Matrix3d r = kTurned * state.q_world_body.toRotationMatrix() * kTurned;
    const Wrench printed =
        printed_law(r, kTurned * state.v_world, kTurned * state.w_body,
                    kTurned * Vec3(v_desired.x(), v_desired.y(), 0),
                    vehicle.mass_kg * Vec3(config.velocity_gain_1_s, config.velocity_gain_1_s,
                                           config.climb_gain_1_s),
                    kTurned * Vec3(ahead.x(), ahead.y(), 0), pole * pole * Vec3(j.x(), j.y(), 0),
                    2 * config.attitude_damping * pole * Vec3(j.x(), j.y(), 0), j, vehicle.mass_kg);
    EXPECT_NEAR(given.thrust_N, printed.thrust_N, 1e-10) << i;
    EXPECT_LT((given.torque_N_m - kTurned * printed.torque_N_m).norm(), 1e-10) << i;
  }
}

}  // namespace
}  // namespace voronaut::testing
