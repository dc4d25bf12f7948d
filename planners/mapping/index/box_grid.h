#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "voronaut/environments/shapes/geometry.h"
#include "voronaut/planners/mapping/index/cell_tiles.h"

namespace voronaut {

// Boxes that grow, found by where they are: a hierarchy of grids, each twice as coarse as the one
// before. A box lies in exactly one chain, that of the cell of its lower left corner in the finest
// grid whose cells are not smaller than the box. So memory is proportional to the number of boxes,
// however large they grow.
class BoxGrid {
 public:
  explicit BoxGrid(double finest_cell_m);

  // Places a new box under the next number (0, 1, 2 ...), or moves one that has changed.
  void place(std::uint32_t box, const Bounds& bounds);
  void remove(std::uint32_t box);

  // Calls visit(box) for a superset of the boxes that overlap `area` (touching included).
  template <class Visit>
  void for_each_near(const Bounds& area, const Visit& visit) const {
    for (const Level& level : levels_) {
      if (level.boxes == 0) continue;
      const double before_m = kRoundingMargin * level.cells.cell_m();
      const Cell low = level.cells.cell_of(area.min.x() - before_m, area.min.y() - before_m);
      const Cell high = level.cells.cell_of(area.max.x(), area.max.y());
      level.cells.any_of(low, high, [&](std::uint32_t box) {
        for (; box != CellTiles::kEmpty; box = entries_[box].next) visit(box);
        return false;
      });
    }
  }

 private:
  static constexpr std::uint8_t kNowhere = 0xff;
  static constexpr double kRoundingMargin = 1 + 1e-6;

  struct Level {
    CellTiles cells;
    std::size_t boxes = 0;
  };
  struct Entry {
    Cell cell;
    std::uint8_t level = kNowhere;
    std::uint32_t previous = CellTiles::kEmpty;
    std::uint32_t next = CellTiles::kEmpty;
  };

  std::vector<Level> levels_;
  std::vector<Entry> entries_;
};

}  // namespace voronaut
