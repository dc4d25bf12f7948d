#include "voronaut/planners/mapping/cell_tiles.h"

namespace voronaut {
namespace {

constexpr int kFirstSlotsLog2 = 6;

}  // namespace

CellTiles::CellTiles(double cell_m)
    : cell_m_(cell_m),
      cells_per_m_(1 / cell_m),
      shift_(64 - kFirstSlotsLog2),
      slots_(std::size_t{1} << kFirstSlotsLog2) {}

void CellTiles::insert_slot(Slot slot) {
  std::size_t i = first_slot(slot.key);
  while (slots_[i].tile != kEmpty) i = (i + 1) & (slots_.size() - 1);
  slots_[i] = slot;
}

void CellTiles::set_head(Cell cell, std::uint32_t head) {
  const std::uint32_t x = cell.x >> 3;
  const std::uint32_t y = cell.y >> 3;
  std::size_t found = find(x, y);
  if (found == kNoTile) {
    found = tiles_.size();
    tiles_.emplace_back().head.fill(kEmpty);
    if (2 * tiles_.size() > slots_.size()) {
      std::vector<Slot> smaller(2 * slots_.size());
      smaller.swap(slots_);
      --shift_;
      for (const Slot& slot : smaller) {
        if (slot.tile != kEmpty) insert_slot(slot);
      }
    }
    insert_slot({key_of(x, y), static_cast<std::uint32_t>(found)});
  }
  Tile& tile = tiles_[found];
  const std::uint64_t bit = std::uint64_t{1} << bit_of(cell);
  tile.occupied = head == kEmpty ? tile.occupied & ~bit : tile.occupied | bit;
  tile.head[bit_of(cell)] = head;
}

}  // namespace voronaut
