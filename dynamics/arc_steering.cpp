#include "voronaut/dynamics/arc_steering.h"

#include <algorithm>
#include <cmath>

#include "voronaut/dynamics/heading.h"

namespace voronaut {

namespace {

// A point nearer than this does not bend the arc any further, and one farther than this does not
// make it any straighter: the heading is put right within half a second.
constexpr double kNearest_m = 0.1;
constexpr double kFarthest_m = 0.3;
constexpr double kFarthestPerSpeed_s = 0.5;

double fastest_on_m_s(double curvature_1_m, const ArcLimits& limits) {
  const double bend_1_m = std::abs(curvature_1_m);
  double v_m_s = limits.max_speed_m_s / (1 + limits.half_track_m * bend_1_m);
  if (v_m_s * bend_1_m > limits.max_yaw_rate_rad_s) v_m_s = limits.max_yaw_rate_rad_s / bend_1_m;
  if (v_m_s * v_m_s * bend_1_m > limits.max_lateral_m_s2)
    v_m_s = std::sqrt(limits.max_lateral_m_s2 / bend_1_m);
  return v_m_s;
}

}  // namespace

double turn_rate_rad_s(const Eigen::Vector2d& heading, const Eigen::Vector2d& wanted_heading,
                       double feedforward_rad_s, const ArcLimits& limits) {
  const double rate_rad_s =
      limits.turn_gain_1_s * heading_error_rad(heading, wanted_heading) + feedforward_rad_s;
  return std::clamp(rate_rad_s, -limits.max_yaw_rate_rad_s, limits.max_yaw_rate_rad_s);
}

ArcCommand arc_towards(const Eigen::Vector2d& heading, const Eigen::Vector2d& way_m,
                       double speed_m_s, double speed_now_m_s, const ArcLimits& limits) {
  const double distance_m = way_m.norm();
  if (distance_m == 0) return {};
  const Eigen::Vector2d towards = way_m / distance_m;
  ArcCommand arc;
  if (heading.dot(towards) < kArcCosine) {
    arc.w_rad_s = turn_rate_rad_s(heading, towards, 0, limits);
  } else {
    const double sine = heading.x() * towards.y() - heading.y() * towards.x();
    const double reach_m = std::clamp(distance_m, kNearest_m,
                                      kFarthest_m + kFarthestPerSpeed_s * std::max(speed_m_s, 0.0));
    const double curvature_1_m = 2 * sine / reach_m;
    arc.v_m_s = std::min(speed_m_s, fastest_on_m_s(curvature_1_m, limits));
    arc.w_rad_s = arc.v_m_s * curvature_1_m;
  }
  const double fastest_m_s = std::max(arc.v_m_s, std::abs(speed_now_m_s));
  if (fastest_m_s * std::abs(arc.w_rad_s) > limits.max_lateral_m_s2)
    arc.w_rad_s = std::copysign(limits.max_lateral_m_s2 / fastest_m_s, arc.w_rad_s);
  return arc;
}

// Seen from behind a point to the left lies to the right, and a turn to the left is one.
ArcCommand arc_back_towards(const Eigen::Vector2d& heading, const Eigen::Vector2d& way_m,
                            double speed_m_s, double speed_now_m_s, const ArcLimits& limits) {
  const ArcCommand forwards = arc_towards(-heading, way_m, speed_m_s, speed_now_m_s, limits);
  return {-forwards.v_m_s, forwards.w_rad_s};
}

}  // namespace voronaut
