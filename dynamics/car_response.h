#pragma once

#include <vector>

#include "voronaut/dynamics/state.h"

// How a car answers a commanded arc: drive_response.h for what must steer before it bends.
namespace voronaut {

// Motion in the plane of the middle of the rear axle, world axes.
struct CarMotion {
  Eigen::Vector2d p_m = Eigen::Vector2d::Zero();
  Eigen::Vector2d heading = Eigen::Vector2d::UnitX();  // unit vector
  double v_m_s = 0;                                    // along the heading
  double steering_rad = 0;                             // of the front wheels, positive to the left
};

// The sampled loop of a regulator and its car. It asks for
//   dv/dt = clip(k_v (v_commanded - v), a_max),
//   dsteering/dt = clip(k_s (atan(wheelbase w / v of the command) - steering), rate_max),
// which acts one step later. A command of speed 0 leaves the steering as it is.
struct CarResponse {
  double period_s = 0.01;
  double speed_gain_1_s = 8;  // k_v
  double a_max_m_s2 = 3;
  double steering_gain_1_s = 10;  // k_s
  double steering_rate_max_rad_s = 3.2;
  double steering_max_rad = 0.4189;
  double wheelbase_m = 0.3302;
  // Which arcs may be commanded.
  double max_speed_m_s = 2.5;
  double max_lateral_m_s2 = 1.8;  // |v w|
  // How far a driven stop may stray from the track predicted for it, held against rollouts of model
  // and regulator: at rest, and more with speed.
  double error_at_rest_m = 0;
  double error_per_speed_s = 0;

  double turning_radius_m() const;  // the smallest

  double error_m(const CarMotion& now, const ArcCommand& commanded) const;
  CarMotion motion_of(const VehicleState& state) const;

  // dv/dt [m/s^2] and dsteering/dt [rad/s] asked for.
  struct Rates {
    double v_dot_m_s2 = 0, steering_dot_rad_s = 0;
  };
  Rates rates_asked(const CarMotion& now, const ArcCommand& commanded) const;

  // As DriveResponse::predict_stop.
  void predict_stop(const CarMotion& now, const ArcCommand& before, const ArcCommand& commanded,
                    double hold_s, double sample_s, std::vector<Eigen::Vector2d>& track,
                    std::vector<Eigen::Vector2d>* headings = nullptr) const;
};

// Pure pursuit (arc_steering.h) as tight as the steering allows, forwards: the arc through the
// point that lies `way_m` from here, or as much of it as there is; one at full lock to its side if
// it lies behind. No faster than `speed_m_s` and than its curvature allows.
ArcCommand steered_towards(const CarMotion& now, const Eigen::Vector2d& way_m, double speed_m_s,
                           const CarResponse& response);

}  // namespace voronaut
