#pragma once

#include <array>
#include <optional>
#include <variant>

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
  // Speeds [rad/s]; quadrotor: rotors; cart: right, left wheel. Car: steering angle [rad].
  std::array<double, 4> actuators{};

  // Horizontal direction in which the body's x axis points: a unit vector, undefined at +-90 deg
  // of pitch (no vehicle here gets there on purpose).
  Eigen::Vector2d heading_world() const;
};

// The four ways in which a setpoint asks for motion in the plane.
//
// Through the target and on to what comes after it.
struct PassTarget {
  Eigen::Vector2d p_world = Eigen::Vector2d::Zero();
  double speed_limit_m_s = 0;  // no faster than this; 0: stand
  // The segment of the path that the target lies on, for a regulator that follows curves; none
  // where the target is all there is, as at the end of a path. Others head for the target.
  std::optional<PathSegment> segment = std::nullopt;
};
// To the target, slowing down to rest at it.
struct RestAtTarget {
  Eigen::Vector2d p_world = Eigen::Vector2d::Zero();
  double speed_limit_m_s = 0;
};
// With this velocity until the next setpoint: what the safety governor has proved. Speed limit and
// braking are its business then.
struct VelocityCommand {
  Eigen::Vector2d v_world_m_s = Eigen::Vector2d::Zero();
};

// The same for what drives along its heading: an arc of curvature w / v, a turn on the spot where v
// is 0, backwards where v is negative. Speed limit, braking and heading are the governor's
// business.
struct ArcCommand {
  double v_m_s = 0;    // along the heading
  double w_rad_s = 0;  // yaw rate, positive to the left
};

// What navigation asks of the regulator.
struct Setpoint {
  std::variant<PassTarget, RestAtTarget, VelocityCommand, ArcCommand> motion = PassTarget{};
  double height_m = 0;                                       // of the centre of mass
  Eigen::Vector2d heading_world = Eigen::Vector2d::UnitX();  // look there (unit vector)
  double yaw_rate_rad_s = 0;                                 // feedforward for a turning heading
};

// What the regulator asks of the model, held for one vehicle step. The model says what the four
// numbers mean: rotor speeds [rad/s] for the quadrotor; world acceleration x, y, z [m/s^2] and yaw
// rate [rad/s] for the ideal vehicle; speed [m/s] and yaw rate [rad/s] asked for, for the unicycle;
// acceleration [m/s^2] and steering rate [rad/s] for the car;
// voltages [V] of the right and the left motor for the cart.
struct Command {
  std::array<double, 4> u{};
};

}  // namespace voronaut
