#pragma once

#include <vector>

#include "voronaut/dynamics/state.h"

// How a vehicle's horizontal velocity answers a commanded one, simple enough to be run ahead many
// times a second: what the safety governor predicts with.
namespace voronaut {

// Horizontal motion of the centre of mass, world axes.
struct PlanarMotion {
  Eigen::Vector2d p_m = Eigen::Vector2d::Zero();
  Eigen::Vector2d v_m_s = Eigen::Vector2d::Zero();
  Eigen::Vector2d a_m_s2 = Eigen::Vector2d::Zero();
  Eigen::Vector2d j_m_s3 = Eigen::Vector2d::Zero();
};

// The sampled loop of a regulator and its vehicle, as it acts in the plane. It asks for the
// acceleration a_d = k (v_commanded - v), no longer than a_max. A vehicle without attitude has it
// at once. One that must tilt follows by
//   da/dt = j,  dj/dt = gain (a_d - a) - damping j,
// a third-order loop with the poles of the regulator (docs/vehicles.md). The push may grow with
// tilt, and is limited by the vehicle's rotors. What is asked for acts one step later.
//
// Assumes level flight: height is held, no wind, and a regulator that undoes what turning does to a
// tilted vehicle; what it leaves is part of the error.
struct VelocityResponse {
  double period_s = 0.01;
  double k_1_s = 1.786;
  double a_max_m_s2 = 3;
  double gain_1_s2 = 0;  // 0: acceleration follows at once
  double damping_1_s = 0;
  double push_max_m_s4 = 0;
  // How a push grows with the square of the tilt's tangent, where the regulator lets it.
  double push_growth = 0;
  // How old the acceleration is that the regulator measures; 0: it reads it from the tilt.
  double acceleration_age_s = 0;
  double gravity_m_s2 = 9.81;
  // How far a flown stop may stray from the track predicted for it, held against rollouts of model
  // and regulator: at rest and level, and more with what is under way, see error_m().
  double error_at_rest_m = 0;
  double error_per_speed_s = 0;

  // Periods longer than this stray farther, as far as they are longer: held at twice of it.
  static constexpr double kErrorsHoldUpTo_s = 0.01;
  // Beyond this nothing is promised: dynamics/catalog.h refuses.
  static constexpr double kLongestPeriod_s = 0.02;
  // Grows with the larger of the speeds now and commanded, and with what acceleration adds to it
  // within 1/k.
  double error_m(const PlanarMotion& now, const Eigen::Vector2d& v_commanded) const;

  PlanarMotion motion_of(const VehicleState& state) const;

  // Positions from now until rest, `sample_s` apart, the first and the last included: hold
  // `v_commanded` for hold_s, then brake (command 0). `v_before` was commanded until now. `track`
  // is overwritten; no allocation once it is large enough. O(time to rest / period_s), at most 4 s.
  void predict_stop(const PlanarMotion& now, const Eigen::Vector2d& v_before,
                    const Eigen::Vector2d& v_commanded, double hold_s, double sample_s,
                    std::vector<Eigen::Vector2d>& track) const;
};

}  // namespace voronaut
