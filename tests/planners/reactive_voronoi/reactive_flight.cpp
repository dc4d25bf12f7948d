#include "voronaut/tests/planners/reactive_voronoi/reactive_flight.h"

#include <cmath>
#include <limits>
#include <memory>

#include "voronaut/tests/planners/planar_random.h"

namespace voronaut::test {
namespace {

constexpr double kTick_s = 0.01;
constexpr int kTicksPerScan = 5;
constexpr double kGoalTolerance_m = 0.2;

double range_to(const Circle& circle, const Vec2& from, const Vec2& direction) {
  const Vec2 to_center = circle.center - from;
  const double along = to_center.dot(direction);
  const double across = cross(direction, to_center);
  const double half_chord_sq = circle.radius_m * circle.radius_m - across * across;
  if (half_chord_sq < 0 || along < 0) return std::numeric_limits<double>::infinity();
  return along - std::sqrt(half_chord_sq);
}

void sense(const FlightScene& scene, const Pose2& pose, Scan& scan) {
  scan.sensor_world = pose;
  scan.range_m.assign(scan.beams->direction_sensor.size(), scan.max_range_m);
  for (std::size_t i = 0; i < scan.range_m.size(); ++i)
    for (const Circle& circle : scene.circles)
      scan.range_m[i] =
          std::min(scan.range_m[i], range_to(circle, pose.p_world, scan.direction_world(i)));
}

double clearance_m(const FlightScene& scene, const Vec2& p) {
  double best_m = std::numeric_limits<double>::infinity();
  for (const Circle& circle : scene.circles)
    best_m = std::min(best_m, (circle.center - p).norm() - circle.radius_m);
  return best_m;
}

struct Vehicle {
  Vec2 p;
  Vec2 v = Vec2::Zero();

  // Full speed towards the target; only the goal is braked for.
  void move(const Vec2& target, bool brake, const FlightConfig& config) {
    const Vec2 way = target - p;
    const double distance_m = way.norm();
    double speed_m_s = config.speed_m_s;
    if (brake)
      speed_m_s = std::min(speed_m_s, std::sqrt(2 * config.acceleration_m_s2 * distance_m));
    const Vec2 wanted = distance_m > 0 ? Vec2(way * (speed_m_s / distance_m)) : Vec2(0, 0);
    const Vec2 change = wanted - v;
    const double most = config.acceleration_m_s2 * kTick_s;
    v += change.norm() > most ? Vec2(change * (most / change.norm())) : change;
    p += kTick_s * v;
  }
};

}  // namespace

FlightScene paper_like_scene(const Vec2& direction, std::uint64_t seed) {
  PlanarRandom random(seed);
  FlightScene scene;
  const double length_m = 10 * std::sqrt(2.0);
  scene.goal = length_m * direction;
  const auto wanted = static_cast<std::size_t>(random.uniform(2, 8));
  for (int attempt = 0; attempt < 1000 && scene.circles.size() < wanted; ++attempt) {
    const double radius_m = random.uniform(0, 1) < 0.5 ? 0.5 : 1;
    const Vec2 center = random.uniform(2, length_m - 2) * direction +
                        random.uniform(-1.5, 1.5) * left_of(direction);
    bool fits = (center - scene.start).norm() - radius_m >= 1.2 &&
                (center - scene.goal).norm() - radius_m >= 1.2;
    for (const Circle& other : scene.circles)
      fits = fits && (center - other.center).norm() - radius_m - other.radius_m >= 1.2;
    if (fits) scene.circles.push_back({center, radius_m});
  }
  return scene;
}

FlightScene turned(const FlightScene& scene, const Vec2& direction) {
  const auto turn = [&](const Vec2& p) {
    return Vec2(p.x() * direction + p.y() * left_of(direction));
  };
  FlightScene result;
  result.start = turn(scene.start);
  result.goal = turn(scene.goal);
  for (const Circle& circle : scene.circles)
    result.circles.push_back({turn(circle.center), circle.radius_m});
  return result;
}

Scan scan_of(const FlightScene& scene, const Pose2& pose, const FlightConfig& config) {
  Scan scan;
  scan.beams = std::make_shared<BeamFan>(BeamFan::spread(config.field_of_view_rad, config.rays));
  scan.max_range_m = config.range_m;
  sense(scene, pose, scan);
  return scan;
}

Flown fly(const FlightScene& scene, const ReactiveVoronoiConfig& planner,
          const FlightConfig& config) {
  Flown flown;
  ObstacleBase base(config.mapping);
  ReactiveMemory memory;
  const Vec2 heading = (scene.goal - scene.start).normalized();
  Scan scan = scan_of(scene, {scene.start, heading}, config);
  Vehicle vehicle{scene.start};
  while (flown.duration_s < config.time_limit_s) {
    sense(scene, {vehicle.p, heading}, scan);
    base.update(scan);
    const Belief belief{base.snapshot(), &scan, base.scan_clusters(), scan.sensor_world};
    const ReactiveDecision decision = reactive_step(belief, scene.goal, planner, memory);
    flown.decisions.push_back(decision);
    flown.positions.push_back(vehicle.p);
    for (int tick = 0; tick < kTicksPerScan; ++tick) {
      const Vec2 before = vehicle.p;
      vehicle.move(decision.subgoal_world, decision.mode == ReactiveMode::none, config);
      flown.length_m += (vehicle.p - before).norm();
      flown.duration_s += kTick_s;
      flown.clearance_smallest_m =
          std::min(flown.clearance_smallest_m, clearance_m(scene, vehicle.p));
      if (flown.clearance_smallest_m < config.body_radius_m) {
        flown.end = FlightEnd::collision;
        return flown;
      }
      if ((vehicle.p - scene.goal).norm() <= kGoalTolerance_m) {
        flown.end = FlightEnd::goal;
        return flown;
      }
    }
  }
  return flown;
}

}  // namespace voronaut::test
