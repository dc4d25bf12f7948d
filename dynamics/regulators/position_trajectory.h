#pragma once

#include <optional>

#include "voronaut/dynamics/limits.h"
#include "voronaut/dynamics/models/cart.h"
#include "voronaut/dynamics/regulator.h"
#include "voronaut/dynamics/regulators/path_form.h"
#include "voronaut/dynamics/speed_profile.h"

namespace voronaut {

class PositionTrajectory;

struct PositionTrajectoryConfig {
  using Law = PositionTrajectory;
  static constexpr const char* kName = "position_trajectory";

  double control_point_ahead_m = 0.15;
  double path_stiffness_1_s2 = 2.25;
  double path_damping_1_s = 3;
  double speed_gain_1_s = 2;
  double point_gain_1_s = 3;
  double approach_share = 0.6;
  double turn_gain_1_s = 1.5;
  double turn_rate_gain_1_s = 6;
  SpeedProfileConfig profile = {.goal_gain_1_s = 0.8};

  template <class Visitor>
  void visit(Visitor& v) {
    v.number("control_point_ahead_m", control_point_ahead_m, 0.01, 10,
             "h: of the axle; arcs must be wider, |curvature| h < 1");
    v.number("path_stiffness_1_s2", path_stiffness_1_s2, 0.01, 1000,
             "T1 of psi'' + T2 psi' + T1 psi = 0, psi the error across the path");
    v.number("path_damping_1_s", path_damping_1_s, 0.01, 50, "T2 of the same");
    v.number("speed_gain_1_s", speed_gain_1_s, 0.01, 50,
             "T3: of the error of speed along the path");
    v.number("point_gain_1_s", point_gain_1_s, 0.01, 50,
             "Of the error of velocity on the way to a point");
    v.number("approach_share", approach_share, 0.01, 1,
             "Share of its speed at which it goes straight at the curve");
    v.number("turn_gain_1_s", turn_gain_1_s, 0.01, 50,
             "On the spot: yaw rate per error of heading");
    v.number("turn_rate_gain_1_s", turn_rate_gain_1_s, 0.01, 50,
             "On the spot: angular acceleration per error of yaw rate");
    profile.visit(v);
  }
};

// The position-trajectory regulator for the cart, after V. Kh. Pshikhopov and M. Yu. Medvedev, whom
// the cart planner paper cites: u = -K^-1 (nonlinear part + reference error dynamics). Their text
// was not at hand; the law is derived anew with the same structure (docs/equations.md). It steers
// the control point P, `control_point_ahead_m` ahead of the axle, whose acceleration is linear in
// the motors' torques with a matrix that is never singular.
//
// - A setpoint with a segment of a path (line or arc) is followed in trajectory mode: with the
// forms of
//   path_form.h,  psi'' + T2 psi' + sat(T1 psi) = 0  and  e' + T3 e = 0  for the speed error e.
//   The axle follows inside of an arc, on the radius sqrt(R^2 - h^2).
// - One without is driven to in position mode. P aims as far beyond the target as it is ahead of
//   the axle, so it is the axle that comes to rest there.
// - An arc commanded is held: v' = clip(point_gain (v_c - v), a), w' = clip(turn_rate_gain (w_c -
// w),
//   a/h), the loop of drive_response.h.
// - What lies behind is turned to on the spot first. Told to stand (speed limit 0), it
//   brakes and turns to the setpoint's heading; under way it looks where it drives.
//
// |P''| is held within the vehicle's acceleration, the voltages within theirs, both scaled together
// so that the curvature stays. Height is not its business. Assumes that what it returns is applied
// one step later.
class PositionTrajectory : public Regulator {
 public:
  // `period_s` is the time between two calls.
  PositionTrajectory(const PositionTrajectoryConfig& config, const CartConfig& vehicle,
                     const MotionLimits& limits, double period_s)
      : config_(config),
        limits_(limits),
        period_s_(period_s),
        cart_(vehicle),
        max_voltage_V_(vehicle.max_voltage_V),
        profile_(config.profile) {}

  void reset(const VehicleState& state) override;
  Command regulate(const Setpoint& setpoint, const VehicleState& state) override;
  StoppingLaw stopping_law() const override;
  MotionResponse motion_response() const override;

 private:
  // The cart as the law sees it.
  struct Motion {
    Eigen::Vector2d ahead, left;  // unit vectors, world axes
    double v_m_s, w_rad_s;
    Eigen::Vector2d p_m, velocity_m_s;  // of the control point
  };
  // What is wanted of it.
  struct Rates {
    double v_dot_m_s2 = 0, w_dot_rad_s2 = 0;
  };

  Motion motion_of(const VehicleState& state) const;
  Eigen::Vector2d beyond(const Eigen::Vector2d& target_world, const Eigen::Vector2d& p_world);
  bool must_turn(const Motion& now, const Eigen::Vector2d& towards);
  Eigen::Vector2d follow(const PathForm& form, const Motion& now, double speed_m_s) const;
  Rates turn_on_the_spot(const Setpoint& setpoint, const Motion& now) const;
  Rates accelerate(Eigen::Vector2d acceleration_m_s2, const Motion& now) const;
  Rates wanted(const Setpoint& setpoint, const VehicleState& state);
  Rates hold(const Eigen::Vector2d& v_world_m_s, const Motion& now);
  Rates hold(const ArcCommand& arc, const Motion& now) const;
  // None where the segment has no direction: at the centre of an arc.
  std::optional<Rates> along(const PathSegment& segment, double speed_m_s, const Motion& now);

  PositionTrajectoryConfig config_;
  MotionLimits limits_;
  double period_s_;
  CartCoefficients cart_;
  double max_voltage_V_;
  SpeedProfile profile_;
  Eigen::Vector2d approach_ = Eigen::Vector2d::UnitX();  // direction from which a point is reached
  bool turning_ = false;
  Rates given_;  // by the command before, which acts now
};

}  // namespace voronaut
