#pragma once

#include <cstdint>
#include <vector>

#include "voronaut/environments/scan.h"

namespace voronaut {

struct FreeSpaceConfig {
  double cell_m = 0.05;

  template <class Visitor>
  void visit(Visitor& v) {
    v.number("cell_m", cell_m, 0.01, 1);
  }
};

// What beams have proved empty, as square cells over the mission's bounds. A cell is known free if
// one scan saw all of it: it lies wholly within the star of that scan, the union of the triangles
// between neighbouring beams, each as long as the shorter of its two beams. So an obstacle counts as
// seen if at least one beam hits it: what is thinner than the spacing of the beams at its distance
// can hide in a triangle.
//
// Space once proved free stays so (static worlds). Cells outside the bounds are never free.
// Memory: one bit per cell of the bounds.
class FreeSpace {
 public:
  FreeSpace(const Bounds& bounds_world, const FreeSpaceConfig& config = {});

  // Marks what this scan proves. O(rows of the star + cells on its outline). A beam without a
  // measurement proves nothing. No allocation in steady state.
  void update(const Scan& scan);

  // The body is known to stand in free space at the start.
  void mark_disc(const Vec2& p_world, double radius_m);

  bool is_free(const Vec2& p_world) const;
  // True if every cell that the disc of radius_m, swept from a to b, touches is known free.
  // O(rows it touches).
  bool swept_disc_is_free(const Vec2& a, const Vec2& b, double radius_m) const;
  // The same for a disc that grows linearly from radius_a to radius_b on its way.
  bool cone_is_free(const Vec2& a, const Vec2& b, double radius_a_m, double radius_b_m) const;

  double cell_m() const { return cell_m_; }
  std::size_t free_cells() const;

 private:
  struct Crossing {
    int row;
    float column;  // in cells, where the outline crosses the middle of the row
  };

  void build_outline(const Scan& scan);
  void block_outline_cells();
  void collect_crossings();
  void fill_rows();
  bool row_is_free(int row, double x_from, double x_to) const;

  double cell_m_;
  Vec2 origin_;
  int columns_ = 0;
  int rows_ = 0;
  std::size_t words_per_row_ = 0;
  std::vector<std::uint64_t> free_;

  // Scratch of one update, in cell units.
  std::vector<Vec2> outline_;
  std::vector<Crossing> crossings_;
  std::vector<std::uint64_t> blocked_;  // cells that the outline touches
  int first_row_ = 0;
  int last_row_ = -1;
};

}  // namespace voronaut
