#include "voronaut/planners/potential_field/potential_field.h"

#include <gtest/gtest.h>
#include <ompl/geometric/PathGeometric.h>

#include "voronaut/planners/potential_field/potential.h"
#include "voronaut/planners/problem/path_conversion.h"
#include "voronaut/planners/problem/problem.h"
#include "voronaut/tests/planners/mapping/known_points.h"
#include "voronaut/tests/planners/planar_random.h"

namespace voronaut {
namespace {

namespace ob = ompl::base;
using test::base_of;
using test::PlanarRandom;

const ProblemConfig kConfig{.bounds_world = {{0, 0}, {10, 10}}, .goal_world = {9, 5}};

TEST(Potential, ForceIsTheDownhillSlopeOfThePotential) {
  constexpr std::uint64_t kSeed = 21;
  PlanarRandom random(kSeed);
  const PotentialConfig config;
  constexpr double kDelta = 1e-6;
  for (int i = 0; i < 300; ++i) {
    const std::vector<Vec2> closest{random.point(-1, 1), random.point(-1, 1)};
    const Vec2 goal = random.point(-3, 3);
    const Vec2 p = random.point(-2, 2);
    if ((p - closest[0]).norm() < 0.2 || (p - closest[1]).norm() < 0.2) continue;
    const auto potential = [&](double x, double y) {
      return total_potential({x, y}, goal, closest, config);
    };
    const Vec2 slope{(potential(p.x() + kDelta, p.y()) - potential(p.x() - kDelta, p.y())),
                     (potential(p.x(), p.y() + kDelta) - potential(p.x(), p.y() - kDelta))};
    const Vec2 force = total_force(p, goal, closest, config);
    EXPECT_NEAR((force + slope / (2 * kDelta)).norm(), 0, 1e-4 * (1 + force.norm()))
        << "seed " << kSeed << " case " << i;
  }
}

TEST(Potential, PushEndsAtTheInfluenceDistance) {
  const PotentialConfig config;
  EXPECT_EQ(repulsion_force({1.51, 0}, {0, 0}, config), Vec2(0, 0));
  EXPECT_GT(repulsion_force({1.49, 0}, {0, 0}, config).x(), 0);
  EXPECT_EQ(repulsion_potential({1.51, 0}, {0, 0}, config), 0);
}

// By hand: at rho = 0.5, F = 0.5 (1/0.5 - 1/1.5) / 0.25 = 8/3 N.
TEST(Potential, PushAtHalfAMetreIsAsWorkedByHand) {
  EXPECT_NEAR(repulsion_force({0.5, 0}, {0, 0}, {}).x(), 8.0 / 3, 1e-12);
}

TEST(Potential, PullOfADistantGoalIsSaturated) {
  EXPECT_NEAR(attraction_force({0, 0}, {5, 0}, {}).x(), 1, 1e-12);
  EXPECT_NEAR(attraction_force({0, 0}, {0.5, 0}, {}).x(), 0.5, 1e-12);
}

// With the default gains the push of a single obstacle straight ahead balances the pull where
// 0.5 (1/rho - 2/3) / rho^2 = 1: rho = 0.655 m.
TEST(PotentialField, StopsWhereThePushOfAnObstacleAheadBalancesThePull) {
  const auto base = base_of({{5, 5}});
  PlanningProblem problem(kConfig);
  problem.update(base->snapshot(), {1, 5});
  PotentialField planner(problem.space_information());
  planner.setProblemDefinition(problem.definition());
  ASSERT_EQ(planner.solve(problem.meter({}).condition()), ob::PlannerStatus::APPROXIMATE_SOLUTION);
  const Path path =
      to_path(*problem.definition()->getSolutionPath()->as<ompl::geometric::PathGeometric>());
  EXPECT_NEAR(path.back().x(), 5 - 0.655, 0.01);
  EXPECT_NEAR(path.back().y(), 5, 1e-6);
  EXPECT_NEAR(problem.definition()->getSolutionDifference(), 9 - path.back().x(), 1e-9);
}

TEST(PotentialField, FlowsAroundAnObstacleBesideTheWay) {
  const auto base = base_of({{5, 4.7}});
  PlanningProblem problem(kConfig);
  problem.update(base->snapshot(), {1, 5});
  PotentialField planner(problem.space_information());
  planner.setProblemDefinition(problem.definition());
  ASSERT_EQ(planner.solve(problem.meter({}).condition()), ob::PlannerStatus::EXACT_SOLUTION);
  const auto& path = *problem.definition()->getSolutionPath()->as<ompl::geometric::PathGeometric>();
  EXPECT_TRUE(path.check());
  EXPECT_GT(path.length(), 8.05);
  EXPECT_LT(path.length(), 9);
}

TEST(PotentialField, FollowsTheLiveBeliefAnewAtEachSolve) {
  const auto base = base_of({{5, 4.7}});
  const Belief belief{base->snapshot(), nullptr, {}, {}};
  PlanningProblem problem(kConfig);
  PotentialField planner(problem.space_information());
  planner.setProblemDefinition(problem.definition());
  for (const Vec2& start : {Vec2(1, 5), Vec2(2, 5.2), Vec2(3, 6)}) {
    problem.update(belief, start);
    ASSERT_EQ(planner.solve(problem.meter({}).condition()), ob::PlannerStatus::EXACT_SOLUTION);
    const Path path =
        to_path(*problem.definition()->getSolutionPath()->as<ompl::geometric::PathGeometric>());
    EXPECT_EQ(path.front(), start);
    EXPECT_EQ(path.back(), kConfig.goal_world);
  }
}

}  // namespace
}  // namespace voronaut
