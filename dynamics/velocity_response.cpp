#include "voronaut/dynamics/velocity_response.h"

#include <algorithm>
#include <cmath>

namespace voronaut {

namespace {

using Eigen::Vector2d;

// Slow enough for what is left of the way to be v / k.
constexpr double kRest_m_s = 0.05;
constexpr double kRest_m_s2 = 0.1;
constexpr double kRest_m_s3 = 0.5;
constexpr double kHorizon_s = 4;
constexpr double kMinCosTilt = 0.25;

Vector2d shortened(const Vector2d& v, double length) {
  const double square = v.squaredNorm();
  if (square <= length * length) return v;
  return v * (length / std::sqrt(square));
}

// What the regulator asks for in this state: acceleration, or push on the jerk for a vehicle that
// tilts.
Vector2d asked_for(const VelocityResponse& r, const PlanarMotion& m, const Vector2d& v_commanded) {
  const Vector2d a_desired = shortened(r.k_1_s * (v_commanded - m.v_m_s), r.a_max_m_s2);
  if (r.gain_1_s2 == 0) return a_desired;
  // It measures acceleration as the latest difference of velocities, half a step old.
  const Vector2d a_measured = m.a_m_s2 - 0.5 * r.period_s * m.j_m_s3;
  return shortened(r.gain_1_s2 * (a_desired - a_measured) - r.damping_1_s * m.j_m_s3,
                   r.push_max_m_s4);
}

void advance(const VelocityResponse& r, PlanarMotion& m, const Vector2d& push) {
  const double t_s = r.period_s;
  const Vector2d v = m.v_m_s;
  if (r.gain_1_s2 == 0) {
    m.a_m_s2 = push;
    m.v_m_s += t_s * push;
  } else {
    // Tilted, a turn of the thrust changes its horizontal part by 1/cos^2, and the rotors turn
    // faster by 1/sqrt(cos).
    const double tan_sq = m.a_m_s2.squaredNorm() / (r.gravity_m_s2 * r.gravity_m_s2);
    const Vector2d j = m.j_m_s3;
    const Vector2d a = m.a_m_s2;
    m.j_m_s3 += (t_s * (1 + 1.25 * tan_sq)) * push;
    m.a_m_s2 += (0.5 * t_s) * (j + m.j_m_s3);
    m.v_m_s += (0.5 * t_s) * (a + m.a_m_s2);
  }
  m.p_m += (0.5 * t_s) * (v + m.v_m_s);
}

}  // namespace

double VelocityResponse::error_m(const PlanarMotion& now, const Vector2d& v_commanded) const {
  const double speed_m_s = std::max(now.v_m_s.norm(), v_commanded.norm());
  return error_at_rest_m + error_per_speed_s * (speed_m_s + now.a_m_s2.norm() / k_1_s);
}

PlanarMotion VelocityResponse::motion_of(const VehicleState& state) const {
  PlanarMotion m;
  m.p_m = state.p_world.head<2>();
  m.v_m_s = state.v_world.head<2>();
  if (gain_1_s2 == 0) return m;
  // Thrust points along the body's z axis and carries the weight: a = g (r13, r23) / r33.
  const Eigen::Matrix3d r = state.q_world_body.toRotationMatrix();
  const Eigen::Vector3d axis = r.col(2);
  const Eigen::Vector3d turning = r.col(0) * state.w_body.y() - r.col(1) * state.w_body.x();
  const double cosine = std::max(axis.z(), kMinCosTilt);
  m.a_m_s2 = (gravity_m_s2 / cosine) * axis.head<2>();
  m.j_m_s3 = (gravity_m_s2 / (cosine * cosine)) *
             (cosine * turning.head<2>() - turning.z() * axis.head<2>());
  return m;
}

void VelocityResponse::predict_stop(const PlanarMotion& now, const Vector2d& v_before,
                                    const Vector2d& v_commanded, double hold_s, double sample_s,
                                    std::vector<Vector2d>& track) const {
  PlanarMotion m = now;
  track.assign(1, m.p_m);
  const auto hold_steps = std::lround(hold_s / period_s);
  const long sample_steps = std::max(1L, std::lround(sample_s / period_s));
  const auto steps_max = static_cast<long>(kHorizon_s / period_s);
  Vector2d pending = asked_for(*this, m, v_before);
  long step = 0;
  for (; step < steps_max; ++step) {
    const bool braking = step >= hold_steps;
    if (braking && m.v_m_s.squaredNorm() < kRest_m_s * kRest_m_s &&
        m.a_m_s2.squaredNorm() < kRest_m_s2 * kRest_m_s2 &&
        m.j_m_s3.squaredNorm() < kRest_m_s3 * kRest_m_s3)
      break;
    const Vector2d next = asked_for(*this, m, braking ? Vector2d(0, 0) : v_commanded);
    advance(*this, m, pending);
    pending = next;
    if ((step + 1) % sample_steps == 0) track.push_back(m.p_m);
  }
  track.push_back(m.p_m + m.v_m_s / k_1_s);  // the way that is left
}

}  // namespace voronaut
