#pragma once

#include <vector>

#include "voronaut/planners/mapping/free_space/free_space.h"
#include "voronaut/planners/mapping/obstacle_snapshot.h"
#include "voronaut/planners/navigation/command_ladder.h"

namespace voronaut {

// What the body sweeps along the track of a predicted stop, held against all that the governor
// knows: known points, the bounds, known-free space. A disc, so only where the centre goes counts.
class StopTube {
 public:
  // Samples of a track may lie this far beside its straight segments; the tube is wider by it.
  static constexpr double kStraight_m = 0.005;

  // `centre_bounds_world`: where the centre may be.
  StopTube(double body_radius_m, const Bounds& centre_bounds_world)
      : body_radius_m_(body_radius_m), centre_bounds_world_(centre_bounds_world) {}

  double body_radius_m() const { return body_radius_m_; }
  double radius_m(const PredictedStop& stop) const {
    return body_radius_m_ + stop.stray_m + kStraight_m;
  }

  // Whether the track stays in the bounds (or a slow command leads away from where it does not) and
  // keeps keep_m from known points. `corners`: the track as a chain of straight segments,
  // straighten()'s. O(segments).
  bool keeps_clear(const PredictedStop& stop, const std::vector<Vec2>& corners,
                   const ObstacleSnapshot& known, double keep_m);
  // The same, and whether the tube lies in known-free space, or a slow command leads away from what
  // it touches (departure.h). O(segments).
  bool is_safe(const PredictedStop& stop, const std::vector<Vec2>& corners, const FreeSpace& free,
               const ObstacleSnapshot& known, double keep_m);

  // The corners of a chain of straight segments that passes every sample within kStraight_m.
  static void straighten(const std::vector<Vec2>& track, std::vector<Vec2>& corners);

 private:
  // What unknown cells the tube touches, the command, a slow one, leaves behind.
  bool departs(const PredictedStop& stop, const std::vector<Vec2>& corners, const FreeSpace& free);
  static bool keeps_from(const std::vector<Vec2>& corners, const ObstacleSnapshot& known,
                         double keep_m);
  // The track keeps what it may stray from the bounds, or leads inwards from where it does not.
  bool keeps_to_bounds(const PredictedStop& stop, const std::vector<Vec2>& corners);

  double body_radius_m_;
  Bounds centre_bounds_world_;
  std::vector<Vec2> unknown_cells_;
  std::vector<Vec2> outside_;  // a place beyond each side of the bounds that is too close
};

}  // namespace voronaut
