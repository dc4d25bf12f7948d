#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "voronaut/environments/sensing/scan.h"

namespace voronaut {

struct FreeSpaceConfig {
  double cell_m = 0.05;

  template <class Visitor>
  void visit(Visitor& v) {
    v.number("cell_m", cell_m, 0.01, 1, "Side of a cell");
  }
};

// What beams have proved empty, as square cells over the mission's bounds. A cell is known free if
// one scan saw all of it: it lies wholly within the star of that scan, the union of the triangles
// between neighbouring beams, each as long as the shorter of its two beams. So an obstacle counts
// as seen if at least one beam hits it: what is thinner than the spacing of the beams at its
// distance can hide in a triangle.
//
// Space once proved free stays so (static worlds). Cells outside the bounds are never free.
// Memory: one bit per cell of the bounds.
class FreeSpace {
 public:
  FreeSpace(const Bounds& bounds_world, const FreeSpaceConfig& config = {});

  // Marks what this scan proves. O(rows of the star + cells on its outline). A beam without a
  // measurement proves nothing. No allocation in steady state.
  void update(const Scan& scan);

  // What lies wholly within this disc is free: the body stands there at the start.
  void mark_disc(const Vec2& p_world, double radius_m);

  bool is_free(const Vec2& p_world) const;
  // True if every cell that the disc of radius_m, swept from a to b, touches is known free.
  // O(rows it touches).
  bool swept_disc_is_free(const Vec2& a, const Vec2& b, double radius_m) const;
  // The middle of the first cell, along a chain of straight pieces, that the disc swept along it
  // touches and that is not known free; empty if there is none. Looks at places a cell apart.
  std::optional<Vec2> first_unknown_in_tube(std::span<const Vec2> corners, double radius_m) const;

  // The middles of all cells that are not known free and whose circumscribed disc comes within
  // radius_m of the chain, into `middles`: at least those that the swept disc touches. O(cells of
  // the tube's bounding box x corners): for short tubes.
  void unknown_cells_in_tube(std::span<const Vec2> corners, double radius_m,
                             std::vector<Vec2>& middles) const;

  double cell_m() const { return cell_m_; }
  double cell_radius_m() const { return 0.70711 * cell_m_; }  // of the circumscribed disc
  std::size_t free_cells() const;

 private:
  // Bitmaps of the part of the grid around one star: whole words, rows first_row.. .
  struct Window {
    int first_row = 0, rows = 0;
    int first_word = 0, words = 0;
    std::vector<std::uint64_t> parity;   // flipped where the outline crosses the middle of a row
    std::vector<std::uint64_t> touched;  // cells that the outline runs through
    std::uint64_t* row(std::vector<std::uint64_t>& bits, int r) {
      return bits.data() + static_cast<std::size_t>((r - first_row) * words);
    }
  };

  Vec2 to_cells(const Vec2& p_world) const { return (p_world - origin_) / cell_m_; }
  void trace_star(const Scan& scan);
  bool open_window();
  void draw_edge(const Vec2& from, const Vec2& to);
  void draw_in_row(int row, const Vec2& a, const Vec2& b);
  void touch(int row, double x, double x_other);
  void cross_middle(int row, double x);
  void commit_window();
  std::optional<Vec2> unknown_in_disc(const Vec2& p_world, double radius_m) const;
  bool row_is_free(int row, double column_from, double column_to) const;

  double cell_m_;
  Vec2 origin_;
  int columns_;
  int rows_;
  int words_per_row_;
  std::vector<std::uint64_t> free_;

  std::vector<Vec2> outline_;  // of the star, in cells; scratch
  Window window_;              // scratch
};

}  // namespace voronaut
