#include "voronaut/environments/formats/query_selection.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "voronaut/environments/random.h"
#include "voronaut/environments/shortest_path/shortest_path.h"

namespace voronaut {
namespace {

constexpr std::size_t kPathsSoughtPerQuery = 3;

bool is_wanted(const ForeignQuery& query, const QuerySelection& selection, const World& world) {
  if (selection.bucket >= 0 && query.bucket != selection.bucket) return false;
  const double length_m = query.length_m > 0 ? query.length_m : (query.goal - query.start).norm();
  return length_m >= selection.shortest_m &&
         (selection.longest_m == 0 || length_m <= selection.longest_m) &&
         world.clearance_m(query.start) >= selection.clearance_m &&
         world.clearance_m(query.goal) >= selection.clearance_m;
}

bool has_path(const ForeignQuery& query, const QuerySelection& selection, const World& world) {
  return selection.clearance_m == 0 ||
         shortest_path(world, query.start, query.goal, selection.clearance_m).has_value();
}

}  // namespace

std::vector<ForeignQuery> select_queries(const std::vector<ForeignQuery>& queries,
                                         const QuerySelection& selection, const World& world,
                                         const std::string& map_name) {
  std::vector<std::size_t> order(queries.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const bool draws = selection.sample > 0;
  Random random(derive_seed(static_cast<std::uint64_t>(selection.seed), {"queries", map_name}, 0));
  const std::size_t wanted = draws ? static_cast<std::size_t>(selection.sample) : queries.size();
  std::vector<std::size_t> chosen;
  std::size_t paths_sought = 0;
  for (std::size_t i = 0; i < order.size() && chosen.size() < wanted; ++i) {
    if (draws) std::swap(order[i], order[i + random.below(order.size() - i)]);
    const ForeignQuery& query = queries[order[i]];
    if (!is_wanted(query, selection, world)) continue;
    if (draws && paths_sought++ == kPathsSoughtPerQuery * wanted) break;
    if (has_path(query, selection, world)) chosen.push_back(order[i]);
  }
  std::sort(chosen.begin(), chosen.end());
  std::vector<ForeignQuery> result;
  result.reserve(chosen.size());
  for (const std::size_t index : chosen) result.push_back(queries[index]);
  return result;
}

}  // namespace voronaut
