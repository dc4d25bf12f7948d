#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "voronaut/environments/generators/generated_world.h"

// What the generators share: circles that keep their distance, walls with rounded ends, turns.
namespace voronaut {

// x first, then y: the order of the draws is part of a world's identity.
Vec2 point_in(const Bounds& area, Random& random);

Vec2 unit_vector(double angle_rad);  // portable bits; exactly (1, 0) at 0
// `v` turned by the angle of the unit vector `direction`.
Vec2 turned(const Vec2& v, const Vec2& direction);
// The whole world turned about the origin; bounds become those of the turned bounds' corners.
GeneratedWorld turned(const GeneratedWorld& world, const Vec2& direction);

// Puts circles into a world one after another. A candidate costs the circles around it, and no
// circle takes more than kTries candidates.
class CirclePlacer {
 public:
  // Surfaces of two circles keep mutual_gap_m. Others than this placer may add to `circles` too.
  CirclePlacer(std::vector<Circle>& circles, double mutual_gap_m)
      : circles_(circles), mutual_gap_m_(mutual_gap_m) {}

  // Surfaces stay clearance_m away from p.
  void keep_clear(const Vec2& p, double clearance_m) { kept_.push_back({p, clearance_m}); }

  bool fits(const Circle& candidate);

  // Candidates from draw() until one fits; false if none of kTries did.
  template <class Draw>
  bool place(Draw draw) {
    for (int attempt = 0; attempt < kTries; ++attempt) {
      const Circle candidate = draw();
      if (!fits(candidate)) continue;
      circles_.push_back(candidate);
      return true;
    }
    return false;
  }

 private:
  static constexpr int kTries = 200;
  using Cell = std::pair<std::int64_t, std::int64_t>;

  Cell cell_of(const Vec2& p) const;
  void list_new_circles();

  std::vector<Circle>& circles_;
  double mutual_gap_m_;
  std::vector<Circle> kept_;
  // Circles by the cell of their centre: the first `listed_` of them.
  double cell_m_ = 1;
  double largest_radius_m_ = 0;
  std::size_t listed_ = 0;
  std::map<Cell, std::vector<std::size_t>> by_cell_;
};

// Walls have no thickness; their ends carry circles of kWallCapRadius, because an end without
// thickness seen edge-on slips between two beams of any range finder. A circle that is there
// already is not added twice. Widths of gaps and doors in the configs are the free width between
// caps.
inline constexpr double kWallCapRadius = 0.05;

void add_wall(Shapes& shapes, const Vec2& from, const Vec2& to);
// Walls along a chain of corners.
void add_walls(Shapes& shapes, const std::vector<Vec2>& corners);
// The four walls around an area.
void add_enclosure(Shapes& shapes, const Bounds& area);
// A wall from `from` to `to` with a gap of free width `gap_m` that starts `gap_at_m` after `from`.
void add_wall_with_gap(Shapes& shapes, const Vec2& from, const Vec2& to, double gap_at_m,
                       double gap_m);

}  // namespace voronaut
