#include "voronaut/benchmarks/suite/suite_config.h"

#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "voronaut/environments/config/config_reader.h"
#include "voronaut/environments/config/nearest_name.h"
#include "voronaut/tests/benchmarks/small_suite.h"
#include "voronaut/tests/support/error_of.h"

namespace voronaut {
namespace {

SuiteConfig read(const std::string& text) {
  return read_suite(ConfigNode::parse(text, "s.yaml"), "", PlannerCatalog::built_in());
}

std::string error_in(const std::string& text) {
  return error_of<ConfigError>([&] { read(text); });
}

std::vector<std::string> planner_names() {
  std::vector<std::string> names;
  const PlannerCatalog catalog = PlannerCatalog::built_in();
  for (const PlannerEntry* entry : catalog.entries()) names.push_back(entry->name);
  return names;
}

std::vector<std::string> navigation_keys() { return key_names<NavigationConfig>(); }

// A suite that is right but for the part that is replaced.
std::string suite_with(const std::string& key, const std::string& value) {
  const std::vector<std::pair<std::string, std::string>> parts = {
      {"suite", "s"},
      {"scenarios",
       "[{name: open, world: {}, bounds: [[-1, -1], [6, 6]], start: [0, 0], goal: [5, 5]}]"},
      {"vehicles", "[quadrotor]"},
      {"planners", "[RRTConnect]"}};
  std::string text;
  bool replaced = false;
  for (const auto& [name, usual] : parts) {
    text += name + ": " + (name == key ? value : usual) + "\n";
    replaced = replaced || name == key;
  }
  return replaced ? text : text + key + ": " + value + "\n";
}

TEST(SuiteConfig, FillsInEveryDefault) {
  const SuiteConfig suite = read(suite_with("seed", "12"));
  EXPECT_EQ(suite.name, "s");
  EXPECT_EQ(suite.seed, 12U);
  EXPECT_EQ(suite.repetitions, 1);
  ASSERT_EQ(suite.vehicles.size(), 1U);
  EXPECT_EQ(suite.vehicles[0].regulator_name, "pd_rate");
  ASSERT_EQ(suite.planners.size(), 1U);
  EXPECT_EQ(suite.planners[0].label, "RRTConnect");
  EXPECT_EQ(suite.flight.range_finder.rays, 91);
  EXPECT_EQ(suite.flight.budget.state_checks, 50'000U);
  EXPECT_EQ(suite.limits.process.memory_mb, 1024);
  EXPECT_EQ(suite.traces, TraceKeeping::all);
}

TEST(SuiteConfig, ReadsEverySection) {
  const SuiteConfig suite = read(
      suite_with(
          "vehicles",
          "[{name: ideal, label: small, params: {body_radius_m: 0.2, planning_clearance_m: 0.3},"
          " model: {max_acceleration_m_s2: 2}, regulator: {name: ideal, params: {}}}]") +
      "range_finder: {rays: 5}\nmapping: {merge_distance_m: 0.6}\nnavigation: {yaw_policy: path}\n"
      "loop: {goal_hold_s: 2}\nbudget: {state_checks: 7, ptc_evaluations: 8}\n"
      "limits: {cpu_s: 3}\ntraces: none\nkind: flown\nrepetitions: 4\n");
  EXPECT_EQ(suite.vehicles[0].vehicle.name, "small");
  EXPECT_EQ(suite.vehicles[0].vehicle.body_radius_m, 0.2);
  EXPECT_EQ(std::get<IdealConfig>(suite.vehicles[0].vehicle.model).max_acceleration_m_s2, 2);
  EXPECT_EQ(suite.flight.range_finder.rays, 5);
  EXPECT_EQ(suite.flight.mapping.merge_distance_m, 0.6);
  EXPECT_EQ(suite.flight.navigation.yaw_policy, YawReference::path);
  EXPECT_EQ(suite.flight.loop.goal_hold_s, 2);
  EXPECT_EQ(suite.flight.budget.state_checks, 7U);
  EXPECT_EQ(suite.flight.budget.ptc_evaluations, 8U);
  EXPECT_EQ(suite.limits.process.cpu_s, 3);
  EXPECT_EQ(suite.traces, TraceKeeping::none);
  EXPECT_EQ(suite.repetitions, 4);
}

TEST(SuiteConfig, LetsAPlannerFlyWithANavigationOfItsOwn) {
  const SuiteConfig suite =
      read(suite_with("planners",
                      "[RRTConnect, {name: RRTConnect, label: b, navigation: {off_path_m: 2}}]") +
           "navigation: {yaw_policy: path}\n");
  EXPECT_FALSE(suite.planners[0].navigation);
  ASSERT_TRUE(suite.planners[1].navigation);
  EXPECT_EQ(suite.planners[1].navigation->off_path_m, 2);
  EXPECT_EQ(suite.planners[1].navigation->yaw_policy, YawReference::path)
      << "the rest is the suite's";
}

std::string navigation_of(const SuiteConfig& suite, std::size_t planner) {
  return canonical_text(flight_of(suite, suite.vehicles[0], suite.planners[planner]).navigation);
}

TEST(SuiteConfig, IsCarefulUnlessItSaysOtherwise) {
  const SuiteConfig suite = read(suite_with("planners", "[RRTConnect]"));
  const NavigationConfig& navigation = suite.flight.navigation;
  EXPECT_TRUE(navigation.governor && navigation.look_around && navigation.recovery);
  EXPECT_EQ(navigation.yaw_policy, YawReference::path);
  EXPECT_EQ(navigation_of(read(suite_with("navigation", "careful")), 0), navigation_of(suite, 0));
}

TEST(SuiteConfig, APresetSaysEveryKeyAndOthersHoldOverIt) {
  NavigationConfig paper = NavigationConfig::paper();
  EXPECT_FALSE(paper.governor || paper.look_around || paper.recovery);
  EXPECT_EQ(paper.yaw_policy, YawReference::fixed);
  EXPECT_EQ(navigation_of(read(suite_with("navigation", "paper")), 0), canonical_text(paper));
  paper.recovery = true;
  EXPECT_EQ(navigation_of(read(suite_with("navigation", "{recovery: true, preset: paper}")), 0),
            canonical_text(paper));
}

TEST(SuiteConfig, APresetOfAPlannerLeavesNothingOfTheSuites) {
  const SuiteConfig suite =
      read(suite_with("planners", "[RRTConnect, {name: RRTConnect, label: b, navigation: paper}]") +
           "navigation: {off_path_m: 2}\n");
  EXPECT_EQ(navigation_of(suite, 1), canonical_text(NavigationConfig::paper()));
  EXPECT_EQ(suite.flight.navigation.off_path_m, 2);
}

TEST(SuiteConfig, ReadsWhatASuiteMustShow) {
  const SuiteConfig suite =
      read(suite_with("acceptance", "[{planner: RRTConnect, goal_reached_share_min: 0.9}, {}]"));
  ASSERT_EQ(suite.acceptance.size(), 2U);
  EXPECT_EQ(suite.acceptance[0].planner, "RRTConnect");
  EXPECT_EQ(suite.acceptance[0].bounds.front(), 0.9);
}

TEST(SuiteConfig, PassesFlagsToPlannersAsTheyWantThem) {
  const SuiteConfig suite = read(suite_with(
      "planners", "[{name: RRTConnect, params: {intermediate_states: true, range: 2}}]"));
  EXPECT_EQ(suite.planners[0].params.at("intermediate_states"), "1");
  EXPECT_EQ(suite.planners[0].params.at("range"), "2");
}

TEST(SuiteConfig, ReadsEachWayToCountABudget) {
  using Counts = PlanningBudget::Counts;
  const auto budget = [](const std::string& text) {
    return read(suite_with("budget", text)).flight.budget;
  };
  EXPECT_EQ(budget("{stop: first}").counts, Counts::state_checks);
  EXPECT_EQ(budget("{stop: first}").stop, PlanningBudget::Stop::first);
  EXPECT_EQ(budget("{iterations: 12}").counts, Counts::iterations);
  EXPECT_EQ(budget("{iterations: 12}").iterations, 12U);
  EXPECT_EQ(budget("{iterations: 12}").stop, PlanningBudget::Stop::budget);
  EXPECT_EQ(budget("{wall_clock_s: 0.5}").counts, Counts::wall_clock);
  EXPECT_EQ(budget("{wall_clock_s: 0.5}").wall_clock_s, 0.5);
  EXPECT_EQ(error_in(suite_with("budget", "{state_checks: 5, wall_clock_s: 1}")),
            "s.yaml:5: key 'budget.wall_clock_s': cannot stand beside state_checks (allowed: "
            "state_checks with ptc_evaluations, or iterations, or wall_clock_s)");
  EXPECT_EQ(error_in(suite_with("budget", "{stop: last}")),
            "s.yaml:5: key 'budget.stop': expected one of first, budget, got 'last'");
}

TEST(SuiteConfig, AdmitsWorldsForTheVehicleThatKeepsMost) {
  const auto definition = [](const std::string& vehicles, const std::string& generator) {
    return read("suite: s\nscenarios: [{generator: {name: walls" + generator + "}}]\nvehicles: [" +
                vehicles + "]\nplanners: [RRTConnect]\n")
        .scenarios[0]
        .definition();
  };
  const std::string two =
      "{name: ideal, params: {planning_clearance_m: 0.3}}, "
      "{name: quadrotor, params: {planning_clearance_m: 0.36}}";
  EXPECT_EQ(definition(two, ""), definition("ideal", ", admission_clearance_m: 0.378"));
  EXPECT_NE(definition(two, ""), definition("ideal", ""));
}

TEST(SuiteConfig, SaysInOneLineWhatIsWrong) {
  unsetenv("VORONAUT_DATA");  // one of the messages is about its absence
  const std::string keys =
      "include, suite, kind, seed, repetitions, repeat, data, scenarios, vehicles, planners, "
      "sweep, range_finder, "
      "mapping, navigation, loop, budget, disturbances, declared_errors, limits, traces, "
      "acceptance";
  const std::string count = "expected a whole number from ";
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"", "s.yaml:1: the file is empty"},
      {"just text", "s.yaml:1: expected a map of keys, got 'just text'"},
      {suite_with("seeed", "1"),
       "s.yaml:5: key 'seeed': unknown key (allowed: " + keys + "; did you mean 'seed'?)"},
      {"scenarios: []", "s.yaml:1: key 'suite': missing"},
      {"suite: s\nvehicles: [quadrotor]\nplanners: [RRTConnect]",
       "s.yaml:1: key 'scenarios': missing"},
      {"suite: s\nplanners: [RRTConnect]", "s.yaml:1: key 'vehicles': missing"},
      {suite_with("suite", "../s"),
       "s.yaml:1: key 'suite': expected a name of at most 100 letters, digits, '-', '_' and '.', "
       "got '../s'"},
      {suite_with("suite", ""), "s.yaml:1: key 'suite': expected text, got nothing"},
      {suite_with("suite", "[a]"), "s.yaml:1: key 'suite': expected text, got a list of 1"},
      {suite_with("kind", "parked"),
       "s.yaml:5: key 'kind': expected one of flown, static, got 'parked'"},
      {suite_with("kind", "known"), "s.yaml:5: key 'kind': 'known' is now 'static'"},
      {suite_with("seed", "-1"),
       "s.yaml:5: key 'seed': " + count + "0 to 9223372036854775807, got '-1'"},
      {suite_with("seed", "1.5"),
       "s.yaml:5: key 'seed': " + count + "0 to 9223372036854775807, got '1.5'"},
      {suite_with("repetitions", "0"),
       "s.yaml:5: key 'repetitions': " + count + "1 to 1000000, got '0'"},
      {suite_with("scenarios", "[]"),
       "s.yaml:2: key 'scenarios': expected at least one entry, got none"},
      {suite_with("scenarios", "forest"),
       "s.yaml:2: key 'scenarios': expected a list, got 'forest'"},
      {suite_with("scenarios", "[{file: missing.yaml}]"),
       "s.yaml:2: key 'scenarios[0].file': no file 'missing.yaml'"},
      {suite_with("scenarios", "[{name: a, generator: {name: forst}}]"),
       "s.yaml:2: key 'scenarios[0].generator.name': expected one of forest, paper_scene, "
       "goal_side, grid, walls, u_trap, bug_trap, spiral, rooms, maze, braided_maze, narrow_gaps, "
       "thin_posts, enclosed_goal, got 'forst' (did you mean 'forest'?)"},
      {suite_with("scenarios",
                  "[{name: a, generator: {name: forest}}, {name: a, generator: {name: forest}}]"),
       "s.yaml:2: key 'scenarios[1]': the name 'a' is taken (line 2); give this one another name"},
      {suite_with("scenarios",
                  "[{name: a, world: {}, bounds: [[0, 0], [1, 1]], start: [0.5, 0.5], goal: [2, "
                  "2]}]"),
       "s.yaml:2: key 'scenarios[0].goal': (2, 2) lies outside the bounds (0, 0) to (1, 1)"},
      {suite_with("scenarios", "[{dataset: barn}]"),
       "s.yaml:2: key 'scenarios[0].dataset': 'barn' lies in the data folder, which is not known: "
       "give --data DIR or set VORONAUT_DATA"},
      {suite_with("vehicles", "[]"),
       "s.yaml:3: key 'vehicles': expected at least one entry, got none"},
      {suite_with("vehicles", "[quadrotr]"),
       "s.yaml:3: key 'vehicles[0]': no vehicle 'quadrotr' (allowed: car, cart, ideal, jackal, "
       "quadrotor, quadrotor_props, unicycle; did you mean 'quadrotor'?)"},
      {suite_with("vehicles", "[quadrotor, quadrotor]"),
       "s.yaml:3: key 'vehicles[1]': the name 'quadrotor' is taken (line 3); give this one a "
       "label"},
      {suite_with("vehicles", "[{label: a}]"), "s.yaml:3: key 'vehicles[0].name': missing"},
      {suite_with("vehicles", "[{name: quadrotor, label: ''}]"),
       "s.yaml:3: key 'vehicles[0].label': expected a label of 1 to 200 bytes without line breaks "
       "or control characters, got 0 bytes, ''"},
      {suite_with("vehicles", "[{name: quadrotor, params: {body_radius_m: -1}}]"),
       "s.yaml:3: key 'vehicles[0].params.body_radius_m': expected a number from 0.001 to 10, got "
       "'-1'"},
      {suite_with("vehicles", "[{name: quadrotor, params: {planning_clearance_m: 0.2}}]"),
       "s.yaml:3: key 'vehicles[0]': planning_clearance_m 0.2 is less than body_radius_m 0.25"},
      {suite_with("vehicles", "[{name: quadrotor, params: {clearance_min_m: 0.4}}]"),
       "s.yaml:3: key 'vehicles[0].params.clearance_min_m': 'clearance_min_m' is now "
       "'planning_clearance_m'"},
      {suite_with("vehicles", "[{name: quadrotor, regulator: ideal}]"),
       "s.yaml:3: key 'vehicles[0].regulator': regulator 'ideal' drives the model ideal, which "
       "vehicle 'quadrotor' is not"},
      {suite_with("vehicles", "[{name: quadrotor, regulator: pid}]"),
       "s.yaml:3: key 'vehicles[0].regulator': no regulator 'pid' (allowed: arc_tracker, "
       "car_tracker, cascade_pid, ideal, lqr, paper_literal, pd_rate, position_trajectory, se3)"},
      {suite_with("planners", "[RRTConect]"),
       "s.yaml:4: key 'planners[0]': no planner 'RRTConect' (allowed: " +
           join_names(planner_names()) + "; did you mean 'RRTConnect'?)"},
      {suite_with("planners", "[RRTConnect, RRTConnect]"),
       "s.yaml:4: key 'planners[1]': the name 'RRTConnect' is taken (line 4); give this one a "
       "label"},
      {suite_with("planners", "[{name: RRTConnect, parms: {range: 1}}]"),
       "s.yaml:4: key 'planners[0].parms': unknown key (allowed: name, label, params, "
       "navigation; did you mean 'params'?)"},
      {suite_with("planners", "[{name: RRTConnect, navigation: {yaw_polic: path}}]"),
       "s.yaml:4: key 'planners[0].navigation.yaw_polic': unknown key (allowed: " +
           join_names(navigation_keys()) + "; did you mean 'yaw_policy'?)"},
      {suite_with("planners", "[{name: RRTConnect, params: {rang: 1}}]"),
       "s.yaml:4: key 'planners[0].params.rang': planner 'RRTConnect' has no parameter 'rang'; did "
       "you mean 'range'? It has: intermediate_states range"},
      {suite_with("planners", "[{name: RRTConnect, params: {range: far}}]"),
       "s.yaml:4: key 'planners[0].params.range': planner 'RRTConnect': parameter 'range' cannot "
       "be 'far'; allowed: numbers from 0 to 10000"},
      {suite_with("planners", "[{name: BITstar, params: {samples_per_batch: 1e3}}]"),
       "s.yaml:4: key 'planners[0].params.samples_per_batch': planner 'BITstar': parameter "
       "'samples_per_batch' cannot be '1e3'; allowed: whole numbers from 1 to 1000000"},
      {suite_with("planners", "[{name: AnytimePathShortening, params: {planners: Bogus}}]"),
       "s.yaml:4: key 'planners[0].params.planners': planner 'AnytimePathShortening': parameter "
       "'planners' cannot be 'Bogus'; OMPL: Unknown planner name: Bogus"},
      {suite_with("planners", "['RRT#']"),
       "s.yaml:4: key 'planners[0]': no planner 'RRT#': OMPL's planner of this name is 'RRTsharp' "
       "here, as its class"},
      {suite_with("planners", "[{name: ReactiveVoronoi, params: {preset: best}}]"),
       "s.yaml:4: key 'planners[0].params.preset': planner 'ReactiveVoronoi': parameter 'preset' "
       "cannot be 'best'; allowed: as_published,repaired"},
      {suite_with("range_finder", "{rays: 0}"),
       "s.yaml:5: key 'range_finder.rays': " + count + "1 to 100000, got '0'"},
      {suite_with("mapping", "{merge_m: 1}"),
       "s.yaml:5: key 'mapping.merge_m': unknown key (allowed: link_distance_m, "
       "thinning_distance_m, merge_distance_m)"},
      {suite_with("navigation", "papre"),
       "s.yaml:5: key 'navigation': expected one of careful, paper, got 'papre' (did you mean "
       "'paper'?)"},
      {suite_with("navigation", "[paper]"),
       "s.yaml:5: key 'navigation': expected a map of keys, got a list of 1"},
      {suite_with("range_finder", "paper"),
       "s.yaml:5: key 'range_finder': expected a map of keys, got 'paper'"},
      {suite_with("navigation", "{yaw_policy: sideways}"),
       "s.yaml:5: key 'navigation.yaw_policy': expected one of fixed, path, got 'sideways'"},
      {suite_with("loop", "{goal_hold_s: .nan}"),
       "s.yaml:5: key 'loop.goal_hold_s': expected a number from 0 to 60, got '.nan'"},
      {suite_with("budget", "{state_checks: 0}"),
       "s.yaml:5: key 'budget.state_checks': " + count + "1 to 9223372036854775807, got '0'"},
      {suite_with("budget", "{time_s: 1}"),
       "s.yaml:5: key 'budget.time_s': unknown key (allowed: state_checks, ptc_evaluations, "
       "iterations, wall_clock_s, stop)"},
      {suite_with("limits", "{memory_mb: 1}"),
       "s.yaml:5: key 'limits.memory_mb': expected a number from 16 to 1000000, got '1'"},
      {suite_with("traces", "some"),
       "s.yaml:5: key 'traces': expected one of all, failures, none, got 'some'"},
      {suite_with("acceptance", "[{planner: RRTConect}]"),
       "s.yaml:5: key 'acceptance[0].planner': no planner 'RRTConect' (allowed: RRTConnect; did "
       "you "
       "mean 'RRTConnect'?)"},
      {suite_with("acceptance", "[{goal_reached_share_min: 100}]"),
       "s.yaml:5: key 'acceptance[0].goal_reached_share_min': expected a number from 0 to 1, got "
       "'100'"},
  };
  for (const auto& [text, message] : cases) {
    const std::string error = error_in(text);
    EXPECT_EQ(error, message) << text;
    EXPECT_EQ(error.find('\n'), std::string::npos);
  }
}

TEST(SuiteConfig, AsksACartOnlyForWhatItCanDo) {
  const auto with_cart = [](const std::string& planners, const std::string& rest) {
    return "suite: s\nscenarios: [{name: a, generator: {name: forest}}]\n"
           "vehicles: [quadrotor, {name: cart, label: trolley}]\nplanners: " +
           planners + "\n" + rest;
  };
  const std::string yaw_policy =
      "navigation.yaw_policy 'fixed' is not for vehicle 'trolley', which looks where it drives "
      "(allowed: "
      "path)";
  const std::string own = "[RRTConnect, {name: RRTConnect, label: b, navigation: {";
  EXPECT_EQ(error_in(with_cart("[RRTConnect]", "navigation: {yaw_policy: path}")), "no error");
  EXPECT_EQ(error_in(with_cart("[RRTConnect]", "kind: static")), "no error") << "nobody moves";
  EXPECT_EQ(error_in(with_cart("[RRTConnect]", "")), "no error") << "by default";
  EXPECT_EQ(error_in(with_cart("[RRTConnect]", "navigation: paper")),
            "s.yaml:5: key 'navigation': " + yaw_policy);
  EXPECT_EQ(error_in(with_cart("[RRTConnect]", "navigation: {off_path_m: 1, preset: paper}")),
            "s.yaml:5: key 'navigation.preset': " + yaw_policy);
  EXPECT_EQ(error_in(with_cart("[RRTConnect]", "navigation: {yaw_policy: fixed}")),
            "s.yaml:5: key 'navigation.yaw_policy': " + yaw_policy);
  EXPECT_EQ(error_in(with_cart("[RRTConnect]", "navigation: {yaw_policy: path, governor: true}")),
            "no error");
  EXPECT_EQ(error_in(with_cart(own + "yaw_policy: fixed}}]", "navigation: {yaw_policy: path}")),
            "s.yaml:4: key 'planners[1].navigation.yaw_policy': " + yaw_policy);
}

TEST(SuiteConfig, AsksNoGovernorToTrustALawThatDoesNotStop) {
  EXPECT_EQ(error_in("suite: s\nscenarios: [{name: a, generator: {name: forest}}]\n"
                     "vehicles: [{name: quadrotor, regulator: paper_literal}]\n"
                     "planners: [RRTConnect]\nnavigation: {governor: true}\n"),
            "s.yaml:5: key 'navigation.governor': no governor for vehicle 'quadrotor': regulator "
            "'paper_literal' promises no stop: it is unstable (allowed: navigation.governor "
            "false)");
}

TEST(SuiteConfig, KeepsThePlannersThatWereAskedForAndNamesTheOthers) {
  SuiteConfig suite = small_suite("s", {"a", "b", "c"});
  keep_planners(suite, {"c", "a"});
  ASSERT_EQ(suite.planners.size(), 2U);
  EXPECT_EQ(suite.planners[0].label, "a");
  try {
    keep_planners(suite, {"aa"});
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "no planner 'aa' in suite 's' (allowed: a, c)");
  }
}

}  // namespace
}  // namespace voronaut
