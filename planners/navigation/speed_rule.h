#pragma once

#include "voronaut/planners/navigation/navigation_config.h"
#include "voronaut/planners/problem/belief.h"

namespace voronaut {

// How a vehicle brakes when told to stop: what the stopping distance depends on.
struct Braking {
  double velocity_gain_1_s = 1.786;  // k of the velocity loop: V/k is the distance without limit
  double deceleration_m_s2 = 3.0;    // the limit of the vehicle
  double clearance_m = 0.4;          // what must be left when it stands
};

// The fastest speed at which a vehicle at `pose` may go in the unit direction `towards` under
// `rule`, at most max_speed_m_s. stopping_distance: it must come to rest, after reaction_time_s,
// within the way that is free of known points in that direction, range of the latest scan at most;
// a direction outside the field of view is gone at kBlindSpeed_m_s. O(1): a few swept-disc checks.
double speed_limit_m_s(SpeedRule rule, const Belief& belief, const Eigen::Vector2d& towards,
                       const Braking& braking, double reaction_time_s, double max_speed_m_s);

inline constexpr double kBlindSpeed_m_s = 0.5;

}  // namespace voronaut
