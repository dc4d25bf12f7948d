#include <algorithm>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "voronaut/benchmarks/runner/run_trial.h"
#include "voronaut/benchmarks/runner/runner.h"
#include "voronaut/benchmarks/suite/suite_trials.h"
#include "voronaut/environments/config/config_node.h"

// The cart paper's five situations, as the shipped suite drives them.
namespace voronaut {
namespace {

class CartPaperScenes : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    const PlannerCatalog planners = PlannerCatalog::built_in();
    const SuiteConfig suite =
        read_suite(ConfigNode::read_file(
                       std::string(VORONAUT_SOURCE_DIR "/benchmarks/suites/cart-paper.yaml")),
                   "", planners);
    const FlyTrial fly = [&](const TrialSpec& spec, bool keep_trace) {
      return run_trial(spec, planners, keep_trace);
    };
    ShortestReferences references = ShortestReferences::exact();
    SuiteTrials trials(suite);
    while (auto trial = trials.next()) {
      references.add_to(trial->spec);
      records.push_back(run_alone(trial->spec, suite.limits, fly));
    }
  }

  static std::vector<RunRecord> of(const std::string& planner,
                                   const std::string& vehicle = "cart") {
    std::vector<RunRecord> found;
    std::ranges::copy_if(records, std::back_inserter(found), [&](const RunRecord& r) {
      return r.planner == planner && r.vehicle == vehicle;
    });
    EXPECT_EQ(found.size(), 5U) << planner;
    return found;
  }

  static inline std::vector<RunRecord> records;
};

TEST_F(CartPaperScenes, EveryPlannerArrivesWithoutAContactButTheOneAsPublished) {
  for (const RunRecord& r : records) {
    if (r.planner == "as_published") continue;
    EXPECT_EQ(r.outcome, Outcome::goal_reached)
        << r.scenario << " " << r.planner << ": " << r.reason;
    EXPECT_GT(r.clearance_smallest_m, 0.36) << r.scenario << " " << r.planner;
  }
}

TEST_F(CartPaperScenes, ThePapersPlannerKeepsThePapersClearanceAndMeanSpeed) {
  for (const char* planner : {"published_offset", "repaired"}) {
    for (const RunRecord& r : of(planner)) {
      EXPECT_GE(r.clearance_smallest_m, 0.44) << r.scenario << " " << planner;
      EXPECT_NEAR(r.speed_mean_m_s, 1.19, 0.025) << r.scenario << " " << planner;
      EXPECT_LT(r.path_ratio, 1.1) << r.scenario << " " << planner;
    }
  }
}

TEST_F(CartPaperScenes, EachSceneGoesThroughTheModeItIsNamedAfter) {
  const std::map<std::string, std::vector<std::string>> expected{
      {"cart-between", {"between"}},
      {"cart-left", {"none", "left"}},
      {"cart-right", {"none", "right"}},
      {"cart-near-goal", {"none", "right"}},
      {"cart-even", {"left", "between", "right"}}};
  for (const char* planner : {"published_offset", "repaired"}) {
    for (const RunRecord& r : of(planner)) {
      const std::string modes = " " + r.modes + " ";
      for (const std::string& mode : expected.at(r.scenario))
        EXPECT_NE(modes.find(" " + mode + " "), std::string::npos)
            << r.scenario << " " << planner << " went through:" << modes;
    }
  }
}

TEST_F(CartPaperScenes, TheOffsetAsPrintedIsWhatFailsWhateverDrives) {
  for (const char* vehicle : {"cart", "point_mass"}) {
    for (const RunRecord& r : of("as_published", vehicle))
      EXPECT_EQ(r.outcome,
                r.scenario == "cart-between" ? Outcome::goal_reached : Outcome::collision)
          << r.scenario << " " << vehicle;
  }
}

}  // namespace
}  // namespace voronaut
