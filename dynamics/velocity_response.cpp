#include "voronaut/dynamics/velocity_response.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace voronaut {

namespace {

using Eigen::Vector2d;

// Below these, and with nothing limited, the loop is linear: what is left of the way follows from
// the state.
constexpr double kLinear_m_s2 = 2;
constexpr double kStraightWay_m = 0.002;
constexpr double kHorizon_s = 4;
constexpr double kMinThrustCosine = 0.25;

Vector2d shortened(const Vector2d& v, double length) {
  const double square = v.squaredNorm();
  if (square <= length * length) return v;
  return v * (length / std::sqrt(square));
}

// What the regulator asks for in this state: acceleration, or push on the jerk for a vehicle that
// tilts.
[[gnu::always_inline]] inline Vector2d asked_for(const VelocityResponse& r, const PlanarMotion& m,
                                                 const Vector2d& v_commanded) {
  const Vector2d a_desired = shortened(r.k_1_s * (v_commanded - m.v_m_s), r.a_max_m_s2);
  if (r.gain_1_s2 == 0) return a_desired;
  const Vector2d a_measured = m.a_m_s2 - r.acceleration_age_s * m.j_m_s3;
  return shortened(r.gain_1_s2 * (a_desired - a_measured) - r.damping_1_s * m.j_m_s3,
                   r.push_max_m_s4);
}

[[gnu::always_inline]] inline void advance(const VelocityResponse& r, PlanarMotion& m,
                                           const Vector2d& push) {
  const double t_s = r.period_s;
  const Vector2d v = m.v_m_s;
  if (r.gain_1_s2 == 0) {
    m.a_m_s2 = push;
    m.v_m_s += t_s * push;
  } else {
    const double tan_sq = m.a_m_s2.squaredNorm() / (r.gravity_m_s2 * r.gravity_m_s2);
    const Vector2d j = m.j_m_s3;
    const Vector2d a = m.a_m_s2;
    m.j_m_s3 += (t_s * (1 + r.push_growth * tan_sq)) * push;
    m.a_m_s2 += (0.5 * t_s) * (j + m.j_m_s3);
    m.v_m_s += (0.5 * t_s) * (a + m.a_m_s2);
  }
  m.p_m += (0.5 * t_s) * (v + m.v_m_s);
}

// What is left of the way to rest while braking, if it is a straight line from here. The linear
// loop, integrated from now to the end: v, a and j vanish there, and each step acts on what was
// measured a step before.
std::optional<Vector2d> straight_way_left_m(const VelocityResponse& r, const PlanarMotion& m) {
  const double limit_m_s2 = std::min(kLinear_m_s2, 0.9 * r.a_max_m_s2);
  if (r.k_1_s * r.k_1_s * m.v_m_s.squaredNorm() > limit_m_s2 * limit_m_s2) return std::nullopt;
  if (r.gain_1_s2 == 0) return Vector2d((1 / r.k_1_s - r.period_s) * m.v_m_s);
  if (m.a_m_s2.norm() > limit_m_s2) return std::nullopt;
  if (asked_for(r, m, Vector2d(0, 0)).norm() > 0.9 * r.push_max_m_s4) return std::nullopt;
  const double t_s = r.period_s;
  const Vector2d v_before = m.v_m_s - t_s * m.a_m_s2;
  const Vector2d a_before = m.a_m_s2 - t_s * m.j_m_s3;
  const Vector2d way_m = (m.j_m_s3 + r.gain_1_s2 * v_before +
                          (r.damping_1_s - r.gain_1_s2 * r.acceleration_age_s) * a_before) /
                             (r.gain_1_s2 * r.k_1_s) -
                         (0.5 * t_s) * (m.v_m_s + v_before);
  const double speed_m_s = m.v_m_s.norm();
  const double aside_m =
      speed_m_s > 0 ? std::abs(m.v_m_s.x() * way_m.y() - m.v_m_s.y() * way_m.x()) / speed_m_s
                    : way_m.norm();
  if (aside_m > kStraightWay_m || way_m.dot(m.v_m_s) < 0) return std::nullopt;
  return way_m;
}

}  // namespace

double VelocityResponse::error_m(const PlanarMotion& now, const Vector2d& v_commanded) const {
  const double speed_m_s = std::max(now.v_m_s.norm(), v_commanded.norm());
  const double slower = std::max(1.0, period_s / kErrorsHoldUpTo_s);
  return slower * (error_at_rest_m + error_per_speed_s * (speed_m_s + now.a_m_s2.norm() / k_1_s));
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
  const double cosine = std::max(axis.z(), kMinThrustCosine);
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
  Vector2d way_left_m(0, 0);
  for (long step = 0; step < steps_max; ++step) {
    const bool braking = step > hold_steps;
    if (braking) {
      if (const auto left_m = straight_way_left_m(*this, m)) {
        way_left_m = *left_m;
        break;
      }
    }
    const Vector2d next = asked_for(*this, m, step >= hold_steps ? Vector2d(0, 0) : v_commanded);
    advance(*this, m, pending);
    pending = next;
    if ((step + 1) % sample_steps == 0) track.push_back(m.p_m);
  }
  track.push_back(m.p_m);
  track.push_back(m.p_m + way_left_m);
}

}  // namespace voronaut
