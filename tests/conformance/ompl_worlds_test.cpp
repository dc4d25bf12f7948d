#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/terminationconditions/IterationTerminationCondition.h>
#include <ompl/geometric/SimpleSetup.h>

#include "voronaut/environments/shapes/shape_index.h"
#include "voronaut/planners/catalog/catalog.h"

// The conditions of OMPL's own planner tests (tests/geometric/2d of 1.5.2): a grid, and a world of
// 70 circles with 100 queries, known to the planners through a validity checker alone.
namespace voronaut::test {
namespace {

namespace ob = ompl::base;
namespace fs = std::filesystem;

fs::path data_folder() {
  const char* named = std::getenv("VORONAUT_DATA");
  const fs::path folder = named != nullptr
                              ? fs::path(named)
                              : fs::path(VORONAUT_SOURCE_DIR).parent_path() / "shared" / "data";
  return folder / "ompl";
}

struct Query {
  Vec2 start, goal;
};

struct OmplWorld {
  Shapes shapes;
  Bounds bounds{Vec2::Constant(std::numeric_limits<double>::max()),
                Vec2::Constant(std::numeric_limits<double>::lowest())};
  std::vector<Query> queries;
};

OmplWorld circle_world() {
  OmplWorld world;
  std::ifstream circles(data_folder() / "circle_obstacles.txt");
  std::string line;
  std::getline(circles, line);
  std::getline(circles, line);
  double id = 0, x = 0, y = 0, r = 0;
  while (circles >> id >> x >> y >> r) {
    world.shapes.circles.push_back({{x, y}, r});
    world.bounds.min = world.bounds.min.cwiseMin(Vec2(x - r, y - r));
    world.bounds.max = world.bounds.max.cwiseMax(Vec2(x + r, y + r));
  }
  std::ifstream queries(data_folder() / "circle_queries.txt");
  std::string word;
  Query query;
  while (queries >> id >> word >> query.start.x() >> query.start.y() >> id >> word >>
         query.goal.x() >> query.goal.y())
    world.queries.push_back(query);
  return world;
}

// Cell (i, j) is the square from (i, j) to (i+1, j+1); start and goal in the middle of theirs.
OmplWorld grid_world() {
  OmplWorld world;
  std::ifstream file(data_folder() / "env1.txt");
  const auto pair_after = [&](char mark) {
    file.ignore(std::numeric_limits<std::streamsize>::max(), mark);
    Vec2 values = Vec2::Zero();
    file >> values.x() >> values.y();
    return values;
  };
  const Vec2 size = pair_after(':');
  const Vec2 start = pair_after(':');
  const Vec2 goal = pair_after(':');
  file.ignore(std::numeric_limits<std::streamsize>::max(), ':');
  world.bounds = {Vec2::Zero(), size};
  world.queries.push_back({start + Vec2(0.5, 0.5), goal + Vec2(0.5, 0.5)});
  for (int i = 0; i < size.x(); ++i) {
    for (int j = 0; j < size.y(); ++j) {
      int blocked = 0;
      file >> blocked;
      const Vec2 corner(i, j);
      if (blocked != 0) world.shapes.polygons.push_back(box(Bounds{corner, corner + Vec2(1, 1)}));
    }
  }
  return world;
}

bool solves(const PlannerEntry& entry, const OmplWorld& world, const ShapeIndex& index,
            const Query& query) {
  auto space = std::make_shared<ob::RealVectorStateSpace>(2);
  ob::RealVectorBounds bounds(2);
  for (unsigned axis = 0; axis < 2; ++axis) {
    bounds.setLow(axis, world.bounds.min[axis]);
    bounds.setHigh(axis, world.bounds.max[axis]);
  }
  space->setBounds(bounds);
  ompl::geometric::SimpleSetup setup(space);
  setup.setStateValidityChecker([&](const ob::State* state) {
    const auto* p = state->as<ob::RealVectorStateSpace::StateType>();
    return space->satisfiesBounds(state) && index.clearance_m({p->values[0], p->values[1]}, 1) > 0;
  });
  setup.getSpaceInformation()->setStateValidityCheckingResolution(0.001);
  ob::ScopedState<> start(space), goal(space);
  start[0] = query.start.x(), start[1] = query.start.y();
  goal[0] = query.goal.x(), goal[1] = query.goal.y();
  setup.setStartAndGoalStates(start, goal, 1e-3);
  const auto planner = entry.make(setup.getSpaceInformation());
  if (planner->params().hasParam("preset")) planner->params().setParam("preset", "repaired");
  setup.setPlanner(planner);
  ob::IterationTerminationCondition most(10'000);
  setup.solve(ob::PlannerTerminationCondition(most));
  return setup.haveExactSolutionPath() && setup.getSolutionPath().check();
}

int solved_of(const char* planner, const OmplWorld& world) {
  const ShapeIndex index(world.shapes);
  const PlannerCatalog catalog = PlannerCatalog::built_in();
  int solved = 0;
  for (const Query& query : world.queries)
    solved += solves(*catalog.find(planner), world, index, query) ? 1 : 0;
  std::printf("%-16s %d of %zu\n", planner, solved, world.queries.size());
  return solved;
}

TEST(OmplWorlds, VoronoiRoadmapSolvesEveryQueryAmongTheCircles) {
  const OmplWorld world = circle_world();
  if (world.queries.empty()) GTEST_SKIP() << "no data";
  ASSERT_EQ(world.shapes.circles.size(), 70U);
  ASSERT_EQ(world.queries.size(), 100U);
  EXPECT_EQ(solved_of("VoronoiRoadmap", world), 100);
  EXPECT_GE(solved_of("RRTConnect", world), 95);
  // Reactive planners may stay in a trap: shown beside, not judged. They are most of this test's
  // time: each sensing step marches its rays through the checker.
  solved_of("ReactiveVoronoi", world);
  solved_of("PotentialField", world);
}

TEST(OmplWorlds, VoronoiRoadmapSolvesTheGrid) {
  OmplWorld world = grid_world();
  if (world.shapes.polygons.empty()) GTEST_SKIP() << "no data";
  EXPECT_EQ(solved_of("VoronoiRoadmap", world), 1);
  solved_of("ReactiveVoronoi", world);
  solved_of("PotentialField", world);
  world.queries.resize(100, world.queries.front());  // a sampler draws anew each time
  EXPECT_GE(solved_of("RRTConnect", world), 95);
}

}  // namespace
}  // namespace voronaut::test
