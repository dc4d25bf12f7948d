#pragma once

#include <algorithm>
#include <limits>
#include <string>
#include <variant>
#include <vector>

#include "voronaut/dynamics/catalog.h"
#include "voronaut/environments/sensing/range_finder.h"
#include "voronaut/environments/world.h"
#include "voronaut/planners/mapping/obstacle_base.h"
#include "voronaut/planners/navigation/safety_governor.h"

// Straight ahead with a governor: what its proof is tried with.
namespace voronaut::testing {

inline constexpr double kPeriod_s = 0.01;
inline constexpr int kStepsPerScan = 5;
inline constexpr double kBodyRadius_m = 0.25;
inline constexpr double kClearance_m = 0.4;
inline const Bounds kBounds{Vec2(-5, -5), Vec2(12, 5)};

inline Shapes wall_at(double x) {
  Shapes shapes;
  shapes.segments.push_back({Vec2(x, -4), Vec2(x, 4)});
  return shapes;
}
inline Shapes post_at(const Vec2& p, double radius_m) {
  Shapes shapes;
  shapes.circles.push_back({p, radius_m});
  return shapes;
}

// What the governor commands, as a setpoint.
inline void command(const MotionCommand& command, Setpoint& setpoint) {
  std::visit([&](const auto& motion) { setpoint.motion = motion; }, command);
}

// A careless pilot: full speed ahead, straight at a wall, with a governor. What may be wrong with
// the world, the sensor or the vehicle is set before flying.
struct Dash {
  std::string vehicle_name = "ideal";
  Shapes shapes = wall_at(6);
  Shapes shapes_later = shapes;  // from later_s on
  double later_s = 1e9;
  double range_bias_m = 0;  // added to every return
  double braking = 1;       // share of the deceleration that the governor counts on
  double start_speed_m_s = 0;
  double dead_time_s = 0;  // commands take effect so much later
  double duration_s = 6;
  bool governed = true;

  // Smallest clearance of the centre to the true surface over the flight.
  double clearance_smallest_m() const {
    VehicleSpec spec = find_vehicle(vehicle_name);
    const RegulatorConfig regulator_config = find_regulator(spec.regulator);
    SafetyGovernor governor(motion_response(regulator_config, spec, kPeriod_s), kBodyRadius_m,
                            kClearance_m, kStepsPerScan * kPeriod_s);
    spec.limits.max_acceleration_m_s2 *= braking;
    spec.limits.max_tilt_rad *= braking;
    const auto model = make_model(spec.model);
    const auto pilot = make_regulator(regulator_config, spec, kPeriod_s);
    const RangeFinder finder{RangeFinderConfig{}};
    Random random(1);
    ObstacleBase base({});
    FreeSpace free(kBounds);
    free.mark_disc(Vec2(0, 0), kBodyRadius_m);
    // The start is seen all around, as a look-around at rest does.
    look_around(finder, random, base, free);

    VehicleState state = model->at_rest({0, 0, 1}, {1, 0});
    state.v_world.x() = start_speed_m_s;
    pilot->reset(state);
    Command pending = model->hold();
    Setpoint setpoint;
    setpoint.height_m = 1;
    std::vector<MotionCommand> commands;
    double smallest = std::numeric_limits<double>::infinity();
    Scan scan;
    for (int step = 0; step * kPeriod_s < duration_s; ++step) {
      const World world(kBounds, step * kPeriod_s < later_s ? shapes : shapes_later);
      const Vec2 p = state.p_world.head<2>();
      if (step % kStepsPerScan == 0) {
        sense(finder, world, {p, Vec2(1, 0)}, random, scan);
        base.update(scan);
        free.update(scan);
        const Vec2 wanted(2.5, 0);
        commands.push_back(governed ? governor
                                          .allow({.v_world = wanted}, state, free, base.snapshot(),
                                                 KnownClearance::planned)
                                          .command
                                    : MotionCommand(VelocityCommand{wanted}));
        const auto late = static_cast<std::size_t>(dead_time_s / (kStepsPerScan * kPeriod_s) + 0.5);
        setpoint.motion = VelocityCommand{};
        if (commands.size() > late) command(commands[commands.size() - 1 - late], setpoint);
      }
      smallest = std::min(smallest, world.clearance_m(p));
      const Command next = pilot->regulate(setpoint, state);
      state = model->step(state, pending, kPeriod_s);
      pending = next;
    }
    return smallest;
  }

 private:
  void sense(const RangeFinder& finder, const World& world, const Pose2& pose, Random& random,
             Scan& scan) const {
    finder.sense(world, pose, 0, random, scan);
    for (std::size_t i = 0; i < scan.size(); ++i) {
      if (scan.is_return(i)) scan.range_m[i] = std::min(scan.range_m[i] + range_bias_m, 2.5);
    }
  }
  void look_around(const RangeFinder& finder, Random& random, ObstacleBase& base,
                   FreeSpace& free) const {
    Scan scan;
    // Overlapping views: a wedge between two of them would stay unknown.
    for (const Vec2& corner : {Vec2(1, 0), Vec2(1, 1), Vec2(0, 1), Vec2(-1, 1), Vec2(-1, 0),
                               Vec2(-1, -1), Vec2(0, -1), Vec2(1, -1)}) {
      const Vec2 heading = corner.normalized();
      sense(finder, World(kBounds, shapes), {Vec2(0, 0), heading}, random, scan);
      base.update(scan);
      free.update(scan);
    }
  }
};

}  // namespace voronaut::testing
