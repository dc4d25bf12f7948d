#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "voronaut/planners/mapping/free_space/free_space.h"
#include "voronaut/planners/mapping/obstacle_snapshot.h"
#include "voronaut/planners/navigation/command_ladder.h"
#include "voronaut/planners/navigation/declared_errors.h"
#include "voronaut/planners/navigation/footprint_sweep.h"
#include "voronaut/planners/navigation/stop_tube.h"

namespace voronaut {

// What is kept from known points: what planners plan with (less kKnownMargin_m), or nothing beyond
// what is known to be free, where a passage turned out narrower than that.
enum class KnownClearance { planned, reduced };

// What the governor allows until the next scan.
struct GovernedMotion {
  MotionCommand command;        // to be held
  Vec2 v_world = Vec2::Zero();  // of the centre, as commanded [m/s]
  double speed_scale = 1;       // of the speed asked for; 0: brake
  // Where the body would go: hold the command, then brake to rest. Corners of a chain of straight
  // segments, valid until the next call; empty when braking without a track that was proved.
  std::vector<Vec2> tube_world;
  // A place that the next faster tube would have touched and nobody knows to be free. Looked for
  // only while the vehicle is slow: who stands asks why. Kept while it turns on the spot.
  std::optional<Vec2> refused_at;
};

// Lets no planner crash. A command, a velocity for what moves in every direction or an arc for what
// drives along its heading, is allowed for one period only if what the body sweeps while it holds
// the command and then brakes to rest lies in space that beams have proved free (and away from
// known points as far as below); else one that leads aside, else less speed of the same kind, else
// braking. A body is a disc, or a polygon turned as predicted; one that moves in every direction is
// swept as the disc that holds it, as its heading is nobody's to predict.
//
// Invariant: at every call the track of braking from the present state lies in known-free space. It
// holds at rest in free space, and each command allowed or braked keeps it, for then the rest of a
// track proved before is driven. So the vehicle never touches anything, if
//  - the world stands still,
//  - pose and ranges are as exact as declared (declared_errors.h; what they may be off is kept from
//    what FreeSpace takes for free, by DoubtedScan, and added to the tube),
//  - the vehicle brakes as `response` says, within its error_m and what is declared beside it, and
//    holds each command for hold_s,
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
// What moves in every direction and was fast goes aside, with all the speed that is wanted, rather
// than straight and slower: one more command, proved like any other.
//
// The idea that a plan may lead through the unknown as long as a stop within the known remains:
// Tordesillas et al., FASTER, arXiv:2001.04420.
class SafetyGovernor {
 public:
  static constexpr double kKnownMargin_m = 0.03;
  static const Bounds kEverywhere;

  // `centre_bounds_world`: where the centre may be.
  SafetyGovernor(const MotionResponse& response, double body_radius_m, double planning_clearance_m,
                 double hold_s, const Bounds& centre_bounds_world = kEverywhere,
                 const Footprint& footprint = {}, const DeclaredErrors& errors = {});

  // What a track at the present speed keeps from the bounds.
  double room_to_bounds_m(const VehicleState& state) const;

  // The direction (unit vector) nearest to `towards` in which the body, as it stands, leaves all
  // cells that are not known free and come within what a stop may stray and near_m of it, and a
  // known point, if there is one as close; none: it is near to nothing, or that lies all around.
  std::optional<Vec2> way_out(const Vec2& towards, const VehicleState& state, double near_m,
                              const FreeSpace& free, const std::optional<Vec2>& known_point);
  // Turning on the spot, too, takes known-free space.
  bool sweeps_by_turning() const { return sweep_.has_value(); }

  // The fastest of a few commands towards what is wanted that is safe from `state` on. The slowest
  // is braking, which is always allowed. O(time to rest), a few thousand instructions for each
  // command that is looked at: one where nothing is in the way, two to five where something is.
  const GovernedMotion& allow(const WantedMotion& wanted, const VehicleState& state,
                              const FreeSpace& free, const ObstacleSnapshot& known,
                              KnownClearance kept);

 private:
  std::size_t found_level(const FreeSpace& free, const ObstacleSnapshot& known, double keep_m);
  bool is_safe(std::size_t level, const FreeSpace& free, const ObstacleSnapshot& known,
               double keep_m);
  std::size_t safe_level(std::size_t unsafe, const FreeSpace& free, const ObstacleSnapshot& known,
                         double keep_m);
  bool goes_aside(const FreeSpace& free, const ObstacleSnapshot& known, double keep_m);
  std::size_t safe_level_between(std::size_t safe, std::size_t unsafe, const FreeSpace& free,
                                 const ObstacleSnapshot& known, double keep_m);
  PredictedStop predict(std::size_t level);
  std::optional<Vec2> unknown_refused(const FreeSpace& free);

  std::unique_ptr<CommandLadder> ladder_;
  StopTube tube_;
  std::optional<FootprintSweep> sweep_;  // of what is no disc, instead of the tube
  DeclaredErrors errors_;
  double keep_from_known_m_;
  double hold_s_;
  GovernedMotion allowed_;
  std::vector<Vec2> touched_;           // scratch
  std::vector<Vec2> track_, headings_;  // as predicted
  std::vector<Vec2> refused_track_, refused_headings_;
  std::vector<Vec2> corners_;           // of the track
  std::vector<Vec2> safe_corners_;      // of the latest command found safe
  std::vector<Vec2> refused_corners_;   // of the latest found unsafe
  std::vector<Vec2> straight_corners_;  // of that, while others are tried
  PredictedStop safe_stop_, refused_stop_;
  std::size_t level_ = 0;  // allowed before
  bool goes_left_ = true;  // the last time it went aside
};

}  // namespace voronaut
