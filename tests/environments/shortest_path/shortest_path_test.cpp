#include "voronaut/environments/shortest_path/shortest_path.h"

#include <cmath>
#include <numbers>
#include <queue>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "voronaut/tests/environments/shapes/random_shapes.h"

namespace voronaut {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kNoPath = std::numeric_limits<double>::infinity();
const Bounds kBounds{Vec2(-10, -10), Vec2(10, 10)};

double length_m(const World& world, const Vec2& start, const Vec2& goal, double radius_m) {
  const auto path = shortest_path(world, start, goal, radius_m);
  return path ? path->length_m : kNoPath;
}

// Around one rim of radius rho from distance a to distance b on opposite sides of its centre.
double around_m(double a, double b, double rho) {
  return std::sqrt(a * a - rho * rho) + std::sqrt(b * b - rho * rho) +
         rho * (kPi - std::acos(rho / a) - std::acos(rho / b));
}

World with_circles(std::vector<Circle> circles) {
  Shapes shapes;
  shapes.circles = std::move(circles);
  return {kBounds, shapes};
}

// It connects start and goal, is as long as it says, and the disc touches nothing on it.
void expect_sound(const World& world, const ShortestPath& shortest, const Vec2& start,
                  const Vec2& goal, double radius_m) {
  const Path& path = shortest.path;
  EXPECT_LT((path.front() - start).norm(), 1e-8);
  EXPECT_LT((path.back() - goal).norm(), 1e-8);
  EXPECT_NEAR(path.length_m(), shortest.length_m, 1e-9);
  // Points so close that no chord is farther than 2e-6 radii from its arc.
  const double step_m = 4e-3 * radius_m;
  Vec2 at = path.front();
  for (int i = 1; i * step_m < path.length_m() + step_m; ++i) {
    const Vec2 next = path.point_at(i * step_m);
    EXPECT_TRUE(world.bounds().contains(next));
    EXPECT_TRUE(world.segment_is_clear(at, next, radius_m * (1 - 1e-5)));
    at = next;
  }
}

TEST(ShortestPath, IsTheStraightLineWhereNothingIsInTheWay) {
  const World world = with_circles({{Vec2(0, 3), 1}});
  const auto path = shortest_path(world, Vec2(-5, 0), Vec2(5, 0), 0.5);
  ASSERT_TRUE(path);
  EXPECT_DOUBLE_EQ(path->length_m, 10);
  EXPECT_EQ(path->path.segments().size(), 1U);
  EXPECT_EQ(length_m({kBounds, {}}, Vec2(-5, 0), Vec2(5, 0), 0.5), 10);
  EXPECT_EQ(length_m(world, Vec2(1, 1), Vec2(1, 1), 0.5), 0);
}

TEST(ShortestPath, WindsAroundOneCircle) {
  const World world = with_circles({{Vec2(0, 0), 1}});
  const auto path = shortest_path(world, Vec2(-5, 0), Vec2(3, 0), 0.5);
  ASSERT_TRUE(path);
  EXPECT_NEAR(path->length_m, around_m(5, 3, 1.5), 1e-12);
  ASSERT_EQ(path->path.segments().size(), 3U);
  EXPECT_TRUE(path->path.segments()[1].kind == PathSegment::Kind::arc);
  expect_sound(world, *path, Vec2(-5, 0), Vec2(3, 0), 0.5);
}

TEST(ShortestPath, TakesTheShorterSide) {
  const World world = with_circles({{Vec2(0, 0.5), 2}});
  const auto path = shortest_path(world, Vec2(-5, 0), Vec2(5, 0), 0.5);
  ASSERT_TRUE(path);
  EXPECT_LT(path->path.segments()[1].start.y(), 0);
  EXPECT_TRUE(path->path.segments()[1].counter_clockwise);
}

TEST(ShortestPath, CrossesFromOneCircleToTheOther) {
  // Point symmetric: over the first, under the second; from the inner tangent of the two rims.
  const World world = with_circles({{Vec2(-2, -1), 1}, {Vec2(2, 1), 1}});
  const double rho = 1.25;
  const double from_start_m = std::sqrt(std::pow(5, 2) + 1 - rho * rho);
  const double to_middle_m = std::sqrt(5 - rho * rho);
  const double at_start_rad = std::atan2(-1, 5) + std::asin(rho / std::sqrt(26.0));
  const double inner_rad = std::atan2(1, 2) - std::asin(rho / std::sqrt(5.0));
  const double expected_m = 2 * (from_start_m + to_middle_m + rho * (at_start_rad - inner_rad));
  EXPECT_NEAR(length_m(world, Vec2(-7, 0), Vec2(7, 0), 0.25), expected_m, 1e-12);
}

TEST(ShortestPath, PassesAGapOfItsOwnWidthAndNoNarrowerOne) {
  const double radius_m = 0.5;
  const auto gap = [&](double width_m) {
    Shapes shapes;
    shapes.segments = {{Vec2(0, width_m / 2), Vec2(0, 15)}, {Vec2(0, -width_m / 2), Vec2(0, -15)}};
    return length_m({kBounds, shapes}, Vec2(-3, 2), Vec2(3, 2), radius_m);
  };
  EXPECT_LT(gap(1 + 1e-6), kNoPath);
  EXPECT_LT(gap(1), kNoPath);
  EXPECT_EQ(gap(1 - 1e-6), kNoPath);
  const auto circles = [&](double width_m) {
    Shapes shapes;
    shapes.circles = {{Vec2(0, 6 + width_m / 2), 6}, {Vec2(0, -6 - width_m / 2), 6}};
    return length_m({kBounds, shapes}, Vec2(-7, 0), Vec2(7, 0), radius_m);
  };
  EXPECT_NEAR(circles(1 + 1e-6), 14, 1e-12);
  EXPECT_NEAR(circles(1), 14, 1e-12);
  EXPECT_EQ(circles(1 - 1e-6), kNoPath);
}

TEST(ShortestPath, GoesRoundAWallEnd) {
  Shapes shapes;
  shapes.segments = {{Vec2(0, -15), Vec2(0, 2)}};
  const World world(kBounds, shapes);
  const auto path = shortest_path(world, Vec2(-4, 0), Vec2(4, 0), 0.5);
  ASSERT_TRUE(path);
  // The wall's end is a rim of 0.5 m around (0, 2).
  const double slant_m = std::sqrt(20 - 0.25);
  const double rise_rad = std::atan2(2, 4) + std::asin(0.5 / std::sqrt(20));
  EXPECT_NEAR(path->length_m, 2 * (slant_m + 0.5 * rise_rad), 1e-12);
  expect_sound(world, *path, Vec2(-4, 0), Vec2(4, 0), 0.5);
}

TEST(ShortestPath, FollowsTheSideOfABox) {
  Shapes shapes;
  shapes.polygons = {box(Bounds{Vec2(-2, -9.9), Vec2(2, 1)})};
  const World world(kBounds, shapes);
  const auto path = shortest_path(world, Vec2(-6, -2), Vec2(6, -2), 0.5);
  ASSERT_TRUE(path);
  const double slant_m = std::sqrt(25 - 0.25);
  const double rise_rad = std::atan2(3, 4) + std::asin(0.1);
  EXPECT_NEAR(path->length_m, 2 * (slant_m + 0.5 * rise_rad) + 4, 1e-12);
  expect_sound(world, *path, Vec2(-6, -2), Vec2(6, -2), 0.5);
}

TEST(ShortestPath, JointsInAWallOfBoxesChangeNothing) {
  Shapes whole;
  whole.polygons = {box(Bounds{Vec2(-1, -6), Vec2(1, 6)})};
  Shapes bricks;
  for (int i = 0; i < 40; ++i) {
    const double y = -6 + 0.3 * i;
    bricks.polygons.push_back(box(Bounds{Vec2(-1, y), Vec2(0, y + 0.3)}));
    bricks.polygons.push_back(box(Bounds{Vec2(0, y), Vec2(1, y + 0.3)}));
  }
  const Vec2 start(-5, 0.1);
  const Vec2 goal(5, -0.7);
  EXPECT_NEAR(length_m({kBounds, bricks}, start, goal, 0.4),
              length_m({kBounds, whole}, start, goal, 0.4), 1e-9);
}

TEST(ShortestPath, DoesNotExistOutOfAClosedRoom) {
  Shapes shapes;
  shapes.segments = {{Vec2(-2, -2), Vec2(2, -2)},
                     {Vec2(2, -2), Vec2(2, 2)},
                     {Vec2(2, 2), Vec2(-2, 2)},
                     {Vec2(-2, 2), Vec2(-2, -2)}};
  EXPECT_EQ(length_m({kBounds, shapes}, Vec2(0, 0), Vec2(5, 0), 0.3), kNoPath);
  EXPECT_EQ(length_m({kBounds, shapes}, Vec2(5, 0), Vec2(0, 0), 0.3), kNoPath);
  EXPECT_LT(length_m({kBounds, shapes}, Vec2(-1, 0), Vec2(1, 1), 0.3), kNoPath);
  shapes.segments.pop_back();
  EXPECT_LT(length_m({kBounds, shapes}, Vec2(0, 0), Vec2(5, 0), 0.3), kNoPath);
}

TEST(ShortestPath, StaysWithinTheBounds) {
  // The short way round leads over the edge; the room left below is the whole difference.
  const auto world = [](double low) {
    Shapes shapes;
    shapes.circles = {{Vec2(0, 0), 2}};
    return World({Vec2(-10, low), Vec2(10, 4)}, shapes);
  };
  const Vec2 start(-5, -0.1);
  const Vec2 goal(5, -0.1);
  const auto below = shortest_path(world(-2.5), start, goal, 0.5);
  const auto above = shortest_path(world(-2.4999), start, goal, 0.5);
  ASSERT_TRUE(below && above);
  EXPECT_LT(below->path.segments()[1].start.y(), 0);
  EXPECT_GT(above->path.segments()[1].start.y(), 0);
  EXPECT_GT(above->length_m, below->length_m);
}

TEST(ShortestPath, MayStartAndEndInContact) {
  const World world = with_circles({{Vec2(0, 0), 1}});
  EXPECT_NEAR(length_m(world, Vec2(-1.5, 0), Vec2(1.5, 0), 0.5), 1.5 * kPi, 1e-9);
  EXPECT_NEAR(length_m(world, Vec2(-1.5, 0), Vec2(0, 1.5), 0.5), 0.75 * kPi, 1e-9);
  EXPECT_NEAR(length_m(world, Vec2(-1.5, 0), Vec2(-4, 0), 0.5), 2.5, 1e-12);
  EXPECT_EQ(length_m(world, Vec2(-1.49, 0), Vec2(-4, 0), 0.5), kNoPath);
  EXPECT_EQ(length_m(world, Vec2(-4, 0), Vec2(-1.49, 0), 0.5), kNoPath);
  EXPECT_EQ(length_m(world, Vec2(-4, 0), Vec2(-11, 0), 0.5), kNoPath);
}

TEST(ShortestPath, RefusesARadiusThatIsNone) {
  for (const double radius_m : {0.0, -1.0, std::nan(""), kNoPath}) {
    EXPECT_THROW(shortest_path({kBounds, {}}, Vec2(0, 0), Vec2(1, 0), radius_m),
                 std::invalid_argument);
  }
}

// Random worlds with free starts and goals.
struct Problem {
  World world;
  Vec2 start;
  Vec2 goal;
  double radius_m;
};

Problem random_problem(std::uint64_t seed, int count) {
  Random rng(seed);
  const double radius_m = rng.uniform(0.15, 0.5);
  World world({Vec2(-6, -6), Vec2(6, 6)}, random_shapes(rng, count, 6, 0.6));
  const auto free_point = [&] {
    Vec2 p = random_point(rng, 6);
    while (world.clearance_m(p) < radius_m) p = random_point(rng, 6);
    return p;
  };
  const Vec2 start = free_point();
  return {world, start, free_point(), radius_m};
}

// Dijkstra on a grid of step_m through start: king's and knight's moves, each tested exactly. The
// disc is smaller by slack_m and the bounds are wider by it.
double lattice_length_m(const Problem& problem, double step_m, double slack_m) {
  const double radius_m = problem.radius_m - slack_m;
  const Bounds& bounds = problem.world.bounds();
  const Bounds wider{bounds.min - Vec2::Constant(slack_m), bounds.max + Vec2::Constant(slack_m)};
  const int half = static_cast<int>(12 / step_m);
  const int side = 2 * half + 1;
  std::vector<double> best(static_cast<std::size_t>(side * side), kNoPath);
  using Item = std::pair<double, int>;
  std::priority_queue<Item, std::vector<Item>, std::greater<>> queue;
  const auto at = [&](int x, int y) -> Vec2 { return problem.start + step_m * Vec2(x, y); };
  queue.push({0, half * side + half});
  best[static_cast<std::size_t>(half * side + half)] = 0;
  double found_m = kNoPath;
  while (!queue.empty()) {
    const auto [length, node] = queue.top();
    queue.pop();
    if (length > best[static_cast<std::size_t>(node)]) continue;
    if (length >= found_m) break;
    const int x = node % side - half;
    const int y = node / side - half;
    const Vec2 p = at(x, y);
    if ((problem.goal - p).norm() <= 2 * step_m &&
        problem.world.segment_is_clear(p, problem.goal, radius_m)) {
      found_m = std::min(found_m, length + (problem.goal - p).norm());
    }
    for (int dx = -2; dx <= 2; ++dx) {
      for (int dy = -2; dy <= 2; ++dy) {
        if ((dx == 0 && dy == 0) || std::abs(dx) + std::abs(dy) > 3) continue;
        const int nx = x + dx;
        const int ny = y + dy;
        if (std::abs(nx) > half || std::abs(ny) > half) continue;
        const Vec2 q = at(nx, ny);
        const auto next = static_cast<std::size_t>((ny + half) * side + nx + half);
        const double onward = length + (q - p).norm();
        if (onward >= best[next] || !wider.contains(q)) continue;
        if (!problem.world.segment_is_clear(p, q, radius_m)) continue;
        best[next] = onward;
        queue.push({onward, static_cast<int>(next)});
      }
    }
  }
  return found_m;
}

TEST(ShortestPath, LiesBetweenTheBestLatticePathsOfThisDiscAndOfASmallerOne) {
  int found = 0;
  int missing = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Problem problem = random_problem(seed, 15 + static_cast<int>(seed % 30));
    const auto path = shortest_path(problem.world, problem.start, problem.goal, problem.radius_m);
    const double above_m = lattice_length_m(problem, 0.1, 0);
    if (!path) {
      ++missing;
      EXPECT_EQ(above_m, kNoPath);
      continue;
    }
    ++found;
    expect_sound(problem.world, *path, problem.start, problem.goal, problem.radius_m);
    EXPECT_GE(path->length_m, (problem.goal - problem.start).norm() - 1e-12);
    EXPECT_LE(path->length_m, above_m + 1e-9);
    // A disc smaller by a step can follow the path from node to node. Knight's moves lose up to
    // 2.8 % of a free way.
    EXPECT_GE(path->length_m, (lattice_length_m(problem, 0.1, 0.1) - 0.3) / 1.04);
  }
  EXPECT_GE(found, 15);
  EXPECT_GE(missing, 8);
}

TEST(ShortestPath, IsAsLongBackwards) {
  int found = 0;
  for (std::uint64_t seed = 1; seed <= 150; ++seed) {
    const Problem p = random_problem(seed, 12);
    const double forth_m = length_m(p.world, p.start, p.goal, p.radius_m);
    const double back_m = length_m(p.world, p.goal, p.start, p.radius_m);
    if (forth_m == kNoPath) {
      EXPECT_EQ(back_m, kNoPath) << "seed " << seed;
    } else {
      ++found;
      EXPECT_NEAR(back_m, forth_m, 1e-8) << "seed " << seed;
    }
  }
  EXPECT_GE(found, 30);
}

TEST(ShortestPath, TurnsWithTheWorld) {
  // The bounds do not turn, so they are out of reach.
  const Bounds far{Vec2(-100, -100), Vec2(100, 100)};
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    Random rng(seed);
    const Shapes shapes = random_shapes(rng, 12, 6, 0.6);
    const Vec2 turn = random_direction(rng);
    const auto turned = [&](const Vec2& p) -> Vec2 {
      return {turn.x() * p.x() - turn.y() * p.y(), turn.y() * p.x() + turn.x() * p.y()};
    };
    Shapes turned_shapes = shapes;
    for (Circle& c : turned_shapes.circles) c.center = turned(c.center);
    for (Segment& s : turned_shapes.segments) s = {turned(s.a), turned(s.b)};
    for (Polygon& g : turned_shapes.polygons) {
      for (Vec2& v : g.vertices) v = turned(v);
    }
    const Vec2 start = random_point(rng, 6);
    const Vec2 goal = random_point(rng, 6);
    const double here_m = length_m({far, shapes}, start, goal, 0.2);
    const double there_m = length_m({far, turned_shapes}, turned(start), turned(goal), 0.2);
    if (here_m == kNoPath) {
      EXPECT_EQ(there_m, kNoPath) << "seed " << seed;
    } else {
      EXPECT_NEAR(there_m, here_m, 1e-8) << "seed " << seed;
    }
  }
}

TEST(ShortestPath, GrowsWithTheRadius) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const Problem p = random_problem(seed, 10);
    double last_m = 0;
    for (const double share : {0.1, 0.4, 0.7, 1.0}) {
      const double now_m = length_m(p.world, p.start, p.goal, share * p.radius_m);
      EXPECT_GE(now_m, last_m - 1e-9) << "seed " << seed;
      last_m = now_m;
    }
  }
}

}  // namespace
}  // namespace voronaut
