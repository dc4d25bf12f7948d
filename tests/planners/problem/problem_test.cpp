#include "voronaut/planners/problem/problem.h"

#include <gtest/gtest.h>
#include <ompl/base/ScopedState.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/planners/kpiece/KPIECE1.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>

#include "voronaut/planners/problem/known_geometry.h"
#include "voronaut/planners/problem/path_conversion.h"
#include "voronaut/planners/problem/planar_state.h"
#include "voronaut/tests/planners/mapping/known_points.h"
#include "voronaut/tests/planners/planar_random.h"

namespace voronaut {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;
using test::base_of;
using test::PlanarRandom;

const ProblemConfig kConfig{.bounds_world = {{0, 0}, {10, 10}}, .goal_world = {9, 9}};

ob::ScopedState<> state_at(const ob::SpaceInformationPtr& si, const Vec2& p) {
  ob::ScopedState<> state(si);
  set_position(*si->getStateSpace(), state.get(), p);
  return state;
}

double clearance_of(const std::vector<Vec2>& points, const Segment& motion) {
  double best = 1e9;
  for (const Vec2& p : points) best = std::min(best, distance(p, motion));
  return best;
}

TEST(PlanningProblem, FreesAllWithinBoundsBeforeAnythingIsKnown) {
  PlanningProblem problem(kConfig);
  problem.update(ObstacleSnapshot{}, {1, 1});
  const auto& si = problem.space_information();
  EXPECT_TRUE(si->isValid(state_at(si, {5, 5}).get()));
  EXPECT_TRUE(si->isValid(state_at(si, {0, 10}).get()));
  EXPECT_FALSE(si->isValid(state_at(si, {5, 10.001}).get()));
  EXPECT_TRUE(si->checkMotion(state_at(si, {0, 0}).get(), state_at(si, {10, 10}).get()));
  EXPECT_FALSE(si->checkMotion(state_at(si, {5, 5}).get(), state_at(si, {-1, 5}).get()));
}

TEST(PlanningProblem, AgreesWithBruteForceOverThePoints) {
  constexpr std::uint64_t kSeed = 11;
  PlanarRandom random(kSeed);
  for (int world = 0; world < 20; ++world) {
    std::vector<Vec2> points;
    for (int i = 0; i < 40; ++i) points.push_back(random.point(0, 10));
    const auto base = base_of(points);
    Vec2 start = random.point(0, 10);
    while (clearance_of(points, {start, start}) < kConfig.planning_clearance_m)
      start = random.point(0, 10);
    PlanningProblem problem(kConfig);
    problem.update(base->snapshot(), start);
    const auto& si = problem.space_information();
    for (int query = 0; query < 300; ++query) {
      const Vec2 a = random.point(-1, 11);
      const Vec2 b = random.point(-1, 11);
      const double state_m = clearance_of(points, {a, a});
      const double motion_m = clearance_of(points, {a, b});
      const bool a_inside = kConfig.bounds_world.contains(a);
      const bool b_inside = kConfig.bounds_world.contains(b);
      ASSERT_EQ(si->isValid(state_at(si, a).get()), a_inside && state_m >= 0.4)
          << "seed " << kSeed << " world " << world << " query " << query;
      ASSERT_EQ(si->checkMotion(state_at(si, a).get(), state_at(si, b).get()),
                b_inside && motion_m >= 0.4)
          << "seed " << kSeed << " world " << world << " query " << query;
      if (a_inside) {
        EXPECT_NEAR(si->getStateValidityChecker()->clearance(state_at(si, a).get()), state_m, 1e-9);
      }
    }
  }
}

// The rule, point by point along the motion: within planning_clearance_m of the start what the
// start has is enough. A spacing of samples is 1.5 mm at most; `lenient` gives the edge of the disc
// and the closest approach what sampling may miss, otherwise they are held against the motion.
bool is_allowed_by_sampling(const std::vector<Vec2>& points, const Vec2& start,
                            const Segment& motion, bool lenient) {
  constexpr double kAsked_m = 0.4;
  const double inside_m = std::min(clearance_of(points, {start, start}), kAsked_m);
  const double radius_m = kAsked_m + (lenient ? 2e-3 : -2e-3);
  for (int i = 0; i <= 2000; ++i) {
    const Vec2 p = motion.a + (motion.b - motion.a) * (i / 2000.0);
    const bool inside = (p - start).norm() <= radius_m;
    const double needed_m =
        inside ? inside_m - (lenient ? 1e-8 : 0) : kAsked_m + (lenient ? -1e-8 : 1e-5);
    if (clearance_of(points, {p, p}) < needed_m) return false;
  }
  return true;
}

TEST(PlanningProblem, RelaxesTheClearanceInsideTheDiscAroundAStartTooClose) {
  constexpr std::uint64_t kSeed = 12;
  PlanarRandom random(kSeed);
  int relaxed = 0;
  int allowed = 0;
  for (int world = 0; world < 60; ++world) {
    const Vec2 start = random.point(4, 6);
    std::vector<Vec2> points;
    for (int i = 0; i < 6; ++i) points.push_back(start + random.point(-1.2, 1.2));
    if (clearance_of(points, {start, start}) >= 0.4) continue;
    ++relaxed;
    const auto base = base_of(points);
    PlanningProblem problem(kConfig);
    problem.update(base->snapshot(), start);
    const auto& si = problem.space_information();
    ASSERT_TRUE(si->isValid(state_at(si, start).get()));
    for (int query = 0; query < 40; ++query) {
      const Vec2 a = query % 2 == 0 ? start : Vec2(start + random.point(-1, 1));
      const Vec2 b = start + random.point(-1, 1);
      const bool valid = si->checkMotion(state_at(si, a).get(), state_at(si, b).get());
      allowed += valid;
      EXPECT_EQ(valid, is_allowed_by_sampling(points, start, {a, b}, valid))
          << "seed " << kSeed << " world " << world << " query " << query;
    }
  }
  EXPECT_GT(relaxed, 10);
  EXPECT_GT(allowed, 50);
}

TEST(PlanningProblem, FindsTheLastValidStateOfAMotionWithinAMillimetre) {
  const auto base = base_of({{5, 5}});
  PlanningProblem problem(kConfig);
  problem.update(base->snapshot(), {1, 5});
  const auto& si = problem.space_information();
  ob::ScopedState<> last(si);
  std::pair<ob::State*, double> last_valid{last.get(), -1};
  EXPECT_FALSE(si->checkMotion(state_at(si, {1, 5}).get(), state_at(si, {9, 5}).get(), last_valid));
  EXPECT_NEAR(position_of(*si->getStateSpace(), last.get()).x(), 4.6, 1e-3);
  EXPECT_LE(position_of(*si->getStateSpace(), last.get()).x(), 4.6);
  EXPECT_NEAR(last_valid.second, 3.6 / 8, 1e-3);
}

TEST(PlanningProblem, CountsEachStateAndEachMotionOnce) {
  PlanningProblem problem(kConfig);
  problem.update(ObstacleSnapshot{}, {1, 1});
  const auto& si = problem.space_information();
  const std::uint64_t before = problem.state_checks();
  si->isValid(state_at(si, {2, 2}).get());
  si->checkMotion(state_at(si, {2, 2}).get(), state_at(si, {8, 2}).get());
  EXPECT_EQ(problem.state_checks() - before, 2u);
}

TEST(PlanningProblem, MetersTheChecksOfItsOwnChecker) {
  PlanningProblem problem(kConfig);
  problem.update(ObstacleSnapshot{}, {1, 1});
  const auto& si = problem.space_information();
  const BudgetMeter meter = problem.meter({.state_checks = 3, .ptc_evaluations = 100});
  const auto spent = meter.condition();
  EXPECT_FALSE(spent());
  EXPECT_FALSE(meter.ran_out());
  for (int i = 0; i < 3; ++i) si->isValid(state_at(si, {2, 2}).get());
  EXPECT_TRUE(spent());
  EXPECT_EQ(meter.ran_out(), SolveEnd::state_checks);
}

TEST(PlanningProblem, OffersTheLiveBeliefAndNoneForAStaticProblem) {
  const auto base = base_of({{5, 5}});
  const Belief belief{base->snapshot(), nullptr, {}, {}};
  PlanningProblem problem(kConfig);
  problem.update(belief, {1, 1});
  EXPECT_EQ(problem.geometry().belief(), &belief);
  problem.update(base->snapshot(), {1, 1});
  EXPECT_EQ(problem.geometry().belief(), nullptr);
  EXPECT_EQ(problem.geometry().known_obstacles().points().size(), 1u);
}

TEST(PlanningProblem, CarriesPlannersThatProjectTheState) {
  PlanningProblem problem(kConfig);
  problem.update(ObstacleSnapshot{}, {1, 1});
  og::KPIECE1 planner(problem.space_information());
  planner.setProblemDefinition(problem.definition());
  EXPECT_EQ(planner.solve(problem.meter({}).condition()), ob::PlannerStatus::EXACT_SOLUTION);
}

TEST(PathConversion, KeepsThePositionsOfASolution) {
  const auto base = base_of({{5, 5}, {5, 5.5}, {5.5, 5}});
  PlanningProblem problem(kConfig);
  problem.update(base->snapshot(), {1, 1});
  og::RRTConnect planner(problem.space_information());
  planner.setProblemDefinition(problem.definition());
  ASSERT_EQ(planner.solve(problem.meter({}).condition()), ob::PlannerStatus::EXACT_SOLUTION);
  const auto& solution = *problem.definition()->getSolutionPath()->as<og::PathGeometric>();
  const Path path = to_path(solution);
  EXPECT_EQ(path.front(), Vec2(1, 1));
  EXPECT_EQ(path.back(), Vec2(9, 9));
  EXPECT_EQ(path.segments().size(), solution.getStateCount() - 1);
  EXPECT_NEAR(path.length_m(), solution.length(), 1e-9);
}

}  // namespace
}  // namespace voronaut
