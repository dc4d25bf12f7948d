#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "voronaut/environments/sensing/scan.h"

namespace voronaut {

// What one scan has shown empty: the union of the triangles between neighbouring beams, each as
// long as the shorter of its two beams. Kept as closed outlines: of that union, or of its parts
// beside the surfaces that the scan saw close by. Lengths of outlines are in cells.
class ScanStar {
 public:
  struct Corner {
    double x, y;      // in cells
    int column, row;  // of its cell
  };
  struct Box {
    int low_column, high_column, low_row, high_row;
  };
  // Counter-clockwise and closed: the first corner is the last one, too.
  struct Outline {
    std::span<const Corner> corners;
    Box box;  // of their cells
  };

  // Of the whole star. `sensor` is the place of the range finder in cells, whose sides are cell_m.
  // Two beams or more. O(beams), no allocation in steady state. Valid until the next call.
  Outline trace(const Scan& scan, const Vec2& sensor, double cell_m);

  // Of a part of the star beside surfaces that are less than within_m away: consecutive beams,
  // those that hit them and depth_m to both sides, from depth_m before the closest of them on, and
  // no farther than within_m. A full circle is parted at its first beam. The part with the first
  // such surface from beam `first` on; sets `first` to the beam behind it. No corners: there is
  // none.
  Outline trace_near(const Scan& scan, const Vec2& sensor, double cell_m, double within_m,
                     double depth_m, std::size_t& first_beam);

 private:
  class Pen;
  // Triangles [first, end) between the beams of their numbers and the next.
  struct Part {
    std::size_t first, end;
    double longest_m;   // beams count as no longer
    double shortest_m;  // where it begins
  };
  static std::optional<Part> near_part(const Scan& scan, double within_m, double depth_m,
                                       std::size_t& first_beam);
  template <bool closed>
  static void draw(const Scan& scan, double cell_m, const Part& part, Pen& pen);
  static void draw_back(const Scan& scan, double cell_m, const Part& part, Pen& pen);
  Corner* room_for(const Scan& scan);
  Outline outline(const Pen& pen);

  std::vector<Corner> corners_;  // those of the latest outline, and room
};

}  // namespace voronaut
