#include "voronaut/planners/catalog/catalog.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
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
    PlanningBudget budget{.state_checks = 3000, .ptc_evaluations = 6000};
    budget.wall_clock_s = 1;
    if (entry->traits.reproducible == Reproducible::no)
      budget.counts = PlanningBudget::Counts::wall_clock;
    EXPECT_TRUE(solve_within(*planner, problem.meter(budget)).status) << entry->name;
  }
}

TEST(SetParameters, AppliesThePresetFirstWhateverTheOrder) {
  PlanningProblem problem(kConfig);
  ReactiveVoronoi planner(problem.space_information());
  EXPECT_EQ(planner.preset(), "as_published");
  set_parameters(planner, {{"preset", "repaired"}, {"offset", "axis"}});
  EXPECT_EQ(planner.config().offset, ReactiveVoronoiConfig::Offset::axis);
  EXPECT_EQ(planner.config().extremes, ReactiveVoronoiConfig::Extremes::bearing_order);
  EXPECT_EQ(planner.preset(), "");
  set_parameters(planner, {{"preset", "repaired"}});
  EXPECT_EQ(planner.preset(), "repaired");
}

TEST(SetParameters, ReachesEveryFieldByItsName) {
  PlanningProblem problem(kConfig);
  ReactiveVoronoi planner(problem.space_information());
  set_parameters(planner, {{"safety_margin_m", "0.6"},
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
                set_parameters(*planner, {{"rnage", "1"}});
              }),
              AllOf(HasSubstr("RRTConnect"), HasSubstr("'rnage'"),
                    HasSubstr("did you mean 'range'"), HasSubstr("intermediate_states")));
}

TEST(SetParameters, RefusesAValueAndSaysWhatIsAllowed) {
  PlanningProblem problem(kConfig);
  ReactiveVoronoi planner(problem.space_information());
  for (const char* value : {"-1", "0.5x", "nan", "", "1e999", "axis"}) {
    EXPECT_THAT(message_of([&] {
                  set_parameters(planner, {{"safety_margin_m", value}});
                }),
                AllOf(HasSubstr("'safety_margin_m'"), HasSubstr("allowed: 0.01:10")))
        << value;
  }
  EXPECT_EQ(planner.config().safety_margin_m, 0.5);
  EXPECT_THAT(message_of([&] {
                set_parameters(planner, {{"offset", "sideways"}});
              }),
              HasSubstr("allowed: axis,line_of_sight"));
  EXPECT_THAT(message_of([&] {
                set_parameters(planner, {{"side_hysteresis", "maybe"}});
              }),
              HasSubstr("allowed: 0,1"));
  EXPECT_THAT(message_of([&] {
                set_parameters(planner, {{"preset", "best"}});
              }),
              HasSubstr("allowed: as_published,repaired"));
}

}  // namespace
}  // namespace voronaut
