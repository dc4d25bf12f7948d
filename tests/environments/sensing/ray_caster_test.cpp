#include "voronaut/environments/sensing/ray_caster.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "voronaut/tests/environments/shapes/random_shapes.h"

namespace voronaut {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kMiss = std::numeric_limits<double>::infinity();

// The plain way: every ray against every shape, in the world frame. Shapes grown by grow_m.
double brute_force(const Shapes& shapes, const Vec2& p, const Vec2& d, double range_m,
                   double grow_m) {
  if (clearance_m(shapes, p) <= -grow_m) return 0;
  double nearest_m = range_m;
  for (const Circle& circle : shapes.circles) {
    const Vec2 c = circle.center - p;
    const double r = circle.radius_m + grow_m;
    const double chord_sq = r * r - cross(d, c) * cross(d, c);
    if (chord_sq >= 0 && d.dot(c) >= 0) {
      nearest_m = std::min(nearest_m, std::max(0.0, d.dot(c) - std::sqrt(chord_sq)));
    }
  }
  const auto wall = [&](const Segment& s) {
    const Vec2 along = (s.b - s.a).normalized();
    const Vec2 a = s.a - grow_m * along;
    const Vec2 b = s.b + grow_m * along;
    const double turn = cross(d, b - a);
    if (turn == 0) return;
    const double t = cross(a - p, b - a) / turn;
    const double u = cross(a - p, d) / turn;
    if (t >= 0 && u >= 0 && u <= 1) nearest_m = std::min(nearest_m, t);
  };
  for (const Segment& s : shapes.segments) wall(s);
  for (const Polygon& polygon : shapes.polygons) {
    for (std::size_t i = 0; i < polygon.vertices.size(); ++i) wall(edge(polygon, i));
  }
  return nearest_m;
}

// Whether a ray grazes a shape is up to rounding, so shapes a little larger and a little smaller
// must bracket the answer.
constexpr double kGrazingM = 1e-12;
constexpr double kToleranceM = 1e-9;

void expect_exact(const Shapes& shapes, const Vec2& p, const Vec2& d, double range_m,
                  double cast_m) {
  EXPECT_GE(cast_m, brute_force(shapes, p, d, range_m, kGrazingM) - kToleranceM);
  EXPECT_LE(cast_m, brute_force(shapes, p, d, range_m, -kGrazingM) + kToleranceM);
}

std::vector<double> scan(const Shapes& shapes, const Pose2& pose, const BeamFan& fan,
                         double range_m) {
  std::vector<double> ranges(fan.direction_sensor.size());
  cast_fan(ShapeIndex(shapes), pose, fan, range_m, ranges);
  return ranges;
}

Vec2 in_world(const Pose2& pose, const Vec2& d) {
  const Vec2& h = pose.heading;
  return {h.x() * d.x() - h.y() * d.y(), h.y() * d.x() + h.x() * d.y()};
}

TEST(RayCaster, FansAndSingleRaysAgreeWithBruteForceOnRandomShapes) {
  const double fields_rad[] = {0, 0.3, kPi / 2, kPi - 1e-7, kPi, 4.0, 6.2, 2 * kPi};
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random rng(seed);
    const Shapes shapes = random_shapes(rng, 1 + static_cast<int>(rng.below(25)), 10, 0.8);
    const ShapeIndex index(shapes);
    const double range_m = rng.uniform(0.5, 15);
    for (const double field_rad : fields_rad) {
      const std::size_t rays = 1 + rng.below(90);
      const BeamFan fan = BeamFan::spread(field_rad, rays);
      const Pose2 pose{random_point(rng, 12), random_direction(rng)};
      std::vector<double> ranges(rays);
      cast_fan(index, pose, fan, range_m, ranges);
      for (std::size_t i = 0; i < rays; ++i) {
        const Vec2 d = in_world(pose, fan.direction_sensor[i]);
        expect_exact(shapes, pose.p_world, d, range_m, ranges[i]);
        expect_exact(shapes, pose.p_world, d, range_m, cast_ray(index, pose.p_world, d, range_m));
      }
      if (HasFailure()) return;
    }
  }
}

TEST(RayCaster, RandomShapesAreHitOftenEnoughToTestAnything) {
  Random rng(7);
  int hits = 0;
  int blind = 0;
  for (int i = 0; i < 200; ++i) {
    const Shapes shapes = random_shapes(rng, 10, 10, 0.8);
    const Pose2 pose{random_point(rng, 12), random_direction(rng)};
    for (const double r : scan(shapes, pose, BeamFan::spread(2 * kPi, 10), 5)) {
      hits += r > 0 && r < 5;
      blind += r == 0;
    }
  }
  EXPECT_GT(hits, 300);
  EXPECT_GT(blind, 30);
}

TEST(RayCaster, BeamsInAnyOrderOfTheCircleAreSweptRoundTheSeam) {
  // A circle behind the sensor covers the last beams and the first ones.
  const BeamFan fan = BeamFan::spread(2 * kPi, 8);
  Shapes shapes;
  shapes.circles = {{Vec2(-2, 0), 1.9}};
  const std::vector<double> ranges = scan(shapes, {}, fan, 5);
  const double slant_m = std::sqrt(2) - std::sqrt(1.9 * 1.9 - 2);
  EXPECT_NEAR(ranges[0], 0.1, 1e-12);
  EXPECT_NEAR(ranges[1], slant_m, 1e-12);
  EXPECT_NEAR(ranges[7], slant_m, 1e-12);
  for (const std::size_t i : {2, 3, 4, 5, 6}) EXPECT_EQ(ranges[i], 5);
}

TEST(RayCaster, TangentRayTouchesTheCircle) {
  Shapes shapes;
  shapes.circles = {{Vec2(3, 1), 1}};
  EXPECT_EQ(scan(shapes, {}, BeamFan::spread(0, 1), 5)[0], 3);
  EXPECT_EQ(cast_ray(ShapeIndex(shapes), Vec2(0, 0), Vec2(1, 0), 5), 3);
  shapes.circles = {{Vec2(3, -1), 1}};
  EXPECT_EQ(scan(shapes, {}, BeamFan::spread(0, 1), 5)[0], 3);
  shapes.circles = {{Vec2(3, 1 + 1e-9), 1}};
  EXPECT_EQ(scan(shapes, {}, BeamFan::spread(0, 1), 5)[0], 5);
}

TEST(RayCaster, BeamsTangentToCirclesAreDecidedByTheCircleAlone) {
  // At the origin, looking along x, nothing is rounded on the way to the formula of a single ray.
  for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
    Random rng(seed);
    const BeamFan fan = BeamFan::spread(seed % 2 == 0 ? kPi / 2 : 2 * kPi, 2 + rng.below(60));
    const Vec2 beam = fan.direction_sensor[rng.below(fan.direction_sensor.size())];
    const double radius_m = rng.uniform(0.05, 0.5);
    const double side = seed % 4 < 2 ? radius_m : -radius_m;
    Shapes shapes;
    shapes.circles = {{rng.uniform(0.6, 3) * beam + side * left_of(beam), radius_m}};
    const std::vector<double> ranges = scan(shapes, {}, fan, 5);
    const Vec2 c = shapes.circles[0].center;
    for (std::size_t i = 0; i < ranges.size(); ++i) {
      const Vec2& d = fan.direction_sensor[i];
      const double chord_sq = radius_m * radius_m - cross(d, c) * cross(d, c);
      const bool hit = chord_sq >= 0 && d.dot(c) >= 0;
      EXPECT_EQ(ranges[i], hit ? d.dot(c) - std::sqrt(chord_sq) : 5) << "seed " << seed;
    }
  }
}

TEST(RayCaster, RaysAlongAnAxisStayInTheirColumn) {
  Shapes shapes;
  for (int i = 0; i < 30; ++i) shapes.circles.push_back({Vec2(i, i), 0.25});
  const ShapeIndex index(shapes);
  for (const double zero : {0.0, -0.0}) {
    EXPECT_EQ(cast_ray(index, Vec2(20, 0), Vec2(zero, 1), 50), 19.75);
    EXPECT_EQ(cast_ray(index, Vec2(20, 29), Vec2(zero, -1), 50), 8.75);
    EXPECT_EQ(cast_ray(index, Vec2(0, 20), Vec2(1, zero), 50), 19.75);
    EXPECT_EQ(cast_ray(index, Vec2(29, 20), Vec2(-1, zero), 50), 8.75);
    EXPECT_EQ(cast_ray(index, Vec2(20, -40), Vec2(zero, 1), 100), 59.75);
    EXPECT_EQ(cast_ray(index, Vec2(40, -40), Vec2(zero, 1), 100), 100);
  }
}

TEST(RayCaster, WallSeenEdgeOnIsHitAtItsNearerEnd) {
  for (const bool turned : {false, true}) {
    Shapes shapes;
    shapes.segments = {turned ? Segment{Vec2(3, 0), Vec2(2, 0)} : Segment{Vec2(2, 0), Vec2(3, 0)}};
    const ShapeIndex index(shapes);
    EXPECT_EQ(scan(shapes, {}, BeamFan::spread(kPi / 2, 3), 5), (std::vector<double>{5, 2, 5}));
    EXPECT_EQ(scan(shapes, {}, BeamFan::spread(2 * kPi, 4), 5), (std::vector<double>{5, 5, 2, 5}));
    EXPECT_EQ(cast_ray(index, Vec2(0, 0), Vec2(1, 0), 5), 2);
    EXPECT_EQ(cast_ray(index, Vec2(0, 0), Vec2(-1, 0), 5), 5);
    EXPECT_EQ(cast_ray(index, Vec2(5, 0), Vec2(-1, 0), 5), 2);
  }
}

TEST(RayCaster, SensorInOrOnAShapeMeasuresNothing) {
  const BeamFan fan = BeamFan::spread(kPi / 2, 5);
  const std::vector<double> zeros(5, 0.0);
  Shapes round;
  round.circles = {{Vec2(0.5, 0), 1}, {Vec2(3, 0), 1}};
  EXPECT_EQ(scan(round, {}, fan, 5), zeros);
  EXPECT_EQ(scan(round, {Vec2(-0.5, 0), Vec2(-1, 0)}, fan, 5), zeros);  // on the rim, looking away
  EXPECT_EQ(cast_ray(ShapeIndex(round), Vec2(0, 0), Vec2(1, 0), 5), 0);
  Shapes square;
  square.polygons = {box(Vec2(0, 0), 2, 2)};
  EXPECT_EQ(scan(square, {}, fan, 5), zeros);
  EXPECT_EQ(scan(square, {Vec2(1, 0.5), Vec2(1, 0)}, fan, 5), zeros);
  EXPECT_EQ(cast_ray(ShapeIndex(square), Vec2(0, 0), Vec2(1, 0), 5), 0);
  Shapes wall;
  wall.segments = {{Vec2(-1, 0), Vec2(1, 0)}};
  EXPECT_EQ(scan(wall, {}, fan, 5), zeros);
  EXPECT_EQ(cast_ray(ShapeIndex(wall), Vec2(0, 0), Vec2(0, 1), 5), 0);
}

TEST(RayCaster, TouchingShapesLeaveNoSlit) {
  Shapes wall;
  for (int i = -20; i < 20; ++i) wall.polygons.push_back(box(Vec2(2.5, i + 0.5), 1, 1));
  Random rng(3);
  for (int i = 0; i < 200; ++i) {
    const Pose2 pose{Vec2(0, rng.uniform(-5, 5)), Vec2(1, 0)};
    for (const double r : scan(wall, pose, BeamFan::spread(2, 100), 100)) EXPECT_LT(r, 10);
  }
  // Rays exactly through the joints.
  for (int i = -20; i <= 20; ++i) {
    EXPECT_EQ(cast_ray(ShapeIndex(wall), Vec2(0, i), Vec2(1, 0), 100), 2);
    EXPECT_EQ(scan(wall, {Vec2(0, i), Vec2(1, 0)}, BeamFan::spread(0, 1), 100)[0], 2);
  }
}

TEST(RayCaster, NothingWithinReachIsTheMaximumRange) {
  EXPECT_EQ(scan({}, {}, BeamFan::spread(kPi, 4), 5), std::vector<double>(4, 5.0));
  Shapes shapes;
  shapes.circles = {{Vec2(6.5, 0), 1}};
  EXPECT_EQ(scan(shapes, {}, BeamFan::spread(0, 1), 5)[0], 5);
  EXPECT_EQ(cast_ray(ShapeIndex(shapes), Vec2(0, 0), Vec2(1, 0), 5), 5);
  EXPECT_EQ(cast_ray(ShapeIndex(), Vec2(0, 0), Vec2(1, 0), 5), 5);
}

}  // namespace
}  // namespace voronaut
