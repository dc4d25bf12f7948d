#include "voronaut/reports/summary/ranks.h"

#include <vector>

#include "voronaut/reports/summary/significance.h"

namespace voronaut {

namespace {

int sign_of(std::int64_t a, std::int64_t b) { return (a > b) - (a < b); }

}  // namespace

int better_of(const PlannerPairing& p) {
  if (p.success_p_holm < kRankLevel) return sign_of(p.only_a, p.only_b);
  if (p.path_p_holm < kRankLevel) return sign_of(p.shorter_a(), p.shorter_b());
  return 0;
}

void rank_planners(std::span<PlannerSummary> planners, std::span<PlannerPairing> pairings) {
  std::vector<double> p_values;
  for (const PlannerPairing& p : pairings) {
    p_values.push_back(mcnemar_exact(p.only_a, p.only_b));
    p_values.push_back(mcnemar_exact(p.shorter_a(), p.shorter_b()));
  }
  const std::vector<double> corrected = holm_corrected(p_values);
  for (std::size_t i = 0; i < pairings.size(); ++i) {
    pairings[i].success_p_holm = corrected[2 * i];
    pairings[i].path_p_holm = corrected[2 * i + 1];
  }
  for (PlannerSummary& planner : planners) {
    planner.rank = 1;
    for (const PlannerPairing& p : pairings) {
      const int better = better_of(p);
      planner.rank += (better < 0 && p.planner_a == planner.planner) ||
                      (better > 0 && p.planner_b == planner.planner);
    }
  }
}

}  // namespace voronaut
