#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <map>
#include <string>
#include <vector>

#include "voronaut/reports/summary/summary.h"

namespace voronaut {

// What a summary needs of each trial, about 140 bytes, so that a million of them need not be in
// memory as records.
class SummaryTable {
 public:
  void add(const RunRecord& record);
  std::int64_t size() const { return size_; }

  // O(resamples * trials), see estimate.h for very many.
  Summary summarise(const SummaryConfig& config = {}) const;

 private:
  // Of a trial, for pairing it with another planner's.
  struct Scene {
    std::uint32_t scenario;  // number in scenarios_
    bool reached;
    std::int64_t repetition;
    double path_ratio;

    bool before(const Scene& other) const {
      return scenario != other.scenario ? scenario < other.scenario : repetition < other.repetition;
    }
  };

  struct PlannerTrials {
    std::int64_t n = 0;
    OutcomeCounts outcomes{};
    std::vector<std::deque<double>> values;  // of each statistic; of a rate nothing
    std::vector<std::int64_t> successes;     // of each rate
    std::deque<Scene> scenes;

    void add(const PlannerTrials& other);
  };

  struct InNaturalOrder {
    bool operator()(const SummaryGroup& a, const SummaryGroup& b) const;
  };
  using Planners = std::map<std::string, PlannerTrials>;
  using Grouped = std::map<SummaryGroup, Planners, InNaturalOrder>;

  static PlannerSummary summary_of(const SummaryGroup& group, const std::string& planner,
                                   const PlannerTrials& trials, const BootstrapConfig& bootstrap);
  static PlannerPairing pairing_of(const SummaryGroup& group, const std::string& planner_a,
                                   const PlannerTrials& a, const std::string& planner_b,
                                   const PlannerTrials& b, double tie_tolerance);
  static int compare(const Scene& a, const Scene& b, double tie_tolerance);
  static void summarise_group(const SummaryGroup& group, const Planners& planners,
                              const SummaryConfig& config, std::vector<PlannerSummary>& summaries,
                              std::vector<PlannerPairing>& pairings);

  Grouped groups_;
  std::map<std::pair<std::string, std::string>, std::uint32_t> scenarios_;  // group, scenario
  std::int64_t size_ = 0;
};

}  // namespace voronaut
