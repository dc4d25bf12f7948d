#include "voronaut/planners/mapping/index/box_grid.h"

#include <algorithm>

namespace voronaut {

BoxGrid::BoxGrid(double finest_cell_m) { levels_.push_back({CellTiles(finest_cell_m)}); }

void BoxGrid::place(std::uint32_t box, const Bounds& bounds) {
  if (box >= entries_.size()) entries_.resize(box + 1);
  const double extent_m = (bounds.max - bounds.min).maxCoeff();
  std::size_t level = entries_[box].level == kNowhere ? 0 : entries_[box].level;
  while (levels_[level].cells.cell_m() < extent_m) {
    if (++level == levels_.size()) {
      levels_.push_back({CellTiles(2 * levels_.back().cells.cell_m())});
    }
  }
  CellTiles& cells = levels_[level].cells;
  const Cell cell = cells.cell_of(bounds.min.x(), bounds.min.y());
  if (entries_[box].level == level && entries_[box].cell == cell) return;
  remove(box);
  const std::uint32_t head = cells.replace_head(cell, box);
  entries_[box] = {cell, static_cast<std::uint8_t>(level), CellTiles::kEmpty, head};
  if (head != CellTiles::kEmpty) entries_[head].previous = box;
  ++levels_[level].boxes;
}

void BoxGrid::remove(std::uint32_t box) {
  Entry& entry = entries_[box];
  if (entry.level == kNowhere) return;
  Level& level = levels_[entry.level];
  if (entry.next != CellTiles::kEmpty) entries_[entry.next].previous = entry.previous;
  if (entry.previous != CellTiles::kEmpty) {
    entries_[entry.previous].next = entry.next;
  } else {
    level.cells.replace_head(entry.cell, entry.next);
  }
  --level.boxes;
  entry = {};
}

}  // namespace voronaut
