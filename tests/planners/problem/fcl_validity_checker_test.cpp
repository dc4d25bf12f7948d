#include "voronaut/planners/problem/fcl_validity_checker.h"

#include <cstdio>

#include <gtest/gtest.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>

#include "voronaut/planners/problem/belief_validity_checker.h"
#include "voronaut/planners/problem/planar_state.h"
#include "voronaut/tests/planners/mapping/known_points.h"
#include "voronaut/tests/planners/planar_random.h"

namespace voronaut {
namespace {

namespace ob = ompl::base;
using test::base_of;
using test::PlanarRandom;

constexpr double kClearance_m = 0.4;

struct TwoOpinions {
  TwoOpinions() : si(space()), cells(si, kClearance_m), fcl(si, kClearance_m) {}

  static ob::SpaceInformationPtr space() {
    auto plane = std::make_shared<ob::RealVectorStateSpace>(2);
    plane->setBounds(0, 10);
    return std::make_shared<ob::SpaceInformation>(plane);
  }

  void look_at(const ObstacleSnapshot& obstacles, const Vec2& start) {
    cells.look_at(obstacles, start);
    fcl.look_at(obstacles, start);
  }

  ob::SpaceInformationPtr si;
  BeliefValidityChecker cells;
  FclValidityChecker fcl;
};

// True if a clearance limit of the motion lies within the tolerance: there the two may differ.
bool is_too_close_to_call(const std::vector<Vec2>& points, const Vec2& start, const Vec2& a,
                          const Vec2& b) {
  double start_m = 1e9;
  for (const Vec2& p : points) start_m = std::min(start_m, (p - start).norm());
  const StartRelaxation relaxation(kClearance_m, start, start_m);
  const ClearancePieces pieces = relaxation.split(a, b);
  for (std::size_t i = 0; i < pieces.count; ++i) {
    const ClearancePiece& piece = pieces.piece[i];
    for (const Vec2& p : points) {
      const double off_m = distance(p, Segment{piece.a, piece.b}) - piece.clearance_m;
      if (std::abs(off_m) < FclValidityChecker::kTolerance_m) return true;
    }
  }
  return false;
}

TEST(FclValidityChecker, AgreesWithTheCellListOnRandomStatesAndMotions) {
  constexpr std::uint64_t kSeed = 31;
  PlanarRandom random(kSeed);
  TwoOpinions two;
  ob::ScopedState<> state(two.si);
  int free_motions = 0;
  int too_close = 0;
  for (int world = 0; world < 40; ++world) {
    std::vector<Vec2> points;
    for (int i = 0; i < 30; ++i) points.push_back(random.point(0, 10));
    const auto base = base_of(points);
    const Vec2 start = random.point(0, 10);
    two.look_at(base->snapshot(), start);
    for (int query = 0; query < 250; ++query) {
      const Vec2 a = query % 5 == 0 ? start : random.point(0, 10);
      const Vec2 b = a + random.point(-2, 2);
      const auto where = [&] {
        return testing::Message() << "seed " << kSeed << " world " << world << " query " << query;
      };
      set_position(*two.si->getStateSpace(), state.get(), a);
      const double clearance_m = two.cells.clearance(state.get());
      if (clearance_m > FclValidityChecker::kPointRadius_m + 1e-5) {
        EXPECT_NEAR(two.fcl.clearance(state.get()), clearance_m, 1e-6) << where();
      } else {
        EXPECT_LE(two.fcl.clearance(state.get()), clearance_m + 1e-6) << where();
      }
      if (is_too_close_to_call(points, start, a, b) || is_too_close_to_call(points, start, a, a)) {
        ++too_close;
        continue;
      }
      const bool clear = two.cells.motion_is_clear(a, b);
      free_motions += clear;
      EXPECT_EQ(clear, two.fcl.motion_is_clear(a, b)) << where();
      EXPECT_EQ(two.cells.isValid(state.get()), two.fcl.isValid(state.get())) << where();
    }
  }
  EXPECT_GT(free_motions, 1000);
  EXPECT_LT(free_motions, 9000);
  EXPECT_LT(too_close, 1000);
}

// Half states, half motions; where they disagree, the limit must be within the stated tolerance of
// 1e-6 m, or the place within the point spheres of 1 cm that FCL takes for points.
TEST(FclValidityChecker, DisagreesInAMillionQueriesOnlyWithinItsTolerance) {
  constexpr std::uint64_t kSeed = 32;
  PlanarRandom random(kSeed);
  TwoOpinions two;
  ob::ScopedState<> state(two.si);
  int queries = 0;
  int clear = 0;
  int disagreements = 0;
  for (int world = 0; world < 1000; ++world) {
    std::vector<Vec2> points;
    for (int i = 0; i < 30; ++i) points.push_back(random.point(0, 10));
    const auto base = base_of(points);
    const Vec2 start = random.point(0, 10);
    two.look_at(base->snapshot(), start);
    for (int query = 0; query < 500; ++query) {
      const Vec2 a = query % 5 == 0 ? start : random.point(0, 10);
      const Vec2 b = a + random.point(-2, 2);
      const bool motion_is_clear = two.cells.motion_is_clear(a, b);
      set_position(*two.si->getStateSpace(), state.get(), a);
      const bool state_is_valid = two.cells.isValid(state.get());
      queries += 2;
      clear += motion_is_clear + state_is_valid;
      if (motion_is_clear != two.fcl.motion_is_clear(a, b)) {
        ++disagreements;
        EXPECT_TRUE(is_too_close_to_call(points, start, a, b)) << world << " " << query;
      }
      if (state_is_valid != two.fcl.isValid(state.get())) {
        ++disagreements;
        EXPECT_TRUE(is_too_close_to_call(points, start, a, a)) << world << " " << query;
      }
    }
  }
  EXPECT_EQ(queries, 1'000'000);
  EXPECT_GT(clear, 200'000);
  EXPECT_LT(clear, 800'000);
  RecordProperty("disagreements", disagreements);
  std::printf("%d queries, %d clear, %d disagreements, all within %g m of the limit\n", queries,
              clear, disagreements, FclValidityChecker::kTolerance_m);
}

TEST(FclValidityChecker, FreesAllWithinBoundsBeforeAnythingIsKnown) {
  TwoOpinions two;
  two.look_at(ObstacleSnapshot{}, {1, 1});
  ob::ScopedState<> state(two.si);
  set_position(*two.si->getStateSpace(), state.get(), {5, 5});
  EXPECT_TRUE(two.fcl.isValid(state.get()));
  EXPECT_TRUE(two.fcl.motion_is_clear({0, 0}, {10, 10}));
  set_position(*two.si->getStateSpace(), state.get(), {5, 10.5});
  EXPECT_FALSE(two.fcl.isValid(state.get()));
}

}  // namespace
}  // namespace voronaut
