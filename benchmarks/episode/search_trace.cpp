#include "voronaut/benchmarks/episode/search_trace.h"

#include <array>
#include <cmath>
#include <map>

namespace voronaut {

namespace {

using EdgeKey = std::array<std::int64_t, 4>;  // the ends in centimetres

constexpr double kPerMetre = 100;

EdgeKey key_of(const Segment& edge) {
  EdgeKey key{std::llround(edge.a.x() * kPerMetre), std::llround(edge.a.y() * kPerMetre),
              std::llround(edge.b.x() * kPerMetre), std::llround(edge.b.y() * kPerMetre)};
  const bool turned = std::pair{key[2], key[3]} < std::pair{key[0], key[1]};
  if (turned) key = {key[2], key[3], key[0], key[1]};
  return key;
}

TracePoint point(std::int64_t x, std::int64_t y) {
  return {static_cast<double>(x) / kPerMetre, static_cast<double>(y) / kPerMetre};
}

}  // namespace

void add_searches(const std::vector<std::vector<Segment>>& searches, Trace& trace,
                  std::size_t most_edges) {
  trace.searches = static_cast<int>(searches.size());
  std::map<EdgeKey, std::size_t> entry_of;  // in the search before: index into trace.edges
  for (int search = 0; search < trace.searches; ++search) {
    std::map<EdgeKey, std::size_t> here;
    const std::size_t before = trace.edges.size();
    for (const Segment& edge : searches[static_cast<std::size_t>(search)]) {
      const EdgeKey key = key_of(edge);
      const auto known = entry_of.find(key);
      const auto [entry, added] =
          here.try_emplace(key, known == entry_of.end() ? trace.edges.size() : known->second);
      if (!added || known != entry_of.end()) continue;
      trace.edges.push_back({point(key[0], key[1]), point(key[2], key[3]), search, search});
    }
    if (trace.edges.size() > most_edges) {
      trace.edges.resize(before);
      return;
    }
    for (const auto& [key, entry] : here) trace.edges[entry].last_search = search;
    trace.kept_searches = search + 1;
    entry_of = std::move(here);
  }
}

}  // namespace voronaut
