#include "voronaut/dynamics/path.h"

#include <cmath>
#include <numbers>
#include <random>

#include <gmock/gmock.h>

namespace voronaut::testing {
namespace {

using Eigen::Vector2d;
using std::numbers::pi;

PathSegment quarter_arc() {
  // From (2,0) round the centre (2,2) to (4,2), counter-clockwise.
  PathSegment arc;
  arc.kind = PathSegment::Kind::arc;
  arc.start = {2, 0};
  arc.end = {4, 2};
  arc.center = {2, 2};
  return arc;
}

// A line of 2 m, a quarter circle of radius 2 m, a line of 3 m.
Path with_bend() {
  Path path = Path::through({{0, 0}, {2, 0}});
  path.append(quarter_arc());
  PathSegment up;
  up.start = {4, 2};
  up.end = {4, 5};
  path.append(up);
  return path;
}

TEST(Path, SkipsRepeatedPoints) {
  const Path path = Path::through({{0, 0}, {0, 0}, {3, 4}, {3, 4}, {3, 6}});
  EXPECT_EQ(path.segments().size(), 2);
  EXPECT_DOUBLE_EQ(path.length_m(), 7);
  EXPECT_EQ(path.front(), Vector2d(0, 0));
  EXPECT_EQ(path.back(), Vector2d(3, 6));
}

TEST(Path, OfNoOrOnePointIsEmpty) {
  EXPECT_TRUE(Path().empty());
  EXPECT_TRUE(Path::through({}).empty());
  EXPECT_TRUE(Path::through({{1, 1}}).empty());
  EXPECT_TRUE(Path::through({{1, 1}, {1, 1}}).empty());
  EXPECT_EQ(Path::through({{1, 1}}).length_m(), 0);
}

TEST(Path, MeasuresLinesAndArcs) { EXPECT_NEAR(with_bend().length_m(), 2 + pi + 3, 1e-14); }

TEST(Path, KnowsThePieceThatHoldsAStation) {
  const Path path = with_bend();
  EXPECT_EQ(path.segment_at(1).end, Vector2d(2, 0));
  EXPECT_EQ(path.segment_at(2).kind, PathSegment::Kind::arc) << "at a joint the one that starts";
  EXPECT_EQ(path.segment_at(2.5 + pi).end, Vector2d(4, 5));
  EXPECT_EQ(path.segment_at(-1).end, Vector2d(2, 0));
  EXPECT_EQ(path.segment_at(99).end, Vector2d(4, 5));
}

TEST(Path, GivesPointsAndDirectionsAlongLinesAndArcs) {
  const Path path = with_bend();
  const double half = std::numbers::sqrt2 / 2;
  EXPECT_LT((path.point_at(1) - Vector2d(1, 0)).norm(), 1e-15);
  EXPECT_LT((path.point_at(2 + pi / 2) - Vector2d(2 + 2 * half, 2 - 2 * half)).norm(), 1e-14);
  EXPECT_LT((path.direction_at(2 + pi / 2) - Vector2d(half, half)).norm(), 1e-14);
  EXPECT_LT((path.direction_at(2 + pi + 1) - Vector2d(0, 1)).norm(), 1e-15);
  EXPECT_EQ(path.point_at(-1), Vector2d(0, 0));
  EXPECT_EQ(path.point_at(100), Vector2d(4, 5));
  EXPECT_EQ(path.direction_at(100), Vector2d(0, 1));
}

TEST(Path, RunsClockwiseArcsTheOtherWay) {
  PathSegment arc = quarter_arc();
  arc.counter_clockwise = false;
  Path path;
  path.append(arc);
  EXPECT_NEAR(path.length_m(), 3 * pi, 1e-14);  // the other three quarters
  EXPECT_LT((path.point_at(pi) - Vector2d(0, 2)).norm(), 1e-14);
  EXPECT_LT((path.direction_at(pi) - Vector2d(0, 1)).norm(), 1e-14);
}

TEST(Path, TakesAnArcThatEndsWhereItStartsForTheFullCircle) {
  PathSegment arc = quarter_arc();
  arc.end = arc.start;
  Path path;
  path.append(arc);
  EXPECT_NEAR(path.length_m(), 4 * pi, 1e-14);
}

TEST(Path, ProjectsWithinTheWindowOnly) {
  // A hairpin: there and back 1 m apart.
  const Path path = Path::through({{0, 0}, {10, 0}, {10, 1}, {0, 1}});
  const Vector2d p(3, 0.9);
  const PathProjection ahead = path.project(p, 0, 9);
  EXPECT_DOUBLE_EQ(ahead.station_m, 3);
  EXPECT_NEAR(ahead.distance_m, 0.9, 1e-15);
  EXPECT_EQ(ahead.segment, 0);
  const PathProjection whole = path.project(p, 0, path.length_m());
  EXPECT_DOUBLE_EQ(whole.station_m, 18);
  EXPECT_EQ(whole.segment, 2);
  EXPECT_DOUBLE_EQ(path.project(p, 5, 8).station_m, 5);
}

TEST(Path, ProjectsLikeADenseSampleOfItself) {
  const std::uint64_t seed = 7;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937_64 engine(seed);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(engine() >> 11) * 0x1p-53;
  };
  const Path path = with_bend();
  for (int trial = 0; trial < 300; ++trial) {
    const Vector2d p(uniform(-2, 7), uniform(-2, 7));
    const double from_m = uniform(0, 8);
    const double to_m = from_m + uniform(0, 4);
    const PathProjection found = path.project(p, from_m, to_m);
    double nearest_m = 1e9;
    const double last_m = std::min(to_m, path.length_m());
    for (int i = 0; i <= 2000; ++i) {
      const double station = from_m + (last_m - from_m) * i / 2000;
      nearest_m = std::min(nearest_m, (path.point_at(station) - p).norm());
    }
    EXPECT_LE(found.distance_m, nearest_m + 1e-12);
    EXPECT_GE(found.distance_m, nearest_m - 1e-5);
    EXPECT_NEAR((path.point_at(found.station_m) - p).norm(), found.distance_m, 1e-9);
    EXPECT_GE(found.station_m, from_m - 1e-12);
    EXPECT_LE(found.station_m, last_m + 1e-12);
  }
}

TEST(PathDeathTest, AbortsOnASegmentThatStartsElsewhere) {
  Path path = Path::through({{0, 0}, {2, 0}});
  PathSegment away;
  away.start = {2, 1};
  away.end = {3, 1};
  EXPECT_DEATH(path.append(away), "starts away from the end");
}

TEST(PathDeathTest, AbortsWhenAnEmptyPathIsAsked) {
  EXPECT_DEATH(Path().point_at(0), "empty path");
  EXPECT_DEATH(Path().project({0, 0}, 0, 1), "empty path");
}

}  // namespace
}  // namespace voronaut::testing
