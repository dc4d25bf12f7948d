#include "voronaut/planners/mapping/cell_tiles.h"

#include <utility>

namespace voronaut {
namespace {

constexpr int kFirstSlotsLog2 = 6;

}  // namespace

CellTiles::CellTiles(double cell_m)
    : grid_(cell_m), shift_(64 - kFirstSlotsLog2), slots_(std::size_t{1} << kFirstSlotsLog2) {}

void CellTiles::insert(const Slot& slot) {
  const std::size_t place = static_cast<std::size_t>(
      &find(static_cast<std::uint32_t>(slot.key >> 32), static_cast<std::uint32_t>(slot.key)) -
      slots_.data());
  slots_[place] = slot;
}

CellTiles::Slot& CellTiles::make(std::uint32_t x, std::uint32_t y) {
  if (2 * ++tiles_ > slots_.size()) {
    std::vector<Slot> smaller(2 * slots_.size());
    smaller.swap(slots_);
    --shift_;
    for (const Slot& old : smaller) {
      if (old.key != kNoKey) insert(old);
    }
  }
  insert({key_of(x, y), 0, kEmpty});
  return slots_[static_cast<std::size_t>(&find(x, y) - slots_.data())];
}

void CellTiles::make_heads(Slot& slot) {
  slot.tile = heads_.size();
  heads_.emplace_back().fill(kEmpty);
}

std::uint32_t CellTiles::replace_head(Cell cell, std::uint32_t item) {
  Slot& slot = find_or_make(cell.x >> 3, cell.y >> 3);
  if (slot.tile == kEmpty) make_heads(slot);
  const std::uint64_t bit = std::uint64_t{1} << bit_of(cell);
  slot.occupied = item == kEmpty ? slot.occupied & ~bit : slot.occupied | bit;
  return std::exchange(heads_[slot.tile][bit_of(cell)], item);
}

}  // namespace voronaut
