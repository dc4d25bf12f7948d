#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "voronaut/benchmarks/runner/run_trial.h"
#include "voronaut/benchmarks/runner/runner.h"
#include "voronaut/benchmarks/suite/suite_trials.h"
#include "voronaut/environments/config/config_node.h"

// Governed flights where room is short: between a wall and the bounds, and beside a wall from the
// start on.
namespace voronaut {
namespace {

std::vector<RunRecord> flown(const std::string& scenarios, const std::string& vehicles,
                             const std::string& planners) {
  const PlannerCatalog catalog = PlannerCatalog::built_in();
  const SuiteConfig suite =
      read_suite(ConfigNode::parse("suite: tight\nscenarios:\n" + scenarios +
                                       "vehicles: " + vehicles + "\nplanners: " + planners +
                                       "\nmapping: {merge_distance_m: 0.64}\ntraces: none\n"
                                       "navigation: {governor: true, look_around: true, "
                                       "recovery: true, yaw_policy: path}\n",
                                   "tight.yaml"),
                 "", catalog);
  const FlyTrial fly = [&](const TrialSpec& spec, bool keep_trace) {
    return run_trial(spec, catalog, keep_trace);
  };
  ShortestReferences references = ShortestReferences::exact();
  SuiteTrials trials(suite);
  std::vector<RunRecord> records;
  while (auto trial = trials.next()) {
    references.add_to(trial->spec);
    records.push_back(run_alone(trial->spec, suite.limits, fly));
  }
  return records;
}

const std::string kSmall =
    "[{name: ideal, params: {body_radius_m: 0.2, planning_clearance_m: 0.32, max_speed_m_s: 1}}]";

// The way beside the wall is 0.06 and 0.14 m wide for the centre: what the bounds leave is room.
TEST(TightWay, BetweenAWallAndTheBoundsIsFlown) {
  const auto records = flown(
      "  - {name: below, world: {boxes: [[3, 0.38, 3.4, 3]]}, bounds: [[0, 0], [6, 3]],"
      " start: [1, 1.5], goal: [5, 1.5]}\n"
      "  - {name: above, world: {boxes: [[3, 0, 3.4, 2.54]]}, bounds: [[0, 0], [6, 3]],"
      " start: [1, 1.5], goal: [5, 1.5]}\n",
      kSmall, "[VoronoiRoadmap, RRTConnect]");
  ASSERT_EQ(records.size(), 4U);
  for (const RunRecord& r : records) {
    EXPECT_EQ(r.outcome, Outcome::goal_reached)
        << r.scenario << " " << r.planner << ": " << r.reason;
    EXPECT_GT(r.shortest_at_clearance_m, 4) << "and the reference says so";
  }
}

// Reactive planners aim at the bounds themselves where a wall goes on beyond them.
TEST(TightWay, AlongTheBoundsIsNotLeft) {
  const auto records = flown(
      "  - {name: corner, world: {boxes: [[2, -1, 2.4, 2.3]]}, bounds: [[0, 0], [5, 3]],"
      " start: [0.5, 0.3], goal: [4.5, 0.3]}\n"
      "  - {name: on_the_edge, world: {circles: [[2.5, 0.2, 0.3]]}, bounds: [[0, 0], [5, 3]],"
      " start: [0.4, 0], goal: [4.5, 0]}\n",
      kSmall,
      "[{name: ReactiveVoronoi, label: published, params: {preset: as_published}},"
      " {name: ReactiveVoronoi, label: repaired, params: {preset: repaired}}, RRTConnect]");
  ASSERT_EQ(records.size(), 6U);
  for (const RunRecord& r : records) {
    EXPECT_NE(r.outcome, Outcome::out_of_bounds) << r.scenario << " " << r.planner << r.reason;
    EXPECT_NE(r.outcome, Outcome::collision) << r.scenario << " " << r.planner << r.reason;
  }
}

// Walls begin a tenth of a millimetre, or a few, beside the body, on one side or on two.
TEST(TightStart, BesideAWallEndsWithoutAContact) {
  std::string scenarios;
  for (const std::string gap : {"0.2001", "0.2003", "0.203", "0.21", "0.24"}) {
    scenarios += "  - {name: one_" + gap + ", world: {boxes: [[-3, -1, -" + gap +
                 ", 2]]}, bounds: [[-4, -3], [6, 3]], start: [0, 0], goal: [-3.5, 0]}\n";
    scenarios += "  - {name: two_" + gap + ", world: {boxes: [[-3, -1, -" + gap +
                 ", 2], [-1, -1.4, 1.5, -" + gap +
                 "]]}, bounds: [[-4, -3], [6, 3]], start: [0, 0], goal: [1, -2.5]}\n";
  }
  const auto records = flown(scenarios, kSmall, "[VoronoiRoadmap, RRTConnect]");
  ASSERT_EQ(records.size(), 20U);
  for (const RunRecord& r : records) {
    EXPECT_NE(r.outcome, Outcome::collision) << r.scenario << " " << r.planner << ": " << r.reason;
    EXPECT_GE(r.clearance_smallest_m, 0.2) << r.scenario << " " << r.planner;
  }
}

}  // namespace
}  // namespace voronaut
