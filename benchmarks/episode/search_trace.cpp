#include "voronaut/benchmarks/episode/search_trace.h"

#include <cmath>
#include <utility>

namespace voronaut {

namespace {

constexpr double kPerMetre = 100;

TracePoint point(std::int64_t x, std::int64_t y) {
  return {static_cast<double>(x) / kPerMetre, static_cast<double>(y) / kPerMetre};
}

}  // namespace

SearchHistory::EdgeKey SearchHistory::key_of(const Segment& edge) {
  EdgeKey key{std::llround(edge.a.x() * kPerMetre), std::llround(edge.a.y() * kPerMetre),
              std::llround(edge.b.x() * kPerMetre), std::llround(edge.b.y() * kPerMetre)};
  const bool turned = std::pair{key[2], key[3]} < std::pair{key[0], key[1]};
  if (turned) key = {key[2], key[3], key[0], key[1]};
  return key;
}

void SearchHistory::add(std::span<const Segment> edges) {
  const int search = searches_++;
  if (full_) return;
  std::map<EdgeKey, std::size_t> here;
  const std::size_t before = edges_.size();
  for (const Segment& edge : edges) {
    const EdgeKey key = key_of(edge);
    const auto known = entry_of_.find(key);
    const auto [entry, added] =
        here.try_emplace(key, known == entry_of_.end() ? edges_.size() : known->second);
    if (!added || known != entry_of_.end()) continue;
    edges_.push_back({point(key[0], key[1]), point(key[2], key[3]), search, search});
    if (edges_.size() > most_edges_) {
      edges_.resize(before);
      entry_of_.clear();
      full_ = true;
      return;
    }
  }
  for (const auto& [key, entry] : here) edges_[entry].last_search = search;
  kept_searches_ = searches_;
  entry_of_ = std::move(here);
}

void SearchHistory::write_to(Trace& trace) const {
  trace.edges = edges_;
  trace.searches = searches_;
  trace.kept_searches = kept_searches_;
}

}  // namespace voronaut
