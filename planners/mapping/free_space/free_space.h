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
  // Beside surfaces that a scan saw less than near_m away a cell is known in parts, splits x splits
  // of them; 1: nowhere. A power of two up to 8.
  int splits = 1;
  double near_m = 1.0;
};

// What beams have proved empty, as square cells over the mission's bounds. A cell is known free if
// one scan saw all of it: it lies wholly within the star of that scan (ScanStar). So an obstacle
// counts as seen if at least one beam hits it: what is thinner than the spacing of the beams at its
// distance can hide in a triangle.
//
// The outline of a star that hits something runs through the cells beside it, and they stay unknown
// for as wide as they are. So they have parts, and a part is known free by the same rule. That is
// looked at only where surfaces are near: farther away beams are wider apart than parts.
//
// Space once proved free stays so (static worlds). Cells outside the bounds are never free.
// Memory: one bit per cell of the tiles (64 x 64 cells) that scans reached, whatever the bounds,
// and as much for the parts beside surfaces.
class FreeSpace {
 public:
  // Throws std::invalid_argument unless the bounds have 1 to kCellsMax parts of cells a side and
  // splits is as above.
  static constexpr double kCellsMax = 1 << 24;
  static constexpr int kSplitsMax = 8;
  FreeSpace(const Bounds& bounds_world, const FreeSpaceConfig& config = {});

  // Marks what this scan proves; where cells have parts, scans are taken by turns for whole cells
  // and for parts beside near surfaces. O(beams + rows of the star or of what is near + cells or
  // parts on the outline). A beam without a measurement proves nothing. No allocation where scans
  // have been before.
  void update(const Scan& scan);

  // What lies wholly within this disc is free: the body stands there at the start.
  void mark_disc(const Vec2& p_world, double radius_m);

  // The same of a convex polygon, counter-clockwise.
  void mark_convex(std::span<const Vec2> corners_world);

  bool is_free(const Vec2& p_world) const;
  // True if all that the disc of radius_m, swept from a to b, touches is known free, cells or parts
  // of them. O(rows it touches).
  bool swept_disc_is_free(const Vec2& a, const Vec2& b, double radius_m) const;
  // The same of a convex polygon (corners in world axes, counter-clockwise) grown by grown_m >= 0.
  // O(rows x corners).
  bool convex_is_free(std::span<const Vec2> corners_world, double grown_m) const;
  // The middle of the first part of a cell, along a chain of straight pieces, that the disc swept
  // along it touches and that is not known free; empty if there is none. Looks at places a part
  // apart.
  std::optional<Vec2> first_unknown_in_tube(std::span<const Vec2> corners, double radius_m) const;

  // The middles of all parts of cells that are not known free and whose circumscribed disc comes
  // within radius_m of the chain, into `middles`: at least those that the swept disc touches.
  // O(parts of unknown cells in the tube's bounding box x corners): for short tubes.
  void unknown_cells_in_tube(std::span<const Vec2> corners, double radius_m,
                             std::vector<Vec2>& middles) const;

  // The same of a convex polygon grown by radius_m, in any order. O(cells of its box x corners).
  void unknown_cells_in_convex(std::span<const Vec2> corners_world, double grown_m,
                               std::vector<Vec2>& middles) const;

  double cell_m() const { return cells_.side_m; }
  // Of a part of a cell, where they have parts: its side, and the radius of its circumscribed disc.
  double part_m() const { return parts_.side_m; }
  double part_radius_m() const { return 0.70711 * parts_.side_m; }
  std::size_t free_cells() const { return cells_.free.set_bits(); }
  std::size_t free_parts() const { return parts_.free.set_bits(); }

 private:
  // Square cells from the lower left corner of the bounds on.
  struct Lattice {
    double side_m;
    int columns, rows;
    BitTiles free;

    Lattice(const Vec2& size_m, double side_m);
    void mark_disc(const Vec2& center_cells, double radius_cells);
    void mark_convex(std::span<const Vec2> corners_cells);
    bool holds(int row, double column_from, double column_to) const {
      return row >= 0 && row < rows && column_from >= 0 && column_to < columns;
    }
    bool is_free(const Vec2& p_cells) const;
    bool box_is_free(const Vec2& a_cells, const Vec2& b_cells, double radius_cells) const;
  };
  class SweptDisc;
  class GrownPolygon;

  Vec2 in(const Lattice& lattice, const Vec2& p_world) const {
    return (p_world - origin_) / lattice.side_m;
  }
  bool has_parts() const { return splits_ > 1; }
  std::optional<Vec2> unknown_in_disc(const Vec2& p_world, double radius_m) const;
  // The middles of the unknown parts in the box around some corners, grown by reach_m, that
  // is_near() takes.
  template <class IsNear>
  void unknown_parts(std::span<const Vec2> corners, double reach_m, std::vector<Vec2>& middles,
                     const IsNear& is_near) const;
  // Whether all that a region touches is known free: `in_parts()` is the same region in units of
  // parts.
  template <class Region, class InParts>
  bool is_free(const Region& region, const InParts& in_parts) const;
  template <class Region>
  bool parts_are_free(int row, int column_from, int column_to, const Region& region) const;

  Vec2 origin_;  // of the lattices: the lower left corner of the bounds
  int splits_;
  double near_m_;
  Lattice cells_;
  Lattice parts_;  // the cells themselves, and nothing kept, where cells have no parts

  bool sees_whole_ = false;  // the latest scan was taken as a whole

  ScanStar star_;      // scratch
  StarRaster raster_;  // scratch
};

}  // namespace voronaut
