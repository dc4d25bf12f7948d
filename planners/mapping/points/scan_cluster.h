#pragma once

#include <cstdint>
#include <span>

#include "voronaut/environments/shapes/geometry.h"

namespace voronaut {

using PointId = std::uint32_t;
using ClusterId = std::uint32_t;
inline constexpr ClusterId kNoCluster = 0xffff'ffff;

// One cluster of the latest scan, its points in the order of their bearing (right to left). The
// points are returns of this scan, known ones included, thinned along the scan: a return closer
// than the thinning distance (or half of the link distance, if that is less) to the one listed
// before it is left out. Where the fan is a full circle there is no rightmost beam: a cluster then
// begins behind its widest gap in bearing.
struct ScanCluster {
  std::span<const Vec2> points_world;  // valid until the next scan
  // Begins at the right edge of the field of view (at the first beam that measured): its true
  // extreme is unseen. Never in a full circle.
  bool cut_right = false;
  bool cut_left = false;  // ends at the left edge
  ClusterId cluster = 0;  // the cluster of the base it belongs to now
};

}  // namespace voronaut
