#include "voronaut/reports/figures/figure_extent.h"

#include <algorithm>

namespace voronaut {

namespace {

constexpr double kMargin_m = 1.0;

void include(FigureExtent& extent, double x_m, double y_m, double around_m) {
  extent.minimum = {std::min(extent.minimum.x_m, x_m - around_m),
                    std::min(extent.minimum.y_m, y_m - around_m)};
  extent.maximum = {std::max(extent.maximum.x_m, x_m + around_m),
                    std::max(extent.maximum.y_m, y_m + around_m)};
}

template <class Points>
void include_all(FigureExtent& extent, const Points& points) {
  for (const auto& p : points) {
    include(extent, p.x_m, p.y_m, kMargin_m);
  }
}

}  // namespace

FigureExtent extent_of(const FigurePanel& panel) {
  const TraceWorld& w = panel.world;
  FigureExtent extent{w.start, w.start};
  include_all(extent, std::array{w.start, w.goal});
  for (const auto& [x_m, y_m, radius_m] : w.circles) {
    include(extent, x_m, y_m, radius_m + kMargin_m);
  }
  for (const auto& polygon : w.polygons) {
    include_all(extent, polygon);
  }
  for (const auto& segment : w.segments) {
    include_all(extent, segment);
  }
  extent.minimum = {std::max(extent.minimum.x_m, w.bounds_min.x_m),
                    std::max(extent.minimum.y_m, w.bounds_min.y_m)};
  extent.maximum = {std::min(extent.maximum.x_m, w.bounds_max.x_m),
                    std::min(extent.maximum.y_m, w.bounds_max.y_m)};
  for (const FigureTrack& track : panel.tracks) {
    for (const TraceFrame& frame : track.trace.frames) {
      include(extent, frame.x_m, frame.y_m, 0.0);
    }
  }
  return extent;
}

}  // namespace voronaut
