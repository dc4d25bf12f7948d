#pragma once

#include <cstdint>
#include <vector>

#include "voronaut/environments/shapes/geometry.h"
#include "voronaut/planners/mapping/obstacle_base.h"
#include "voronaut/planners/reactive_voronoi/reactive_step.h"

// A small closed loop for tests of reactive_step: circles, a range finder by brute force, and a
// holonomic vehicle with limited acceleration. It shares no code with the benchmark.
namespace voronaut::test {

struct FlightScene {
  std::vector<Circle> circles;
  Vec2 start = Vec2::Zero();
  Vec2 goal = Vec2::Zero();
};

// 2 to 7 circles of 0.5 and 1 m near the line from the origin to a goal 10 sqrt(2) m away at
// `direction` (unit), no two with a gap below 1.2 m; start and goal keep 1.2 m, too.
FlightScene paper_like_scene(const Vec2& direction, std::uint64_t seed);

// The scene turned about the origin: (1, 0) goes to `direction`.
FlightScene turned(const FlightScene& scene, const Vec2& direction);

struct FlightConfig {
  double body_radius_m = 0.25;
  double speed_m_s = 2.5;
  double acceleration_m_s2 = 3;
  double field_of_view_rad = 1.5707963267948966;
  double range_m = 2.5;
  std::size_t rays = 91;
  double time_limit_s = 120;
  ObstacleBaseConfig mapping;
};

Scan scan_of(const FlightScene& scene, const Pose2& pose, const FlightConfig& config);

enum class FlightEnd { goal, collision, timeout };

struct Flown {
  FlightEnd end = FlightEnd::timeout;
  double duration_s = 0;
  double length_m = 0;
  double clearance_smallest_m = 1e9;  // centre to surface
  std::vector<ReactiveDecision> decisions;
  std::vector<Vec2> positions;  // where each decision was made
};

// 20 scans and decisions per second, motion in steps of 10 ms, yaw fixed towards the goal.
Flown fly(const FlightScene& scene, const ReactiveVoronoiConfig& planner,
          const FlightConfig& config);

}  // namespace voronaut::test
