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

  // Whether all that is swept lies in known-free space, or the command is slow (departure.h) and no
  // part of the body comes closer to any cell that it touches: what stands there was not touched
  // before either. `track` and `headings` (unit vectors) as
  // predicted. O(samples that turn x rows).
  bool is_safe(const PredictedStop& stop, const std::vector<Vec2>& track,
               const std::vector<Vec2>& headings, const FreeSpace& free);

  // The middle of a cell that is touched first and that nobody knows to be free; none: nothing.
  std::optional<Vec2> first_unknown(const PredictedStop& stop, const std::vector<Vec2>& track,
                                    const std::vector<Vec2>& headings, const FreeSpace& free);

  // Which of ahead and back, the one nearer to `towards` first, leads straight away from all cells
  // that are not known free and come within what a stop may stray and near_m of the body as it
  // stands (a unit vector); none: it touches nothing there, or neither does.
  std::optional<Vec2> way_out(const Vec2& towards, const Vec2& p_world, const Vec2& heading,
                              double near_m, const FreeSpace& free);

 private:
  // Calls visit(hull) for the hulls along the track, until it returns false.
  template <class Visit>
  bool each_hull(const std::vector<Vec2>& track, const std::vector<Vec2>& headings, Visit&& visit);
  bool departs(const PredictedStop& stop, const std::vector<Vec2>& track,
               const std::vector<Vec2>& headings, const FreeSpace& free);
  // What of the cells the body, at p, does not cover.
  void note_corners(const Vec2& p_world, const Vec2& heading, const FreeSpace& free);
  bool comes_no_closer(const Vec2& p_world, const Vec2& heading);

  std::vector<Vec2> corners_body_;
  double radius_m_;  // of the disc about the origin that holds it
  double slack_m_;
  struct Corner {
    Vec2 p_world;
    double distance_m;  // of the body as it stands
  };
  std::vector<Corner> cell_corners_;                   // scratch
  std::vector<Vec2> hull_, placed_, cells_, touched_;  // scratch
};

}  // namespace voronaut
