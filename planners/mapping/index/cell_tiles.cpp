#include "voronaut/planners/mapping/index/cell_tiles.h"

#include <utility>

namespace voronaut {
namespace {

constexpr int kFirstSlotsLog2 = 6;

}  // namespace

CellTiles::CellTiles(double cell_m)
    : grid_(cell_m), shift_(64 - kFirstSlotsLog2), slots_(std::size_t{1} << kFirstSlotsLog2) {}

CellTiles::CellTiles(const CellTiles& other)
    : grid_(other.grid_), shift_(other.shift_), slots_(other.slots_), heads_(other.heads_) {
  for (Slot& slot : slots_) {
    if (slot.key != kNoKey) slot.heads = &heads_[slot.tile];
  }
}

void CellTiles::insert(const Slot& slot) {
  const std::size_t place = static_cast<std::size_t>(
      &find(static_cast<std::uint32_t>(slot.key >> 32), static_cast<std::uint32_t>(slot.key)) -
      slots_.data());
  slots_[place] = slot;
}

CellTiles::Slot& CellTiles::make(std::uint32_t x, std::uint32_t y) {
  const std::size_t tile = heads_.size();
  if (2 * (tile + 1) > slots_.size()) {
    std::vector<Slot> smaller(2 * slots_.size());
    smaller.swap(slots_);
    --shift_;
    for (const Slot& old : smaller) {
      if (old.key != kNoKey) insert(old);
    }
  }
  Heads& heads = heads_.emplace_back();
  heads.fill(kEmpty);
  insert({key_of(x, y), 0, &heads, tile});
  return slots_[static_cast<std::size_t>(&find(x, y) - slots_.data())];
}

std::uint32_t CellTiles::replace_head(Cell cell, std::uint32_t item) {
  Slot& slot = find_or_make(cell.x >> 3, cell.y >> 3);
  const std::uint64_t bit = std::uint64_t{1} << bit_of(cell);
  slot.occupied = item == kEmpty ? slot.occupied & ~bit : slot.occupied | bit;
  return std::exchange((*slot.heads)[bit_of(cell)], item);
}

}  // namespace voronaut
