#include "voronaut/planners/catalog/catalog.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/util/RandomNumbers.h>

#include "voronaut/planners/problem/problem.h"
#include "voronaut/planners/reactive_voronoi/reactive_voronoi.h"

namespace voronaut {
namespace {

// Sampling planners draw from one process-wide seed.
struct SeededOmpl : testing::Environment {
  void SetUp() override { ompl::RNG::setSeed(1); }
};
[[maybe_unused]] const auto* const kSeeded =
    testing::AddGlobalTestEnvironment(std::make_unique<SeededOmpl>().release());

using testing::AllOf;
using testing::HasSubstr;

const ProblemConfig kConfig{.bounds_world = {{0, 0}, {10, 10}}, .goal_world = {9, 9}};

std::string message_of(const std::function<void()>& call) {
  try {
    call();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "no exception";
}

// OMPL's classes are called so; they call themselves with a k (they connect to k neighbours) or #.
std::string class_name(std::string name) {
  if (name == "APS") return "AnytimePathShortening";
  if (name.starts_with("kB") || name.starts_with("kA")) name.erase(0, 1);
  if (name.ends_with("#")) name.replace(name.size() - 1, 1, "sharp");
  return name;
}

TEST(PlannerCatalog, NamesEachPlannerAsItsClass) {
  PlanningProblem problem(kConfig);
  const PlannerCatalog catalog = PlannerCatalog::built_in();
  for (const PlannerEntry* entry : catalog.entries()) {
    const auto planner = entry->make(problem.space_information());
    EXPECT_EQ(class_name(planner->getName()), entry->name);
    if (planner->getSpecs().multithreaded) {
      EXPECT_EQ(entry->traits.reproducible, Reproducible::no) << entry->name;
    }
  }
}

TEST(PlannerCatalog, HoldsThePlannersOfThePaperAndThoseBesideIt) {
  const PlannerCatalog catalog = PlannerCatalog::built_in();
  ASSERT_TRUE(catalog.find("ReactiveVoronoi"));
  EXPECT_TRUE(catalog.find("ReactiveVoronoi")->traits.plans_on_every_scan);
  ASSERT_TRUE(catalog.find("PotentialField"));
  EXPECT_TRUE(catalog.find("PotentialField")->traits.plans_on_every_scan);
  ASSERT_TRUE(catalog.find("RRTConnect"));
  EXPECT_FALSE(catalog.find("RRTConnect")->traits.plans_on_every_scan);
  EXPECT_GE(catalog.entries().size(), 45U);  // OMPL's 43, PRM once more, ours
}

TEST(PlannerCatalog, RefusesANameTwice) {
  PlannerCatalog catalog = PlannerCatalog::built_in();
  EXPECT_THROW(catalog.add(*catalog.find("RRTConnect")), std::invalid_argument);
}

// Every planner of the catalogue keeps to a budget of counted work in the plane.
TEST(PlannerCatalog, EveryPlannerFindsAWayThroughTheEmptyPlaneWithinABudget) {
  const PlannerCatalog catalog = PlannerCatalog::built_in();
  for (const PlannerEntry* entry : catalog.entries()) {
    PlanningProblem problem(kConfig);
    problem.update(ObstacleSnapshot{}, {1, 1});
    const auto planner = entry->make(problem.space_information());
    planner->setProblemDefinition(problem.definition());
    // Threads that wait for a solution ask for the end all the time: those get a clock.
    // Ten times what nearly all solves need: one in 200 of XXL's asks 6000 times whether to end.
    PlanningBudget budget{
        .state_checks = 30'000, .ptc_evaluations = 60'000, .stop = PlanningBudget::Stop::first};
    if (entry->traits.reproducible == Reproducible::no) {
      budget.counts = PlanningBudget::Counts::wall_clock;
      budget.wall_clock_s = 60;  // however slow the machine
    }
    EXPECT_TRUE(solve_within(*planner, problem.meter(budget)).status) << entry->name;
  }
}

TEST(SetParameters, AppliesThePresetFirstWhateverTheOrder) {
  PlanningProblem problem(kConfig);
  ReactiveVoronoi planner(problem.space_information());
  EXPECT_EQ(planner.preset(), "as_published");
  set_parameters(planner, "ReactiveVoronoi", {{"preset", "repaired"}, {"offset", "axis"}});
  EXPECT_EQ(planner.config().offset, ReactiveVoronoiConfig::Offset::axis);
  EXPECT_EQ(planner.config().extremes, ReactiveVoronoiConfig::Extremes::bearing_order);
  EXPECT_EQ(planner.preset(), "");
  set_parameters(planner, "ReactiveVoronoi", {{"preset", "repaired"}});
  EXPECT_EQ(planner.preset(), "repaired");
}

TEST(SetParameters, ReachesEveryFieldByItsName) {
  PlanningProblem problem(kConfig);
  ReactiveVoronoi planner(problem.space_information());
  set_parameters(planner, "ReactiveVoronoi",
                 {{"safety_margin_m", "0.6"},
                  {"side_hysteresis", "1"},
                  {"source", "map"},
                  {"sensing_rays", "61"}});
  EXPECT_EQ(planner.config().safety_margin_m, 0.6);
  EXPECT_TRUE(planner.config().side_hysteresis);
  EXPECT_EQ(planner.config().source, ReactiveVoronoiConfig::Source::map);
  EXPECT_EQ(planner.params()["sensing_rays"].getValue(), "61");
}

TEST(SetParameters, NamesTheNearestParameterForAnUnknownOne) {
  PlanningProblem problem(kConfig);
  const auto planner =
      PlannerCatalog::built_in().find("RRTConnect")->make(problem.space_information());
  EXPECT_THAT(message_of([&] {
                set_parameters(*planner, "RRTConnect", {{"rnage", "1"}});
              }),
              AllOf(HasSubstr("RRTConnect"), HasSubstr("'rnage'"),
                    HasSubstr("did you mean 'range'"), HasSubstr("intermediate_states")));
}

TEST(SetParameters, RefusesAValueAndSaysWhatIsAllowed) {
  PlanningProblem problem(kConfig);
  ReactiveVoronoi planner(problem.space_information());
  for (const char* value : {"-1", "0.5x", "nan", "", "1e999", "axis"}) {
    EXPECT_THAT(
        message_of([&] {
          set_parameters(planner, "ReactiveVoronoi", {{"safety_margin_m", value}});
        }),
        AllOf(HasSubstr("'safety_margin_m'"), HasSubstr("allowed: numbers from 0.01 to 10")))
        << value;
  }
  EXPECT_EQ(planner.config().safety_margin_m, 0.5);
  EXPECT_THAT(message_of([&] {
                set_parameters(planner, "ReactiveVoronoi", {{"offset", "sideways"}});
              }),
              HasSubstr("allowed: axis,line_of_sight"));
  EXPECT_THAT(message_of([&] {
                set_parameters(planner, "ReactiveVoronoi", {{"side_hysteresis", "maybe"}});
              }),
              HasSubstr("allowed: 0,1"));
  EXPECT_THAT(message_of([&] {
                set_parameters(planner, "ReactiveVoronoi", {{"preset", "best"}});
              }),
              HasSubstr("allowed: as_published,repaired"));
}

// What the planner's parameter says of a value, empty if it takes it.
std::string refusal_of(const std::string& name, const std::string& parameter,
                       const std::string& value) {
  PlanningProblem problem(kConfig);
  const auto planner = PlannerCatalog::built_in().find(name)->make(problem.space_information());
  try {
    set_parameters(*planner, name, {{parameter, value}});
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

// OMPL reads 1e3 as 1, 2.5 as 2, and wraps what does not fit.
TEST(SetParameters, TakesAWholeNumberAsItIsWrittenOrNotAtAll) {
  for (const char* value : {"1e3", "99999999999", "-5", "2.5", "0x10", " 7"})
    EXPECT_THAT(refusal_of("BITstar", "samples_per_batch", value),
                HasSubstr("'samples_per_batch' cannot be '" + std::string(value) +
                          "'; allowed: whole numbers from 1 to 1000000"))
        << value;
  EXPECT_NE(refusal_of("RRTstar", "number_sampling_attempts", "2.5"), "");
  EXPECT_NE(refusal_of("CForest", "num_threads", "-1"), "");
  EXPECT_NE(refusal_of("AITstar", "samples_per_batch", "99999999999999999999"), "");
  PlanningProblem problem(kConfig);
  const auto planner =
      PlannerCatalog::built_in().find("BITstar")->make(problem.space_information());
  set_parameters(*planner, "BITstar", {{"samples_per_batch", "1000"}});
  EXPECT_EQ(planner->params()["samples_per_batch"].getValue(), "1000");
}

TEST(SetParameters, KeepsToTheRangeThatAPlannerDeclares) {
  EXPECT_THAT(refusal_of("RRTstar", "goal_bias", "5"), HasSubstr("allowed: numbers from 0 to 1"));
  EXPECT_NE(refusal_of("RRTstar", "goal_bias", "-1"), "");
  EXPECT_NE(refusal_of("RRTstar", "range", "-3"), "");
  EXPECT_NE(refusal_of("KPIECE1", "border_fraction", "7"), "");
  EXPECT_NE(refusal_of("SST", "pruning_radius", "-1"), "");
  EXPECT_NE(refusal_of("FMT", "num_samples", "0"), "");
  EXPECT_NE(refusal_of("pRRT", "thread_count", "0"), "") << "an assertion in OMPL";
  EXPECT_NE(refusal_of("XXL", "rand_walk_rate", "2"), "") << "ends the process in OMPL";
  EXPECT_EQ(refusal_of("RRTstar", "goal_bias", "0"), "");
  EXPECT_EQ(refusal_of("RRTstar", "range", "0"), "") << "OMPL chooses";
}

TEST(SetParameters, TakesWhatMakesSenseBeyondOmplsSuggestions) {
  EXPECT_EQ(refusal_of("RRTstar", "rewire_factor", "2.5"), "");
  EXPECT_EQ(refusal_of("AITstar", "samples_per_batch", "5000"), "");
  EXPECT_EQ(refusal_of("PRM", "max_nearest_neighbors", "5"), "");
  EXPECT_EQ(refusal_of("SST", "range", "0.05"), "");
  EXPECT_EQ(refusal_of("SPARStwo", "max_failures", "5000"), "") << "its own default";
}

// What a planner has when it is made is a value that it takes, if it can be written at all.
TEST(SetParameters, TakesEveryDefault) {
  PlanningProblem problem(kConfig);
  const PlannerCatalog catalog = PlannerCatalog::built_in();
  for (const PlannerEntry* entry : catalog.entries()) {
    const auto planner = entry->make(problem.space_information());
    std::map<std::string, std::string> defaults;
    planner->params().getParams(defaults);
    for (const auto& [name, value] : defaults) {
      // Their getters say "not set" in a way of their own.
      if (value.empty() || value == "inf" || name == "max_nearest_neighbors" ||
          name == "rand_walk_rate")
        continue;
      EXPECT_EQ(refusal_of(entry->name, name, value), "");
    }
  }
}

TEST(SetParameters, SaysWhatOmplIgnores) {
  EXPECT_THAT(refusal_of("BITstar", "delay_rewiring_to_first_solution", "1"),
              HasSubstr("OMPL leaves it at '0'"));
  EXPECT_EQ(refusal_of("BITstar", "delay_rewiring_to_first_solution", "0"), "");
  EXPECT_THAT(refusal_of("AnytimePathShortening", "planners", "RRT,Bogus"),
              HasSubstr("OMPL: Unknown planner name: Bogus"));
  EXPECT_THAT(refusal_of("AnytimePathShortening", "planners", "RRT[rnage=1]"),
              HasSubstr("Parameter 'rnage' was not found"));
  EXPECT_EQ(refusal_of("AnytimePathShortening", "planners", "RRTConnect,BITstar,RRT[range=1]"), "");
  EXPECT_THAT(refusal_of("KPIECE1", "border_fraction", "0"), HasSubstr("OMPL: "));
}

// LazyPRM's range sets its connection strategy back to the default number of neighbours.
TEST(SetParameters, GivesTheRangeBeforeWhatItWouldTakeBack) {
  PlanningProblem problem(kConfig);
  problem.update(ObstacleSnapshot{}, {1, 1});
  const auto edges_per_vertex = [&](const char* neighbors) {
    const auto planner =
        PlannerCatalog::built_in().find("LazyPRM")->make(problem.space_information());
    set_parameters(*planner, "LazyPRM", {{"max_nearest_neighbors", neighbors}, {"range", "9"}});
    problem.update(ObstacleSnapshot{}, {1, 1});
    const auto shortest =
        std::make_shared<ompl::base::PathLengthOptimizationObjective>(problem.space_information());
    shortest->setCostThreshold(ompl::base::Cost(0));  // no path will do: all of the budget is spent
    problem.definition()->setOptimizationObjective(shortest);
    planner->setProblemDefinition(problem.definition());
    planner->setup();
    int evaluations = 0;
    planner->solve(ompl::base::PlannerTerminationCondition([&] { return ++evaluations > 200; }));
    ompl::base::PlannerData data(problem.space_information());
    planner->getPlannerData(data);
    return static_cast<double>(data.numEdges()) / data.numVertices();
  };
  EXPECT_LT(edges_per_vertex("1"), edges_per_vertex("20"));
  EXPECT_THAT(refusal_of("LazyPRM", "max_nearest_neighbors", "5"),
              HasSubstr("'max_nearest_neighbors' wants a 'range' above 0 beside it"))
      << "it would connect nothing";
}

TEST(SetParameters, CallsThePlannerAsTheCatalogueDoes) {
  EXPECT_THAT(refusal_of("RRTsharp", "goal_bias", "5"), HasSubstr("planner 'RRTsharp'"));
  EXPECT_THAT(refusal_of("AnytimePathShortening", "bias", "5"),
              HasSubstr("planner 'AnytimePathShortening' has no parameter 'bias'"));
}

}  // namespace
}  // namespace voronaut
