#pragma once

#include "voronaut/dynamics/models/quadrotor.h"

// What the regulators have in common that fly the quadrotor by thrust and torque.
namespace voronaut {

// The body's z axis, along which it thrusts: world axes.
Vec3 thrust_axis(const VehicleState& state);

// Cosine of its tilt, no less than 0.5: what is tilted more is flown as if it were by 60 deg.
double bounded_cosine(const Vec3& axis_world);

// Thrust whose vertical part is `lift`, as far as 60 deg of tilt; from there on less, none where
// the axis points down: whoever lies on the side wants room for torque, not to be thrust farther
// off.
double thrust_carrying(double lift, const Vec3& axis_world);

// k (v_desired - v) in the plane, no longer than the limit.
Eigen::Vector2d desired_acceleration(const Eigen::Vector2d& v_desired, const Eigen::Vector2d& v,
                                     double k_1_s, double max_acceleration_m_s2);

// Torque that gives the body this angular acceleration (body axes) whatever its inertia does:
// I a + w x I w.
Vec3 torque_for(const Vec3& angular_acceleration_rad_s2, const Vec3& w_body,
                const Vec3& inertia_kg_m2);

// What turning asks for besides: a tilt rate (p, q) that is straight in the world turns by
// r (q, -p) in the axes of a body that yaws.
inline Vec3 straight_tilt(const Vec3& w_body) {
  return {w_body.z() * w_body.y(), -w_body.z() * w_body.x(), 0};
}

}  // namespace voronaut
