#pragma once

#include "voronaut/dynamics/limits.h"
#include "voronaut/dynamics/models/quadrotor.h"
#include "voronaut/dynamics/regulator.h"
#include "voronaut/dynamics/speed_profile.h"

namespace voronaut {

// Eqs. (3)-(6) of the quadrotor planner paper (Finaev et al.) and nothing else. Gains in rad/s of
// rotor speed per m/s, m/s^2 (horizontal) and per m, m/s (height).
struct PaperLiteralConfig {
  double horizontal_kp = 20;
  double horizontal_kd = 20;
  double height_kp = 97.93;
  double height_kd = 58.76;
  bool typo_in_eq3 = false;  // the fourth entry w_yc + w_zc as printed, without the half
  SpeedProfileConfig profile = {.kind = SpeedProfileConfig::Kind::literal};

  template <class Visitor>
  void visit(Visitor& v) {
    v.number("horizontal_kp", horizontal_kp, 0, 1e6);
    v.number("horizontal_kd", horizontal_kd, 0, 1e6);
    v.number("height_kp", height_kp, 0, 1e6);
    v.number("height_kd", height_kd, 0, 1e6);
    v.flag("typo_in_eq3", typo_in_eq3);
    profile.visit(v);
  }
};

// UNSTABLE for every choice of horizontal gains: kept because the paper prints it. The regulator
// pd_rate is its smallest stable completion.
//
// The derivative acts on the measurement: the printed bracket uses one desired value twice. "Yaw is
// unchangeable" is taken at its word: the pairs 1-3 and 2-4 answer for the directions in which the
// body's axes point at reset(), however it turns later; the setpoint's heading is not used. For a
// body of other than 1 kg the printed hover speed sqrt(g/4b) is sqrt(m g/4b).
class PaperLiteral : public Regulator {
 public:
  // `period_s` is the time between two calls.
  PaperLiteral(const PaperLiteralConfig& config, const QuadrotorConfig& vehicle,
               const MotionLimits& limits, double period_s);

  void reset(const VehicleState& state) override;
  Command regulate(const Setpoint& setpoint, const VehicleState& state) override;

 private:
  PaperLiteralConfig config_;
  MotionLimits limits_;
  double period_s_;
  SpeedProfile profile_;
  double hover_rad_s_;
  Eigen::Vector2d ahead_world_ = Eigen::Vector2d::UnitX();
  VehicleState previous_;
};

}  // namespace voronaut
