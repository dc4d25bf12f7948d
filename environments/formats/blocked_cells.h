#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "voronaut/environments/formats/foreign_world.h"

// Grids of square cells, free or blocked, and the exact shapes that they stand for.
namespace voronaut {

// Column 0 is the left one, row 0 the lowest: columns go along x, rows along y.
class BlockedCells {
 public:
  static constexpr int kLongestSide = 10'000;
  static constexpr std::int64_t kMostCells = 20'000'000;

  static bool may_have(int columns, int rows) {
    return columns > 0 && rows > 0 && std::int64_t{columns} * rows <= kMostCells;
  }

  // All free. At least one cell, at most kMostCells.
  BlockedCells(int columns, int rows)
      : columns_(columns), rows_(rows), cells_(std::size_t(columns) * std::size_t(rows), 0) {}

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  void block(int column, int row) { cells_[index(column, row)] = 1; }
  bool blocked(int column, int row) const { return cells_[index(column, row)] != 0; }

 private:
  std::size_t index(int column, int row) const {
    return std::size_t(row) * std::size_t(columns_) + std::size_t(column);
  }

  int columns_;
  int rows_;
  std::vector<char> cells_;
};

// A rectangle of whole cells.
struct CellBlock {
  int column = 0;
  int row = 0;
  int columns = 1;
  int rows = 1;
};

// The blocked cells cut into few large rectangles: each blocked cell lies in exactly one, no free
// cell in any. Runs of cells are joined with equal runs in the next line, once along rows and once
// along columns, and the way with fewer rectangles is taken. O(cells).
std::vector<CellBlock> blocks_of(const BlockedCells& cells);

// The grid's area and its blocked cells as boxes. Two cells that share a corner only touch there.
// `frame` has the grid's numbers of columns and rows.
ForeignWorld world_of(const BlockedCells& cells, const CellFrame& frame);

}  // namespace voronaut
