#pragma once

#include <optional>
#include <span>
#include <vector>

#include "voronaut/planners/mapping/free_space/bit_tiles.h"
#include "voronaut/planners/mapping/free_space/scan_star.h"
#include "voronaut/planners/mapping/free_space/star_raster.h"

namespace voronaut {

struct FreeSpaceConfig {
  double cell_m = 0.05;

  template <class Visitor>
  void visit(Visitor& v) {
    v.number("cell_m", cell_m, 0.01, 1, "Side of a cell");
  }
};

// What beams have proved empty, as square cells over the mission's bounds. A cell is known free if
// one scan saw all of it: it lies wholly within the star of that scan (ScanStar). So an obstacle
// counts as seen if at least one beam hits it: what is thinner than the spacing of the beams at its
// distance can hide in a triangle.
//
// Space once proved free stays so (static worlds). Cells outside the bounds are never free.
// Memory: one bit per cell of the tiles (64 x 64 cells) that scans reached, whatever the bounds.
class FreeSpace {
 public:
  // Throws std::invalid_argument unless the bounds have 1 to kCellsMax cells a side.
  static constexpr double kCellsMax = 1 << 24;
  FreeSpace(const Bounds& bounds_world, const FreeSpaceConfig& config = {});

  // Marks what this scan proves. O(beams + rows of the star + cells on its outline). A beam without
  // a measurement proves nothing. No allocation where scans have been before.
  void update(const Scan& scan);

  // What lies wholly within this disc is free: the body stands there at the start.
  void mark_disc(const Vec2& p_world, double radius_m);

  // The same of a convex polygon, counter-clockwise.
  void mark_convex(std::span<const Vec2> corners_world);

  bool is_free(const Vec2& p_world) const;
  // True if every cell that the disc of radius_m, swept from a to b, touches is known free.
  // O(rows it touches).
  bool swept_disc_is_free(const Vec2& a, const Vec2& b, double radius_m) const;
  // The same of a convex polygon (corners in world axes, counter-clockwise) grown by grown_m >= 0.
  // O(rows x corners).
  bool convex_is_free(std::span<const Vec2> corners_world, double grown_m) const;
  // The middle of the first cell, along a chain of straight pieces, that the disc swept along it
  // touches and that is not known free; empty if there is none. Looks at places a cell apart.
  std::optional<Vec2> first_unknown_in_tube(std::span<const Vec2> corners, double radius_m) const;

  // The middles of all cells that are not known free and whose circumscribed disc comes within
  // radius_m of the chain, into `middles`: at least those that the swept disc touches. O(cells of
  // the tube's bounding box x corners): for short tubes.
  void unknown_cells_in_tube(std::span<const Vec2> corners, double radius_m,
                             std::vector<Vec2>& middles) const;

  // The same of a convex polygon grown by radius_m, in any order. O(cells of its box x corners).
  void unknown_cells_in_convex(std::span<const Vec2> corners_world, double grown_m,
                               std::vector<Vec2>& middles) const;

  double cell_m() const { return cell_m_; }
  double cell_radius_m() const { return 0.70711 * cell_m_; }  // of the circumscribed disc
  std::size_t free_cells() const { return free_.set_bits(); }

 private:
  Vec2 to_cells(const Vec2& p_world) const { return (p_world - origin_) / cell_m_; }
  std::optional<Vec2> unknown_in_disc(const Vec2& p_world, double radius_m) const;
  bool box_is_free(const Vec2& a_cells, const Vec2& b_cells, double radius_cells) const;
  bool row_is_free(int row, double column_from, double column_to) const;

  double cell_m_;
  Vec2 origin_;  // of the lattice: the lower left corner of the bounds
  int columns_;
  int rows_;
  BitTiles free_;

  ScanStar star_;      // scratch
  StarRaster raster_;  // scratch
};

}  // namespace voronaut
