#include "voronaut/benchmarks/suite/suite_trials.h"

#include <algorithm>
#include <map>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "voronaut/benchmarks/trial/sha256.h"
#include "voronaut/benchmarks/trial/trial_id.h"
#include "voronaut/environments/scenario_files/scenario_reader.h"
#include "voronaut/environments/world.h"
#include "voronaut/tests/benchmarks/small_suite.h"

namespace voronaut {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

std::vector<TrialSpec> all_trials(const SuiteConfig& suite) {
  std::vector<TrialSpec> list;
  SuiteTrials trials(suite);
  while (auto planned = trials.next()) list.push_back(std::move(planned->spec));
  EXPECT_EQ(list.size(), trials.total());
  return list;
}

TEST(SuiteTrials, GiveEveryPlannerTheSameWorldAndItsOwnSeed) {
  std::map<std::pair<std::string, std::int64_t>, std::set<std::string>> worlds;
  std::set<std::uint64_t> seeds;
  const auto trials = all_trials(small_suite("s", {"a", "b"}, 3));
  for (const TrialSpec& trial : trials) {
    worlds[{trial.scenario.name, trial.repetition}].insert(trial.world_id);
    seeds.insert(trial.planner_seed);
  }
  for (const auto& [key, ids] : worlds) EXPECT_EQ(ids.size(), 1U) << key.first;
  EXPECT_EQ(seeds.size(), trials.size());
  EXPECT_EQ(worlds.at({"open", 0}), worlds.at({"open", 2})) << "a fixed world is the same";
  EXPECT_NE(worlds.at({"wood", 0}), worlds.at({"wood", 2})) << "a random one is drawn anew";
}

TEST(SuiteTrials, LeaveACartOnTheGround) {
  SuiteConfig suite = small_suite("s", {"a"});
  VehicleEntry cart = suite.vehicles.front();
  cart.vehicle = find_vehicle("cart");
  suite.vehicles.push_back(cart);
  for (const TrialSpec& trial : all_trials(suite)) {
    EXPECT_EQ(trial.scenario.cruise_height_m, trial.vehicle.name == "cart" ? 0 : 1);
    EXPECT_EQ(trial.scenario.start_height_m, 0);
  }
}

TEST(SuiteTrials, DoNotChangeWhenOtherPlannersOrRepetitionsJoin) {
  std::set<std::string> many;
  for (const TrialSpec& trial : all_trials(small_suite("s", {"b", "a", "c"}, 3)))
    many.insert(trial.trial_id);
  EXPECT_EQ(many.size(), 18U);
  for (const TrialSpec& trial : all_trials(small_suite("s", {"a"}, 2)))
    EXPECT_TRUE(many.contains(trial.trial_id)) << trial.scenario.name;
}

TEST(SuiteTrials, HaveOtherIdsWhenAnythingThatDefinesThemChanges) {
  const SuiteConfig base = small_suite("s", {"a"});
  std::set<std::string> ids = {all_trials(base).front().trial_id};
  const auto expect_new = [&](const char* what, const auto& change) {
    SuiteConfig changed = base;
    change(changed);
    EXPECT_TRUE(ids.insert(all_trials(changed).front().trial_id).second) << what;
  };
  expect_new("suite", [](SuiteConfig& s) { s.name = "t"; });
  expect_new("seed", [](SuiteConfig& s) { s.seed = 8; });
  expect_new("radius", [](SuiteConfig& s) { s.vehicles[0].vehicle.body_radius_m = 0.26; });
  expect_new("limits", [](SuiteConfig& s) { s.vehicles[0].vehicle.limits.max_speed_m_s = 1; });
  expect_new("regulator", [](SuiteConfig& s) { s.vehicles[0].regulator = PaperLiteralConfig{}; });
  expect_new("model", [](SuiteConfig& s) { s.vehicles[0].vehicle.model = IdealConfig{}; });
  expect_new("label", [](SuiteConfig& s) { s.planners[0].label = "z"; });
  expect_new("planner", [](SuiteConfig& s) { s.planners[0].name = "RRT"; });
  expect_new("params", [](SuiteConfig& s) { s.planners[0].params["range"] = "1"; });
  expect_new("range finder", [](SuiteConfig& s) { s.flight.range_finder.rays = 90; });
  expect_new("mapping", [](SuiteConfig& s) { s.flight.mapping.merge_distance_m = 0.7; });
  expect_new("navigation", [](SuiteConfig& s) { s.flight.navigation.off_path_m = 0.6; });
  expect_new("loop", [](SuiteConfig& s) { s.flight.loop.goal_hold_s = 2; });
  expect_new("budget", [](SuiteConfig& s) { s.flight.budget.state_checks = 5; });
  SuiteConfig harmless = base;
  harmless.limits.process.wall_s = 99;
  harmless.traces = TraceKeeping::none;
  EXPECT_TRUE(ids.contains(all_trials(harmless).front().trial_id));
}

// What is held is the form of the text; the values are those of the configs, and the golden digest
// of the whole program holds them.
TEST(TrialId, IsTheHashOfATextThatSaysEverything) {
  const TrialSpec trial = all_trials(small_suite("golden", {"a"})).front();
  EXPECT_EQ(canonical_world(trial.scenario),
            "bounds -1,-1 6,6\ncircle 2,2 0.5\nstart 0,0\ngoal 5,5\n");
  const std::string world = "57500416e3d720194907c44cd3135c7e195f5393b69447bb1c85c97501aaa0a0";
  EXPECT_EQ(trial.world_id, world);
  EXPECT_EQ(trial.planner_seed, 4417673679995516535U);
  const std::string text = canonical_trial(trial);
  EXPECT_THAT(text,
              StartsWith("trial: suite=golden;scenario=open;group=open;world_id=" + world +
                         ";start_height_m=0;cruise_height_m=1;start_heading=0.7071067811865475,"
                         "0.7071067811865475;goal_tolerance_m=0.2;vehicle=quadrotor;regulator=pd_"
                         "rate;planner=a;planner_name=RRTConnect;repetition=0;planner_seed="
                         "4417673679995516535;\n"
                         "params: \nvehicle: body_radius_m=0.25;planning_clearance_m=0.31;"));
  for (const char* section : {"model", "regulator", "flight"})
    EXPECT_THAT(text, HasSubstr("\n" + std::string(section) + ": "));
  for (const char* section : {"range_finder", "mapping", "navigation", "loop", "budget"})
    EXPECT_THAT(text, HasSubstr(std::string(section) + "."));
  EXPECT_EQ(trial.trial_id, sha256_hex(text));
}

TEST(TrialId, NamesEveryKindOfShape) {
  Scenario scenario;
  Shapes shapes;
  shapes.circles.push_back({{1, 2}, 0.1});
  shapes.segments.push_back({{0, 0.5}, {1, 1}});
  shapes.polygons.push_back({{{3, 3}, {4, 3}, {4, 4}}});
  scenario.world = std::make_shared<const World>(Bounds{{0, 0}, {5, 5}}, shapes);
  EXPECT_EQ(canonical_world(scenario),
            "bounds 0,0 5,5\ncircle 1,2 0.1\nsegment 0,0.5 1,1\npolygon 3,3 4,3 4,4\n"
            "start 0,0\ngoal 0,0\n");
}

TEST(SuiteTrials, KeepTheirPlaceWhenNoWorldCanBeDrawn) {
  SuiteConfig suite = small_suite("s", {"a"});
  const std::string impossible =
      "name: full\ngenerator: {name: forest, side_m: 6, density_per_m2: 1, draws_max: 1}\n"
      "group: g\n";
  suite.scenarios = read_scenarios(ConfigNode::parse(impossible, "full.yaml"), {});
  SuiteTrials trials(suite);
  const auto planned = trials.next();
  ASSERT_TRUE(planned);
  EXPECT_EQ(planned->refusal, "the generator drew no admissible world");
  EXPECT_EQ(planned->spec.scenario.name, "full");
  EXPECT_THROW(SuiteTrials::check_worlds(suite), ConfigError);
}

TEST(SuiteTrials, DoNotMakeARandomWorldThatTheRehearsalWarnsOf) {
  const SuiteConfig suite = small_suite("s", {"a"}, 2);
  int rehearsed = 0;
  SuiteTrials trials(suite, [&](const std::function<void()>& work) {
    work();
    return ++rehearsed == 1 ? "" : "it is deadly";
  });
  std::map<std::pair<std::string, std::int64_t>, std::string> refusals;
  while (const auto planned = trials.next()) {
    refusals[{planned->spec.scenario.name, planned->spec.repetition}] = planned->refusal;
    EXPECT_EQ(planned->spec.world_id.empty(), !planned->refusal.empty());
  }
  EXPECT_EQ(rehearsed, 2) << "of the two worlds that are drawn";
  EXPECT_EQ(refusals.at({"open", 0}), "");
  EXPECT_EQ(refusals.at({"wood", 0}), "");
  EXPECT_EQ(refusals.at({"wood", 1}), "it is deadly");
}

TEST(SuiteTrials, FlyAScenarioWithOneWorldOnceIfOnlyRandomOnesRepeat) {
  SuiteConfig suite = small_suite("once", {"a"}, 3);
  const std::size_t all = SuiteTrials(suite).total();
  suite.repeat = Repeat::random;
  SuiteTrials trials(suite);
  const auto fixed = std::ranges::count_if(
      suite.scenarios, [](const ScenarioSpec& scenario) { return !scenario.random(); });
  ASSERT_GT(fixed, 0);
  EXPECT_EQ(trials.total(), all - 2 * static_cast<std::size_t>(fixed));
  std::size_t flown = 0;
  while (trials.next()) ++flown;
  EXPECT_EQ(flown, trials.total());
}

}  // namespace
}  // namespace voronaut
