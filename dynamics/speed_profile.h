#pragma once

#include <Eigen/Core>

// How a vehicle slows down towards a point at which it shall rest.
//
// Source: eq. (6) of the quadrotor planner paper (Finaev et al.), whose printed form can be read in
// more than one way; docs state what each reading does.
namespace voronaut {

struct SpeedProfileConfig {
  enum class Kind {
    sqrt,      // constant deceleration, then exponential: the default
    paper,     // eq. (6) as a logistic in the distance, shifted so that it is 0 at the target
    logistic,  // eq. (6) with the bars moved: does not vanish at the target, creeps or chatters
    literal,   // eq. (6) as printed with b = x_d, axis by axis: half the speed at the target
  };

  Kind kind = Kind::sqrt;
  double deceleration_m_s2 = 1.0;      // sqrt: a_b
  double goal_gain_1_s = 0.6;          // sqrt: k_v; keep <= 0.35 kp/kd or the vehicle overshoots
  double slope_1_m = 2.0;              // the others: a of eq. (6)
  double half_speed_distance_m = 1.5;  // paper, logistic: b of eq. (6)

  template <class Visitor>
  void visit(Visitor& v) {
    v.choice("speed_profile", kind,
             {{"sqrt", Kind::sqrt},
              {"paper", Kind::paper},
              {"logistic", Kind::logistic},
              {"literal", Kind::literal}});
    v.number("profile_deceleration_m_s2", deceleration_m_s2, 0.01, 100);
    v.number("profile_goal_gain_1_s", goal_gain_1_s, 0.01, 100);
    v.number("profile_slope_1_m", slope_1_m, 0.01, 100);
    v.number("profile_half_speed_distance_m", half_speed_distance_m, 0, 100);
  }
};

class SpeedProfile {
 public:
  explicit SpeedProfile(const SpeedProfileConfig& config);

  // Speed at `distance_m` >= 0 from the target, in [0, max_speed_m_s]. O(1), at most one exp.
  double speed_m_s(double distance_m, double max_speed_m_s) const;

  // Velocity for a target at `to_target_m` (world axes) from here: speed_m_s towards it, or, for
  // the literal kind, eq. (6) on each axis with that axis' own distance. Zero at the target.
  Eigen::Vector2d velocity_m_s(const Eigen::Vector2d& to_target_m, double max_speed_m_s) const;

 private:
  double logistic(double distance_m, double center_m) const;

  SpeedProfileConfig config_;
  double at_target_ = 0;  // of the logistic curve, as a share of the maximum
};

}  // namespace voronaut
