#pragma once

#include <vector>

#include "voronaut/dynamics/arc_steering.h"
#include "voronaut/dynamics/state.h"

// How what drives along its heading answers a commanded arc: the counterpart of
// velocity_response.h, for what the safety governor predicts on wheels.
namespace voronaut {

// Motion in the plane of what drives along its heading, world axes.
struct DriveMotion {
  Eigen::Vector2d p_m = Eigen::Vector2d::Zero();
  Eigen::Vector2d heading = Eigen::Vector2d::UnitX();  // unit vector
  double v_m_s = 0;                                    // along the heading
  double w_rad_s = 0;
};

// The sampled loop of a regulator and its vehicle. It asks for
//   dv/dt = clip(k_v (v_commanded - v), a_max),  dw/dt = clip(k_w (w_commanded - w), alpha_max),
// which acts one step later; the vehicle has these rates at once, and does not slip.
struct DriveResponse {
  double period_s = 0.01;
  double speed_gain_1_s = 8;  // k_v
  double a_max_m_s2 = 3;
  double yaw_rate_gain_1_s = 10;  // k_w
  double alpha_max_rad_s2 = 10;
  // Arcs outside of these are not answered as above.
  ArcLimits limits;
  // How far a flown stop may stray from the track predicted for it, held against rollouts of model
  // and regulator: at rest, and more with speed.
  double error_at_rest_m = 0;
  double error_per_speed_s = 0;

  // Grows with the larger of the speeds now and commanded, either way.
  double error_m(const DriveMotion& now, const ArcCommand& commanded) const;

  DriveMotion motion_of(const VehicleState& state) const;

  // Positions from now until rest, `sample_s` apart and closer where it bends: hold
  // `commanded` for hold_s, then brake (command 0, 0). `before` was commanded until now. `track` is
  // overwritten; no allocation once it is large enough. O(time to rest / period_s), at most 4 s.
  // `headings`, if asked for: the body's at each of them (unit vectors), until it has turned as far
  // as it will.
  void predict_stop(const DriveMotion& now, const ArcCommand& before, const ArcCommand& commanded,
                    double hold_s, double sample_s, std::vector<Eigen::Vector2d>& track,
                    std::vector<Eigen::Vector2d>* headings = nullptr) const;
};

}  // namespace voronaut
