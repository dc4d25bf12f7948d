#pragma once

#include <vector>

#include "voronaut/dynamics/footprint.h"
#include "voronaut/planners/mapping/free_space/free_space.h"
#include "voronaut/planners/navigation/command_ladder.h"

namespace voronaut {

// What a polygon sweeps along the track of a predicted stop, turned as it is on its way, held
// against known-free space: StopTube for a body that is no disc.
class FootprintSweep {
 public:
  // Time between samples of the track [s]. The hull of two polygons this far apart, grown by
  // slack_m(), holds what is swept in between.
  static constexpr double kSample_s = 0.02;

  // Not a disc.
  explicit FootprintSweep(const Footprint& footprint);

  // How far what is swept may stick out of the hulls, beside what the stop may stray: of arcs
  // beyond their chords, and of headings by the error of their prediction.
  double slack_m() const { return slack_m_; }

  // Whether all that is swept lies in known-free space, or a slow command leads away from what it
  // touches without turning towards it (departure.h). `track` and `headings` (unit vectors) as
  // predicted. O(samples that turn x rows).
  bool is_safe(const PredictedStop& stop, const std::vector<Vec2>& track,
               const std::vector<Vec2>& headings, const FreeSpace& free);

  // The middle of a cell that is touched first and that nobody knows to be free; none: nothing.
  std::optional<Vec2> first_unknown(const PredictedStop& stop, const std::vector<Vec2>& track,
                                    const std::vector<Vec2>& headings, const FreeSpace& free);

  // For each cell that is not known free and comes within `grown_m` of the body where it stands, a
  // place in the direction, seen from the body's centre, that its closest corner or side faces.
  void places_faced(const Vec2& p_world, const Vec2& heading, double grown_m, const FreeSpace& free,
                    std::vector<Vec2>& places);

 private:
  // Calls visit(hull) for the hulls along the track, until it returns false.
  template <class Visit>
  bool each_hull(const std::vector<Vec2>& track, const std::vector<Vec2>& headings, Visit&& visit);
  bool departs(const PredictedStop& stop, const std::vector<Vec2>& track,
               const std::vector<Vec2>& headings, const FreeSpace& free);
  void face(const Vec2& p_world, const Vec2& heading, std::vector<Vec2>& places);

  std::vector<Vec2> corners_body_;
  double radius_m_;  // of the disc about the origin that holds it
  double slack_m_;
  std::vector<Vec2> hull_, placed_, cells_, touched_;  // scratch
  std::vector<double> rim_moved_m_;                    // scratch
};

}  // namespace voronaut
