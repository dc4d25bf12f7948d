#include "voronaut/dynamics/regulators/rotor_allocation.h"

#include <algorithm>
#include <cmath>

namespace voronaut {
namespace {

// Of what hovering leaves to the nearer limit: kept from thrust for torque.
constexpr double kTorqueReserve = 0.25;
// Of the square of the hover speed. The rotors' drag turns the body weakly: who gave yaw all that
// it asks for would have nothing left to tilt with.
constexpr double kYawShare = 0.3;

}  // namespace

RotorAllocation::RotorAllocation(const QuadrotorConfig& vehicle)
    : square_per_thrust_(1 / (4 * vehicle.thrust_factor_N_s2)),
      square_per_tilt_torque_(1 / (2 * vehicle.thrust_factor_N_s2 * vehicle.arm_m)),
      square_per_yaw_torque_(vehicle.drag_factor_N_m_s2 > 0 ? 1 / (4 * vehicle.drag_factor_N_m_s2)
                                                            : 0),
      min_square_(vehicle.min_rotor_speed_rad_s * vehicle.min_rotor_speed_rad_s),
      max_square_(vehicle.max_rotor_speed_rad_s * vehicle.max_rotor_speed_rad_s),
      hover_square_(vehicle.mass_kg * vehicle.gravity_m_s2 * square_per_thrust_) {}

double RotorAllocation::max_tilt_torque_N_m() const {
  return std::min(max_square_ - hover_square_, hover_square_ - min_square_) /
         square_per_tilt_torque_;
}

Command RotorAllocation::speeds(const Wrench& wrench) const {
  const double reserve =
      kTorqueReserve * std::min(max_square_ - hover_square_, hover_square_ - min_square_);
  const double mean = std::clamp(square_per_thrust_ * wrench.thrust_N, min_square_ + reserve,
                                 max_square_ - reserve);
  const double room = std::min(max_square_ - mean, mean - min_square_);

  Eigen::Vector2d tilt = square_per_tilt_torque_ * wrench.torque_N_m.head<2>();
  const double asked = tilt.norm();
  if (asked > room) tilt *= room / asked;
  const double yaw_room = std::max(0.0, std::min(kYawShare * hover_square_, room - asked));
  const double yaw =
      std::clamp(square_per_yaw_torque_ * wrench.torque_N_m.z(), -yaw_room, yaw_room);

  // Rounding may leave what is nothing a hair below zero.
  const auto speed = [](double square) { return std::sqrt(std::max(square, 0.0)); };
  return {{speed(mean - tilt.y() - yaw), speed(mean - tilt.x() + yaw), speed(mean + tilt.y() - yaw),
           speed(mean + tilt.x() + yaw)}};
}

}  // namespace voronaut
