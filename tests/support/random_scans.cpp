#include "voronaut/tests/support/random_scans.h"

#include <array>
#include <cmath>
#include <limits>

namespace voronaut {
namespace {

double range_to(const Circle& circle, const Vec2& from, const Vec2& direction) {
  const Vec2 to_center = circle.center - from;
  const double ahead = to_center.dot(direction);
  const double aside = cross(direction, to_center);
  const double half_chord_sq = circle.radius_m * circle.radius_m - aside * aside;
  const double range = half_chord_sq < 0 ? -1 : ahead - std::sqrt(half_chord_sq);
  return range > 0 ? range : std::numeric_limits<double>::infinity();
}

double range_to(const Segment& wall, const Vec2& from, const Vec2& direction) {
  const Vec2 along = wall.b - wall.a;
  const double across = cross(direction, along);
  const double t = cross(wall.a - from, along) / across;
  const double s = cross(wall.a - from, direction) / across;
  return t > 0 && s >= 0 && s <= 1 ? t : std::numeric_limits<double>::infinity();
}

Vec2 random_point(Random& random, double side_m) {
  return {random.uniform(-side_m / 2, side_m / 2), random.uniform(-side_m / 2, side_m / 2)};
}

double broken_range(Random& random, double max_range_m) {
  const std::array<double, 5> broken{std::numeric_limits<double>::quiet_NaN(),
                                     std::numeric_limits<double>::infinity(), 0, -1,
                                     2 * max_range_m};
  return broken[random.below(broken.size())];
}

}  // namespace

ScanWorld random_scan_world(Random& random, double side_m, int circles, int walls) {
  ScanWorld world;
  for (int i = 0; i < circles; ++i) {
    world.circles.push_back({random_point(random, side_m), random.uniform(0.2, 0.8)});
  }
  for (int i = 0; i < walls; ++i) {
    const Vec2 a = random_point(random, side_m);
    world.walls.push_back({a, a + random_point(random, 4)});
  }
  return world;
}

Scan cast_scan(const ScanWorld& world, const Pose2& pose, std::shared_ptr<const BeamFan> fan,
               double max_range_m, double noise_m, double dropout, Random& random) {
  Scan scan{0, pose, std::move(fan), max_range_m, {}};
  scan.range_m.resize(scan.beams->direction_sensor.size());
  for (std::size_t i = 0; i < scan.size(); ++i) {
    const Vec2 direction = scan.direction_world(i);
    double range = max_range_m;
    for (const Circle& c : world.circles) {
      range = std::min(range, range_to(c, pose.p_world, direction));
    }
    for (const Segment& w : world.walls) {
      range = std::min(range, range_to(w, pose.p_world, direction));
    }
    if (range < max_range_m && noise_m > 0) range += noise_m * random.normal();
    if (random.uniform() < dropout) range = broken_range(random, max_range_m);
    scan.range_m[i] = range;
  }
  return scan;
}

Scan lattice_scan(Random& random, bool full_circle) {
  BeamFan fan;
  fan.first_bearing_rad = -1;
  fan.bearing_step_rad = full_circle ? 1 : 0.01;  // of 16 beams
  const std::array<Vec2, 8> octant{Vec2{1, 0},  Vec2{1, 1},   Vec2{0, 1},  Vec2{-1, 1},
                                   Vec2{-1, 0}, Vec2{-1, -1}, Vec2{0, -1}, Vec2{1, -1}};
  for (std::size_t i = 0; i < octant.size(); ++i) {
    fan.direction_sensor.push_back(octant[i]);
    fan.direction_sensor.push_back(octant[i] + octant[(i + 1) % octant.size()]);
  }
  constexpr double kMaxRange = 7;
  Scan scan{0, {}, std::make_shared<BeamFan>(fan), kMaxRange, {}};
  scan.sensor_world.p_world = {static_cast<double>(random.below(16)),
                               static_cast<double>(random.below(16))};
  for (std::size_t i = 0; i < fan.direction_sensor.size(); ++i) {
    const auto range = static_cast<double>(1 + random.below(10));
    scan.range_m.push_back(std::min(range, kMaxRange));
  }
  return scan;
}

Pose2 random_pose(Random& random, double side_m) {
  Vec2 heading{random.normal(), random.normal()};
  heading /= heading.norm();
  return {random_point(random, side_m), heading};
}

}  // namespace voronaut
