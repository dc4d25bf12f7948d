#include "voronaut/planners/voronoi/voronoi_roadmap.h"

#include <memory>

#include <gmock/gmock.h>
#include <ompl/base/PlannerData.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/goals/GoalState.h>
#include <ompl/base/goals/GoalStates.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/geometric/SimpleSetup.h>

#include "voronaut/planners/mapping/obstacle_base.h"
#include "voronaut/planners/problem/belief_validity_checker.h"
#include "voronaut/planners/problem/path_conversion.h"
#include "voronaut/planners/problem/planar_state.h"
#include "voronaut/planners/problem/problem.h"
#include "voronaut/tests/planners/voronoi/voronoi_worlds.h"

namespace voronaut {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;
using namespace voronoi_test;

constexpr double kClearance_m = 0.4;

// An obstacle base that knows these points: each is seen by one beam from 1 m to its left.
class KnownPoints {
 public:
  explicit KnownPoints(const std::vector<Vec2>& points) : base_(finest()) { see(points); }

  void see(const std::vector<Vec2>& points) {
    Scan scan;
    scan.beams = std::make_shared<BeamFan>(BeamFan::spread(0, 1));
    scan.max_range_m = 2;
    scan.range_m = {1.0};
    for (const Vec2& p : points) {
      scan.sensor_world.p_world = p - Vec2::UnitX();
      base_.update(scan);
    }
  }

  ObstacleSnapshot snapshot() const { return base_.snapshot(); }

 private:
  static ObstacleBaseConfig finest() {
    ObstacleBaseConfig config;
    config.thinning_distance_m = 0.001;
    return config;
  }

  ObstacleBase base_;
};

struct Posed {
  Posed(const PointWorld& world, double tolerance_m)
      : known(world.points), problem({world.bounds, world.goal, tolerance_m, kClearance_m}) {
    problem.update(known.snapshot(), world.start);
    planner = std::make_shared<VoronoiRoadmap>(problem.space_information());
    planner->setProblemDefinition(problem.definition());
    planner->setup();
  }

  ob::PlannerStatus solve() { return planner->solve(problem.meter({}).condition()); }
  og::PathGeometric& path() const {
    return *problem.definition()->getSolutionPath()->as<og::PathGeometric>();
  }

  KnownPoints known;
  PlanningProblem problem;
  std::shared_ptr<VoronoiRoadmap> planner;
};

PointWorld around_a_post() {
  PointWorld world;
  world.bounds = {Vec2(-5, -5), Vec2(5, 5)};
  world.start = {-3, 0};
  world.goal = {3, 0};
  add_circle(world.points, {0, 0.1}, 0.5);
  return world;
}

TEST(VoronoiRoadmap, PlansAPathThatTheCheckersAccept) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Random random(seed);
    Posed posed(forest(random, 0.15, 12), 0.2);
    ASSERT_EQ(posed.solve(), ob::PlannerStatus::EXACT_SOLUTION) << "seed " << seed;
    EXPECT_TRUE(posed.path().check()) << "seed " << seed;
    EXPECT_TRUE(posed.problem.definition()->hasExactSolution());
    EXPECT_FALSE(posed.planner->proved_no_path());
  }
}

TEST(VoronoiRoadmap, ProvesThatThereIsNoPathAndSaysWhy) {
  PointWorld world = around_a_post();
  add_circle(world.points, world.goal, 0.9);
  Posed posed(world, 0.2);
  const ob::PlannerStatus status = posed.solve();
  EXPECT_FALSE(status);
  EXPECT_NE(status, ob::PlannerStatus::INVALID_GOAL);
  EXPECT_TRUE(posed.planner->proved_no_path());
  EXPECT_FALSE(posed.planner->failure_reason().empty());
  EXPECT_TRUE(posed.planner->getSpecs().provingSolutionNonExistence);
}

TEST(VoronoiRoadmap, EndsBesideAGoalThatIsTooCloseToAnObstacle) {
  PointWorld world = around_a_post();
  world.goal = {0.85, 0.1};  // 5 cm too close to the post
  Posed posed(world, 0.2);
  ASSERT_EQ(posed.solve(), ob::PlannerStatus::EXACT_SOLUTION);
  EXPECT_TRUE(posed.path().check());
  EXPECT_TRUE(posed.problem.definition()->getGoal()->isSatisfied(posed.path().getStates().back()));

  world.goal = {0.45, 0.1};  // among the post's points, no free place within the tolerance
  Posed inside(world, 0.2);
  EXPECT_EQ(inside.solve(), ob::PlannerStatus::INVALID_GOAL);
  EXPECT_TRUE(inside.planner->proved_no_path());
}

TEST(VoronoiRoadmap, LeavesAStartThatIsTooClose) {
  PointWorld world = around_a_post();
  world.start = {-0.6, 0.1};  // 10 cm from the post
  Posed posed(world, 0.2);
  ASSERT_EQ(posed.solve(), ob::PlannerStatus::EXACT_SOLUTION);
  EXPECT_TRUE(posed.path().check());
}

TEST(VoronoiRoadmap, AnswersTheSameWithAndWithoutClear) {
  Random random(3);
  const PointWorld world = forest(random, 0.2, 12);
  Posed posed(world, 0.2);
  ASSERT_TRUE(posed.solve());
  const Path first = to_path(posed.path());
  posed.planner->clear();
  posed.planner->clear();
  posed.planner->setProblemDefinition(posed.problem.definition());
  posed.problem.definition()->clearSolutionPaths();
  ASSERT_TRUE(posed.solve());
  EXPECT_EQ(to_path(posed.path()).length_m(), first.length_m());
  ASSERT_TRUE(posed.solve());
}

TEST(VoronoiRoadmap, TakesNewPointsInWhenAskedAgain) {
  PointWorld world = around_a_post();
  Posed posed(world, 0.2);
  ASSERT_TRUE(posed.solve());
  const double before = posed.path().length();
  std::vector<Vec2> wall;
  add_wall(wall, {0, -5}, {0, 3});
  posed.known.see(wall);
  posed.problem.update(posed.known.snapshot(), world.start);
  posed.planner->clear();
  ASSERT_TRUE(posed.solve());
  EXPECT_GT(posed.path().length(), before + 1);
  EXPECT_TRUE(posed.path().check());
}

TEST(VoronoiRoadmap, StopsAtOnceWhenToldTo) {
  Posed posed(around_a_post(), 0.2);
  EXPECT_FALSE(posed.planner->solve(ob::plannerAlwaysTerminatingCondition()));
  EXPECT_FALSE(posed.planner->proved_no_path());
  EXPECT_TRUE(posed.solve());
}

TEST(VoronoiRoadmap, ShowsItsRoadmapWithStartAndGoal) {
  Posed posed(around_a_post(), 0.2);
  ASSERT_TRUE(posed.solve());
  ob::PlannerData data(posed.problem.space_information());
  posed.planner->getPlannerData(data);
  EXPECT_EQ(data.numStartVertices(), 1u);
  EXPECT_EQ(data.numGoalVertices(), 1u);
  EXPECT_GT(data.numVertices(), 20u);
  EXPECT_GT(data.numEdges(), 20u);
  EXPECT_EQ(data.properties.count("best cost REAL"), 1u);
  EXPECT_EQ(data.properties.count("roadmap edges INTEGER"), 1u);
  ob::Cost cost;
  const std::vector<unsigned> neighbours = [&] {
    std::vector<unsigned> edges;
    data.getEdges(data.getStartIndex(0), edges);
    return edges;
  }();
  ASSERT_EQ(neighbours.size(), 1u);
  ASSERT_TRUE(data.getEdgeWeight(data.getStartIndex(0), neighbours[0], &cost));
  EXPECT_GT(cost.value(), 0);
}

TEST(VoronoiRoadmap, ChoosesTheBestOfSeveralStartsAndGoals) {
  const PointWorld world = around_a_post();
  Posed posed(world, 0.2);
  const auto& si = posed.problem.space_information();
  const auto state_at = [&](const Vec2& p) {
    ob::ScopedState<> state(si);
    set_position(*si->getStateSpace(), state.get(), p);
    return state;
  };
  auto goals = std::make_shared<ob::GoalStates>(si);
  goals->addState(state_at({4, 4}));
  goals->addState(state_at({-3, 3}));
  posed.problem.definition()->setGoal(goals);
  posed.problem.definition()->addStartState(state_at({-3, 2.5}));
  posed.planner->clear();
  ASSERT_TRUE(posed.solve());
  EXPECT_NEAR(posed.path().length(), 0.5, 1e-9);
}

TEST(VoronoiRoadmap, DeclaresItsConfigAsParameters) {
  Posed posed(around_a_post(), 0.2);
  EXPECT_TRUE(posed.planner->params().setParam("shortening", "none"));
  ASSERT_TRUE(posed.solve());
  const double along_the_graph = posed.path().length();
  EXPECT_TRUE(posed.planner->params().setParam("shortening", "channel"));
  posed.problem.definition()->clearSolutionPaths();
  ASSERT_TRUE(posed.solve());
  EXPECT_LT(posed.path().length(), 0.9 * along_the_graph);
  EXPECT_FALSE(posed.planner->params().setParam("goals_max", "0"));
}

// Nothing but a validity check: two blocks with a gap of 0.2 between them.
bool outside_of_blocks(const Vec2& p) {
  return !(std::abs(p.x()) < 0.3 && (p.y() < 0.4 || p.y() > 0.6));
}

template <class Space>
void expect_solves_with_isvalid_only(const std::shared_ptr<Space>& space) {
  ob::RealVectorBounds bounds(2);
  bounds.setLow(-1);
  bounds.setHigh(1);
  space->setBounds(bounds);
  og::SimpleSetup setup(space);
  setup.setStateValidityChecker(
      [&](const ob::State* state) { return outside_of_blocks(position_of(*space, state)); });
  ob::ScopedState<> start(space), goal(space);
  start.random();
  set_position(*space, start.get(), {-0.9, -0.9});
  goal = start;
  set_position(*space, goal.get(), {0.9, 0.9});
  setup.setStartAndGoalStates(start, goal, 0.01);
  auto planner = std::make_shared<VoronoiRoadmap>(setup.getSpaceInformation());
  setup.setPlanner(planner);
  ASSERT_EQ(setup.solve(5.0), ob::PlannerStatus::EXACT_SOLUTION);
  EXPECT_TRUE(setup.getSolutionPath().check());
  EXPECT_LT(setup.getSolutionPath().length(), 3);
  EXPECT_FALSE(planner->getSpecs().provingSolutionNonExistence);

  setup.setStateValidityChecker(
      [&](const ob::State* state) { return std::abs(position_of(*space, state).x()) > 0.3; });
  setup.clear();
  EXPECT_FALSE(setup.solve(5.0));
  EXPECT_FALSE(planner->proved_no_path());
}

TEST(VoronoiRoadmap, SolvesInABareSetupOfThePlane) {
  expect_solves_with_isvalid_only(std::make_shared<ob::RealVectorStateSpace>(2));
}

TEST(VoronoiRoadmap, SolvesInABareSetupOfRoundRobotsWithHeading) {
  expect_solves_with_isvalid_only(std::make_shared<ob::SE2StateSpace>());
}

TEST(VoronoiRoadmap, RefusesASpaceWithoutAPlane) {
  auto space = std::make_shared<ob::RealVectorStateSpace>(3);
  space->setBounds(-1, 1);
  auto si = std::make_shared<ob::SpaceInformation>(space);
  VoronoiRoadmap planner(si);
  EXPECT_THROW(planner.setup(), ompl::Exception);
}

}  // namespace
}  // namespace voronaut
