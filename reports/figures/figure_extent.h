#pragma once

#include "voronaut/reports/figures/svg_figure.h"

namespace voronaut {

struct FigureExtent {
  TracePoint minimum;
  TracePoint maximum;
};

// Everything that is there and a metre around it, but not the empty rest of the bounds; where a way
// left the bounds, that too.
FigureExtent extent_of(const FigurePanel& panel);

}  // namespace voronaut
