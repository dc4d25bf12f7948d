#include "voronaut/dynamics/speed_profile.h"

#include <algorithm>
#include <cmath>

#include <sleef.h>

namespace voronaut {

using Kind = SpeedProfileConfig::Kind;

SpeedProfile::SpeedProfile(const SpeedProfileConfig& config)
    : config_(config), at_target_(logistic(0, config.half_speed_distance_m)) {}

double SpeedProfile::logistic(double distance_m, double center_m) const {
  return 1 / (1 + Sleef_cinz_expd1_u10purec(-config_.slope_1_m * (distance_m - center_m)));
}

double SpeedProfile::speed_m_s(double distance_m, double max_speed_m_s) const {
  switch (config_.kind) {
    case Kind::sqrt: {
      const double a = config_.deceleration_m_s2;
      const double k = config_.goal_gain_1_s;
      const double knee_m = a / (k * k);
      return std::min(max_speed_m_s, distance_m < knee_m
                                         ? k * distance_m
                                         : std::sqrt(2 * a * (distance_m - 0.5 * knee_m)));
    }
    case Kind::paper:
      return max_speed_m_s * (logistic(distance_m, config_.half_speed_distance_m) - at_target_) /
             (1 - at_target_);
    case Kind::logistic:
      return max_speed_m_s * logistic(distance_m, config_.half_speed_distance_m);
    case Kind::literal:
      return max_speed_m_s * logistic(distance_m, 0);
  }
  return 0;
}

Eigen::Vector2d SpeedProfile::velocity_m_s(const Eigen::Vector2d& to_target_m,
                                           double max_speed_m_s) const {
  const double distance_m = to_target_m.norm();
  if (distance_m == 0) return Eigen::Vector2d::Zero();
  const Eigen::Vector2d direction = to_target_m / distance_m;
  if (config_.kind != Kind::literal) return speed_m_s(distance_m, max_speed_m_s) * direction;
  return {speed_m_s(std::abs(to_target_m.x()), max_speed_m_s) * direction.x(),
          speed_m_s(std::abs(to_target_m.y()), max_speed_m_s) * direction.y()};
}

}  // namespace voronaut
