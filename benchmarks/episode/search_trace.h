#pragma once

#include <cstddef>
#include <vector>

#include "voronaut/environments/shapes/geometry.h"
#include "voronaut/reports/trace/trace.h"

namespace voronaut {

// What a replay has room for: about 40 kB.
constexpr std::size_t kMostTraceEdges = 5000;

// Fills the edges, searches and kept_searches of a trace: an edge that is in several searches after
// each other is one entry. Searches are kept whole, the first ones, as long as there are no more
// than `most_edges` entries. Places are rounded to a centimetre.
void add_searches(const std::vector<std::vector<Segment>>& searches, Trace& trace,
                  std::size_t most_edges = kMostTraceEdges);

}  // namespace voronaut
