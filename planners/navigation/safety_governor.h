#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "voronaut/dynamics/velocity_response.h"
#include "voronaut/environments/shapes/geometry.h"
#include "voronaut/planners/mapping/free_space/free_space.h"
#include "voronaut/planners/mapping/obstacle_snapshot.h"

namespace voronaut {

// What is kept from known points: what planners plan with (less kKnownMargin_m), or nothing beyond
// what is known to be free, where a passage turned out narrower than that.
enum class KnownClearance { planned, reduced };

// What the governor allows until the next scan.
struct GovernedVelocity {
  Vec2 v_world = Vec2::Zero();  // to be commanded [m/s]
  double speed_scale = 1;       // of the speed asked for; 0: brake
  // Where the body would go: hold the velocity, then brake to rest. Corners of a chain of straight
  // segments, valid until the next call; empty when braking without a track that was proved.
  std::vector<Vec2> tube_world;
  // A place that the next faster tube would have touched and nobody knows to be free. Looked for
  // only while the vehicle is slow: who stands asks why.
  std::optional<Vec2> refused_at;
};

// Lets no planner crash. A velocity is allowed for one period only if the disc that the body sweeps
// while it holds the velocity and then brakes to rest lies in space that beams have proved free
// (and away from known points as far as below); else less speed in the same direction, else
// braking.
//
// Invariant: at every call the track of braking from the present state lies in known-free space. It
// holds at rest in free space, and each velocity allowed or braked keeps it, for then the rest of a
// track proved before is flown. So the vehicle never touches anything, if
//  - the world stands still,
//  - pose and ranges are exact (an error belongs into the body's radius),
//  - the vehicle brakes as `response` says, within its error_m, and holds each velocity for hold_s,
//  - it starts at rest in free space,
//  - nothing is thinner than the beams' spacing at the range where they pass it, and what stands
//    there crosses the range finder's plane: tilting does not turn that plane (a levelled sensor).
// tests/planners/navigation/safety_governor_test.cpp breaks each of these and shows the contact.
//
// At rest or slow, a command may also lead away from whatever unknown cells its tube touches
// (planners/navigation/departure.h): what stands there was not touched before either.
//
// The bounds hold the centre as a wall would that nobody sees: a track keeps from them what a stop
// may stray; from closer by, a slow command leads inwards as it leads away from unknown cells.
//
// Besides, a track keeps min(planning_clearance_m - kKnownMargin_m, the clearance there is now)
// from known points: closer than that planner and governor would wait for each other.
//
// The idea that a plan may lead through the unknown as long as a stop within the known remains:
// Tordesillas et al., FASTER, arXiv:2001.04420.
class SafetyGovernor {
 public:
  static constexpr double kKnownMargin_m = 0.03;
  static const Bounds kEverywhere;
  // What is commanded lies beyond the velocity wanted, v + kVelocityGain (wanted - v), so that the
  // vehicle gets there with a velocity loop kVelocityGain times as fast as its regulator's.
  static constexpr double kVelocityGain = 1.6;

  // `centre_bounds_world`: where the centre may be.
  SafetyGovernor(const VelocityResponse& response, double body_radius_m,
                 double planning_clearance_m, double hold_s,
                 const Bounds& centre_bounds_world = kEverywhere);

  // What a track at the present speed keeps from the bounds.
  double room_to_bounds_m(const VehicleState& state) const;

  // The fastest of a few scales of v_wanted_world [m/s] that is safe from `state` on. Zero is
  // braking, which is always allowed. O(time to rest), a few thousand instructions for each scale
  // that is looked at: one where nothing is in the way, most often two where something is.
  const GovernedVelocity& allow(const Vec2& v_wanted_world, const VehicleState& state,
                                const FreeSpace& free, const ObstacleSnapshot& known,
                                KnownClearance kept);

 private:
  std::size_t safe_level(const Vec2& v_wanted_world, const PlanarMotion& now, const FreeSpace& free,
                         const ObstacleSnapshot& known, double keep_m);
  Vec2 command_at(double speed_scale, const Vec2& v_wanted_world, const PlanarMotion& now) const;
  double tube_radius_m(double speed_scale, const Vec2& v_wanted_world,
                       const PlanarMotion& now) const;
  bool is_safe(double speed_scale, const Vec2& v_wanted_world, const PlanarMotion& now,
               const FreeSpace& free, const ObstacleSnapshot& known, double keep_m);
  // What unknown cells the tube touches, a slow command leaves behind.
  bool departs(const Vec2& v_command_m_s, const PlanarMotion& now, const FreeSpace& free,
               double radius_m);
  // The track keeps room_m from the bounds, or leads inwards from where it does not.
  bool keeps_to_bounds(const Vec2& v_command_m_s, const PlanarMotion& now, double room_m);
  void straighten_track();

  VelocityResponse response_;
  double body_radius_m_;
  double keep_from_known_m_;
  double hold_s_;
  Bounds centre_bounds_world_;
  Vec2 v_before_ = Vec2::Zero();
  GovernedVelocity allowed_;
  std::vector<Vec2> track_;            // as predicted
  std::vector<Vec2> corners_;          // its corners
  std::vector<Vec2> safe_corners_;     // of the largest scale found safe
  std::vector<Vec2> refused_corners_;  // of the smallest found unsafe
  std::size_t level_ = 0;              // number of the scale allowed before
  std::vector<Vec2> unknown_cells_;
  std::vector<Vec2> outside_;  // a place beyond each side of the bounds that is too close
};

}  // namespace voronaut
