#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "voronaut/environments/shapes/geometry.h"
#include "voronaut/reports/trace/trace.h"

namespace voronaut {

// What a replay has room for: about 40 kB.
constexpr std::size_t kMostTraceEdges = 5000;

// What the searches of a trial looked at, as a replay shows it: an edge that is in several searches
// after each other is one entry. Searches are kept whole, the first ones, as long as there are no
// more than `most_edges` entries: what it takes is bounded, however many and large they are. Places
// are rounded to a centimetre.
class SearchHistory {
 public:
  explicit SearchHistory(std::size_t most_edges = kMostTraceEdges) : most_edges_(most_edges) {}

  // From now on add() only counts: nobody need ask a planner for its edges.
  bool full() const { return full_; }
  void add(std::span<const Segment> edges);
  int searches() const { return searches_; }

  // Fills edges, searches and kept_searches.
  void write_to(Trace& trace) const;

 private:
  using EdgeKey = std::array<std::int64_t, 4>;  // the ends in centimetres
  static EdgeKey key_of(const Segment& edge);

  std::size_t most_edges_;
  bool full_ = false;
  int searches_ = 0;
  int kept_searches_ = 0;
  std::vector<TraceEdge> edges_;
  std::map<EdgeKey, std::size_t> entry_of_;  // in the search before: index into edges_
};

}  // namespace voronaut
