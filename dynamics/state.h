#pragma once

#include <array>
#include <optional>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "voronaut/dynamics/path.h"

// What a vehicle is, what it is told, and what it does about it. SI units, world frame W (x, y
// horizontal, z up), body frame B (x forward, y left, z up).
namespace voronaut {

using Vec3 = Eigen::Vector3d;

struct VehicleState {
  Vec3 p_world = Vec3::Zero();  // centre of mass [m]; cart: middle of its axle
  Vec3 v_world = Vec3::Zero();  // [m/s]
  Eigen::Quaterniond q_world_body = Eigen::Quaterniond::Identity();  // unit
  Vec3 w_body = Vec3::Zero();                                        // body rates p, q, r [rad/s]
  std::array<double, 4> actuators{};  // speeds [rad/s]; quadrotor: rotors; cart: right, left wheel

  // Horizontal direction in which the body's x axis points: a unit vector, undefined at +-90 deg
  // of pitch (no vehicle here gets there on purpose).
  Eigen::Vector2d heading_world() const;
};

// What navigation asks of the regulator.
struct Setpoint {
  Vec3 p_target_world = Vec3::Zero();  // go there
  double speed_limit_m_s = 0;          // no faster than this
  bool brake_at_target = false;        // the target is the goal: slow down to rest at it
  Eigen::Vector2d heading_world = Eigen::Vector2d::UnitX();  // look there (unit vector)
  double yaw_rate_rad_s = 0;                                 // feedforward for a turning gaze
  // Horizontal velocity to hold until the next setpoint, whatever the target: what the safety
  // governor has proved. Speed limit and braking at the target are its business then.
  std::optional<Eigen::Vector2d> course_m_s = std::nullopt;
  // The piece of path that the target lies on, for a regulator that follows curves; none where the
  // target is all there is, as at the end of a path. Others head for the target.
  std::optional<PathSegment> piece = std::nullopt;
};

// What the regulator asks of the model, held for one vehicle step. The model says what the four
// numbers mean: rotor speeds [rad/s] for the quadrotor; world acceleration x, y, z [m/s^2] and yaw
// rate [rad/s] for the ideal vehicle; voltages [V] of the right and the left motor for the cart.
struct Command {
  std::array<double, 4> u{};
};

}  // namespace voronaut
