#pragma once

#include <Eigen/Core>

#include "voronaut/dynamics/state.h"

// From where something lies to the arc that leads there, for what drives along its heading.
namespace voronaut {

// Which arcs may be commanded, and how a heading is turned to.
struct ArcLimits {
  double max_speed_m_s = 2.5;  // of the faster wheel: |v| + half_track |w|
  double max_yaw_rate_rad_s = 2;
  double max_lateral_m_s2 = 1.8;  // |v w|
  double half_track_m = 0;        // 0: speed and yaw rate do not compete
  double turn_gain_1_s = 2.5;     // yaw rate per error of heading, on the spot
};

// Ahead of this cosine of the error of heading (50 deg) it drives an arc, else it turns first.
inline constexpr double kArcCosine = 0.64;

// Yaw rate [rad/s] of a turn on the spot towards a heading (unit vectors), plus a feedforward.
double turn_rate_rad_s(const Eigen::Vector2d& heading, const Eigen::Vector2d& wanted_heading,
                       double feedforward_rad_s, const ArcLimits& limits);

// Pure pursuit: the arc from here, tangential to `heading` (unit vector), through the point that
// lies `way_m` from here (or through one in the same direction, if that is far), no faster than
// `speed_m_s` and than its curvature allows; a turn on the spot where the point lies aside or
// behind. `speed_now_m_s`: yaw rate builds up sooner than speed goes down, so it is kept to what
// that speed allows. Source: R. C. Coulter, Implementation of the pure pursuit path tracking
// algorithm, CMU-RI-TR-92-01 (curvature 2 y / L^2).
ArcCommand arc_towards(const Eigen::Vector2d& heading, const Eigen::Vector2d& way_m,
                       double speed_m_s, double speed_now_m_s, const ArcLimits& limits);

// The same backwards: away from where it looks, to a point behind.
ArcCommand arc_back_towards(const Eigen::Vector2d& heading, const Eigen::Vector2d& way_m,
                            double speed_m_s, double speed_now_m_s, const ArcLimits& limits);

}  // namespace voronaut
