#include "voronaut/planners/mapping/near_filter.h"

namespace voronaut {

void NearFilter::mark_around(Cell occupied) {
  using namespace tile_masks;
  const Cell low{occupied.x - kNearCells, occupied.y - kNearCells};
  const Cell high{occupied.x + kNearCells, occupied.y + kNearCells};
  for (std::uint32_t y = low.y >> 3; y <= high.y >> 3; ++y) {
    for (std::uint32_t x = low.x >> 3; x <= high.x >> 3; ++x) {
      std::uint64_t marks = kAll;
      if (y == low.y >> 3) marks &= kRowsFrom[low.y & 7];
      if (y == high.y >> 3) marks &= kRowsUpTo[high.y & 7];
      if (x == low.x >> 3) marks &= kColumnsFrom[low.x & 7];
      if (x == high.x >> 3) marks &= kColumnsUpTo[high.x & 7];
      words_[word_of(x, y)] |= marks;
    }
  }
}

}  // namespace voronaut
