#include "voronaut/dynamics/regulators/thrust_vectoring.h"

#include <algorithm>

namespace voronaut {
namespace {

constexpr double kLeastCosine = 0.5;

}  // namespace

Vec3 thrust_axis(const VehicleState& state) {
  const Eigen::Quaterniond& q = state.q_world_body;
  return {2 * (q.x() * q.z() + q.w() * q.y()), 2 * (q.y() * q.z() - q.w() * q.x()),
          1 - 2 * (q.x() * q.x() + q.y() * q.y())};
}

double bounded_cosine(const Vec3& axis_world) { return std::max(axis_world.z(), kLeastCosine); }

double thrust_carrying(double lift, const Vec3& axis_world) {
  if (axis_world.z() >= kLeastCosine) return lift / axis_world.z();
  return lift * std::max(axis_world.z(), 0.0) / (kLeastCosine * kLeastCosine);
}

Eigen::Vector2d desired_acceleration(const Eigen::Vector2d& v_desired, const Eigen::Vector2d& v,
                                     double k_1_s, double max_acceleration_m_s2) {
  const Eigen::Vector2d a = k_1_s * (v_desired - v);
  const double norm = a.norm();
  if (norm <= max_acceleration_m_s2) return a;
  return a * (max_acceleration_m_s2 / norm);
}

Vec3 torque_for(const Vec3& angular_acceleration_rad_s2, const Vec3& w_body,
                const Vec3& inertia_kg_m2) {
  const Vec3 momentum = inertia_kg_m2.cwiseProduct(w_body);
  return inertia_kg_m2.cwiseProduct(angular_acceleration_rad_s2) + w_body.cross(momentum);
}

}  // namespace voronaut
