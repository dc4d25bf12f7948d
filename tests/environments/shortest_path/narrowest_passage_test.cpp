#include "voronaut/environments/shortest_path/narrowest_passage.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include "voronaut/environments/shortest_path/shortest_path.h"
#include "voronaut/tests/environments/shapes/random_shapes.h"

namespace voronaut {
namespace {

const Bounds kSquare{Vec2(-6, -6), Vec2(6, 6)};

// A wall across the square at x = 0 with a gap from y = 0 to y = `gap_m`.
Shapes wall_with_gap(double gap_m) {
  Shapes shapes;
  shapes.segments = {{{0, -7}, {0, 0}}, {{0, gap_m}, {0, 7}}};
  return shapes;
}

TEST(NarrowestPassage, IsTheGapThatAllWaysLeadThrough) {
  const Vec2 start(-4, 0), goal(4, 0);
  EXPECT_NEAR(narrowest_passage_m({kSquare, wall_with_gap(0.7)}, start, goal), 0.7, 1e-12);
  EXPECT_EQ(narrowest_passage_m({kSquare, wall_with_gap(0)}, start, goal), 0);
  Shapes two_gaps = wall_with_gap(0.7);
  two_gaps.segments[0].a.y() = -3;  // the other one is wider
  two_gaps.segments.push_back({{0, -7}, {0, -4.2}});
  EXPECT_NEAR(narrowest_passage_m({kSquare, two_gaps}, start, goal), 1.2, 1e-12);
  EXPECT_NEAR(narrowest_passage_m({kSquare, two_gaps}, start, Vec2(-4, 1)), 8, 1e-12)
      << "on one side of the wall it is the room around the start";
}

TEST(NarrowestPassage, OfTheCentreReachesToTheBounds) {
  Shapes shapes;
  shapes.circles = {{{0, 0}, 5}};  // 1 m is left to each side
  EXPECT_NEAR(narrowest_passage_m({kSquare, shapes}, {-5.9, -5.9}, {5.9, 5.9}), 2, 1e-12);
  shapes.segments = {{{0, 0}, {0, 7}}, {{0, -7}, {0, 0}}};
  EXPECT_EQ(narrowest_passage_m({kSquare, shapes}, {-5.9, -5.9}, {5.9, 5.9}), 0);
}

TEST(NarrowestPassage, IsNoneWhereNothingIsInTheWayOrNobodyCanStand) {
  EXPECT_EQ(narrowest_passage_m({kSquare, {}}, {-1, 0}, {1, 0}), kInfinity);
  Shapes shapes;
  shapes.circles = {{{0, 0}, 1}};
  EXPECT_EQ(narrowest_passage_m({kSquare, shapes}, {-0.5, 0}, {3, 0}), 0);
  EXPECT_EQ(narrowest_passage_m({kSquare, shapes}, {-3, 0}, {7, 0}), 0);
  EXPECT_NEAR(narrowest_passage_m({kSquare, shapes}, {-3, 0}, {-3, 0}), 4, 1e-12);
}

TEST(NarrowestPassage, OfAStraightLineThroughMiddlesAndCornersIsFoundToo) {
  // Everything lies on the line from start to goal or at right angles to it.
  Shapes shapes;
  shapes.circles = {{{0, 3}, 1}, {{0, 0}, 1}, {{0, -3}, 1}, {{0, 6}, 1}, {{0, -6}, 1}};
  shapes.segments = {{{-3, 0}, {-2, 0}}, {{2, 0}, {3, 0}}};
  EXPECT_NEAR(narrowest_passage_m({kSquare, shapes}, {-4, 0}, {4, 0}), 1, 1e-12);
  Shapes ring;  // a box around the start
  ring.polygons = {{{{-2, -2}, {-1, -2}, {-1, 2}, {-2, 2}}}};
  ring.segments = {{{-2, 2}, {-6, 2}}, {{-2, -2}, {-5.5, -2}}};
  EXPECT_NEAR(narrowest_passage_m({kSquare, ring}, {-4, 0}, {4, 0}), 1, 1e-12)
      << "twice what is left to the bounds";
}

struct Question {
  World world;
  Vec2 start, goal;
};

Question random_question(std::uint64_t seed) {
  Random rng(seed);
  World world(kSquare, random_shapes(rng, 8 + static_cast<int>(rng.below(25)), 6, 0.6));
  // With room around it, so that ways decide and not places.
  const auto free_point = [&] {
    Vec2 best = random_point(rng, 6);
    for (int i = 0; i < 50; ++i)
      if (const Vec2 p = random_point(rng, 6); world.clearance_m(p) > world.clearance_m(best))
        best = p;
    return best;
  };
  const Vec2 start = free_point();
  return {world, start, free_point()};
}

TEST(NarrowestPassage, IsWhereTheShortestPathCeasesToExist) {
  int by_room = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    const auto [world, start, goal] = random_question(seed);
    const double radius_m = narrowest_passage_m(world, start, goal) / 2;
    const double room_m = std::min(world.clearance_m(start), world.clearance_m(goal));
    EXPECT_LE(radius_m, room_m) << seed;
    by_room += radius_m == room_m;
    if (radius_m == 0) {
      EXPECT_FALSE(shortest_path(world, start, goal, 1e-4)) << seed;
      continue;
    }
    EXPECT_TRUE(shortest_path(world, start, goal, radius_m * (1 - 1e-6))) << seed;
    EXPECT_FALSE(shortest_path(world, start, goal, radius_m * (1 + 1e-6))) << seed;
  }
  EXPECT_LT(by_room, 200) << "too few that a passage decides";
}

// The best of the smallest clearances along ways of king's moves through the points of a grid.
double grid_radius_m(const Question& question, double step_m) {
  const int side = static_cast<int>(std::lround(12 / step_m)) + 1;
  const auto place = [&](int k) -> Vec2 { return kSquare.min + step_m * Vec2(k % side, k / side); };
  const auto nearest = [&](const Vec2& p) {
    const Vec2 cells = (p - kSquare.min) / step_m;
    return static_cast<int>(std::lround(cells.y())) * side +
           static_cast<int>(std::lround(cells.x()));
  };
  std::vector<double> clearance(static_cast<std::size_t>(side) * side);
  for (int k = 0; k < side * side; ++k) clearance[k] = question.world.clearance_m(place(k));
  std::vector<int> order(clearance.size()), group(clearance.size());
  std::iota(order.begin(), order.end(), 0);
  std::iota(group.begin(), group.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) { return clearance[a] > clearance[b]; });
  const auto root = [&](int k) {
    while (group[k] != k) k = group[k] = group[group[k]];
    return k;
  };
  std::vector<bool> open(clearance.size());
  for (const int k : order) {
    open[k] = true;
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        const int x = k % side + dx, y = k / side + dy;
        if (x < 0 || y < 0 || x >= side || y >= side || !open[y * side + x]) continue;
        group[root(k)] = root(y * side + x);
      }
    if (open[nearest(question.start)] && open[nearest(question.goal)] &&
        root(nearest(question.start)) == root(nearest(question.goal)))
      return clearance[k];
  }
  return 0;
}

TEST(NarrowestPassage, IsThatOfAGridUpToItsCells) {
  constexpr double kStep_m = 0.05;
  for (std::uint64_t seed = 1000; seed < 1040; ++seed) {
    const Question question = random_question(seed);
    const double radius_m = narrowest_passage_m(question.world, question.start, question.goal) / 2;
    // Clearance changes by at most what the place does: half a diagonal of a cell. Gaps narrower
    // than that may be jumped over.
    EXPECT_NEAR(std::max(radius_m, kStep_m), std::max(grid_radius_m(question, kStep_m), kStep_m),
                kStep_m * std::sqrt(0.5) + 1e-9)
        << seed;
  }
}

}  // namespace
}  // namespace voronaut
