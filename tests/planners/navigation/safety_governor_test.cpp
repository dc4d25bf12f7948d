#include "voronaut/planners/navigation/safety_governor.h"

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

#include "voronaut/dynamics/catalog.h"
#include "voronaut/environments/sensing/range_finder.h"
#include "voronaut/environments/world.h"
#include "voronaut/planners/mapping/obstacle_base.h"
#include "voronaut/tests/planners/mapping/known_points.h"

namespace voronaut {
namespace {

constexpr double kPeriod_s = 0.01;
constexpr int kStepsPerScan = 5;
constexpr double kBodyRadius_m = 0.25;
constexpr double kClearance_m = 0.4;
const Bounds kBounds{Vec2(-5, -5), Vec2(12, 5)};

Shapes wall_at(double x) {
  Shapes shapes;
  shapes.segments.push_back({Vec2(x, -4), Vec2(x, 4)});
  return shapes;
}
Shapes post_at(const Vec2& p, double radius_m) {
  Shapes shapes;
  shapes.circles.push_back({p, radius_m});
  return shapes;
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
  bool governed = true;

  // Smallest clearance of the centre to the true surface over the flight.
  double clearance_min_m() const {
    VehicleSpec spec = find_vehicle(vehicle_name);
    const RegulatorConfig regulator_config = find_regulator(spec.regulator);
    SafetyGovernor governor(velocity_response(regulator_config, spec, kPeriod_s), kBodyRadius_m,
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
    std::vector<Vec2> commands;
    double smallest = std::numeric_limits<double>::infinity();
    Scan scan;
    for (int step = 0; step < 600; ++step) {
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
                                          .v_world
                                    : wanted);
        const auto late = static_cast<std::size_t>(dead_time_s / (kStepsPerScan * kPeriod_s) + 0.5);
        setpoint.motion = VelocityCommand{
            commands.size() > late ? commands[commands.size() - 1 - late] : Vec2(0, 0)};
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

TEST(SafetyGovernor, StopsACarelessPilotBeforeTheWall) {
  for (const char* name : {"ideal", "quadrotor"}) {
    Dash dash;
    dash.vehicle_name = name;
    EXPECT_GE(dash.clearance_min_m(), kBodyRadius_m) << name;
    dash.governed = false;
    EXPECT_LT(dash.clearance_min_m(), kBodyRadius_m) << name;
  }
}

TEST(SafetyGovernor, LetsFullSpeedPassWhereNothingIsInTheWay) {
  const VehicleSpec spec = find_vehicle("quadrotor");
  SafetyGovernor governor(velocity_response(find_regulator("pd_rate"), spec, kPeriod_s),
                          kBodyRadius_m, kClearance_m, 0.05);
  FreeSpace free(kBounds);
  free.mark_disc(Vec2(0, 0), 3);
  const VehicleState state = make_model(spec.model)->at_rest({0, 0, 1}, {1, 0});
  EXPECT_EQ(governor.allow({.v_world = Vec2(2.5, 0)}, state, free, {}, KnownClearance::planned)
                .speed_scale,
            1);
  EXPECT_FALSE(governor.allow({.v_world = Vec2(2.5, 0)}, state, free, {}, KnownClearance::planned)
                   .refused_at);
}

TEST(SafetyGovernor, NamesThePlaceThatNobodyKnows) {
  SafetyGovernor governor(
      velocity_response(find_regulator("ideal"), find_vehicle("ideal"), kPeriod_s), kBodyRadius_m,
      kClearance_m, 0.05);
  FreeSpace free(kBounds);
  free.mark_disc(Vec2(0, 0), 0.35);
  const VehicleState state = make_model(find_vehicle("ideal").model)->at_rest({0, 0, 1}, {1, 0});
  const GovernedMotion allowed =
      governor.allow({.v_world = Vec2(2.5, 0)}, state, free, {}, KnownClearance::planned);
  EXPECT_LT(allowed.speed_scale, 1);
  ASSERT_TRUE(allowed.refused_at);
  EXPECT_FALSE(free.is_free(*allowed.refused_at));
  EXPECT_GT(allowed.refused_at->x(), 0);
}

TEST(SafetyGovernor, LetsAVehicleLeaveAWallThatItStandsTooCloseTo) {
  for (const char* name : {"ideal", "quadrotor"}) {
    const VehicleSpec spec = find_vehicle(name);
    SafetyGovernor governor(velocity_response(find_regulator(spec.regulator), spec, kPeriod_s),
                            kBodyRadius_m, kClearance_m, 0.05);
    FreeSpace free(kBounds);
    free.mark_disc(Vec2(-1, 0), 1.2);  // the body's own disc is not wholly known free
    const VehicleState state = make_model(spec.model)->at_rest({0, 0, 1}, {1, 0});
    EXPECT_GT(governor.allow({.v_world = Vec2(-1, 0)}, state, free, {}, KnownClearance::planned)
                  .speed_scale,
              0)
        << name;
    EXPECT_EQ(governor.allow({.v_world = Vec2(1, 0)}, state, free, {}, KnownClearance::planned)
                  .speed_scale,
              0)
        << name;
    EXPECT_EQ(governor.allow({.v_world = Vec2(0, 1)}, state, free, {}, KnownClearance::planned)
                  .speed_scale,
              0)
        << name;
  }
}

// The strip |y| < half_width_m, known to be free, in cells small enough to hide nothing.
FreeSpace strip(double from_m, double to_m, double half_width_m) {
  FreeSpace free(kBounds, {.cell_m = 0.01});
  for (double x = from_m + half_width_m; x < to_m - half_width_m; x += 0.02)
    free.mark_disc(Vec2(x, 0), half_width_m);
  free.mark_disc(Vec2(to_m - half_width_m, 0), half_width_m);
  return free;
}

// How far from p along one of the axes it is known to be free: a cell that a mark touches is.
double free_way_m(const FreeSpace& free, const Vec2& p, const Vec2& along) {
  double way_m = 0;
  while (free.is_free(p + way_m * along)) way_m += 1e-4;
  return way_m;
}

// The edges of what is proved. A tube is as wide as the body and all that it may stray.
TEST(SafetyGovernor, LeavesRoomForAllThatAStopMayStrayFromItsPrediction) {
  for (const double stray_m : {0.0, 0.1, 0.2, 0.3}) {
    VelocityResponse response;
    response.error_at_rest_m = stray_m;
    const VehicleState state = make_model(IdealConfig{})->at_rest({0, 0, 1}, {1, 0});
    double narrowest_m = 1;
    for (double half_width_m = 0.2; half_width_m < 0.8; half_width_m += 0.01) {
      const FreeSpace free = strip(-1, 4, half_width_m);
      SafetyGovernor governor(response, kBodyRadius_m, kClearance_m, 0.05);
      if (governor.allow({.v_world = Vec2(1.5, 0)}, state, free, {}, KnownClearance::planned)
              .speed_scale == 0)
        continue;
      for (const Vec2& side : {Vec2(0, 1), Vec2(0, -1)})
        narrowest_m = std::min(narrowest_m, free_way_m(free, Vec2(0.1, 0), side));
    }
    EXPECT_GE(narrowest_m, kBodyRadius_m + stray_m);
    EXPECT_LT(narrowest_m, kBodyRadius_m + stray_m + 0.04) << "not at the edge";
  }
}

// Flies towards the end of what is known free for so many periods of the governor, then brakes.
// What is left between the body and that end where it has come to rest, at the least.
double room_left_m(const std::string& name, double hold_s, const FreeSpace& free, double end_m,
                   int periods) {
  const VehicleSpec spec = find_vehicle(name);
  const RegulatorConfig law = find_regulator(spec.regulator);
  SafetyGovernor governor(velocity_response(law, spec, kPeriod_s), kBodyRadius_m, kClearance_m,
                          hold_s);
  const auto model = make_model(spec.model);
  const auto pilot = make_regulator(law, spec, kPeriod_s);
  VehicleState state = model->at_rest({0, 0, 1}, {1, 0});
  pilot->reset(state);
  Command pending = model->hold();
  Setpoint setpoint;
  setpoint.height_m = 1;
  const int steps_held = static_cast<int>(hold_s / kPeriod_s + 0.5);
  double farthest_m = 0;
  for (int step = 0; step < steps_held * periods + 300; ++step) {
    if (step >= steps_held * periods) {
      setpoint.motion = VelocityCommand{Vec2(0, 0)};
    } else if (step % steps_held == 0) {
      setpoint.motion = VelocityCommand{
          governor.allow({.v_world = Vec2(2.5, 0)}, state, free, {}, KnownClearance::planned)
              .v_world};
    }
    const Command next = pilot->regulate(setpoint, state);
    state = model->step(state, pending, kPeriod_s);
    pending = next;
    farthest_m = std::max(farthest_m, state.p_world.x());
  }
  return end_m - kBodyRadius_m - farthest_m;
}

TEST(SafetyGovernor, StopsShortOfWhatIsUnknownThoughItHoldsEachCommandAsLongAsItMay) {
  constexpr double kHold_s = 0.2;
  for (const char* name : {"ideal", "quadrotor"}) {
    double least_m = 1;
    for (double end_m = 3; end_m < 3.3; end_m += 0.02) {
      const FreeSpace free = strip(-1, end_m, 1);
      const double known_end_m = free_way_m(free, Vec2(0, 0), Vec2(1, 0));
      for (int periods = 1; periods < 20; ++periods)
        least_m = std::min(least_m, room_left_m(name, kHold_s, free, known_end_m, periods));
    }
    EXPECT_GE(least_m, 0) << name;
    EXPECT_LT(least_m, 0.1) << name << " is not at the edge";
  }
}

TEST(SafetyGovernor, LetsNoVehicleLeaveFastWhatItStandsTooCloseTo) {
  const VehicleSpec spec = find_vehicle("ideal");
  SafetyGovernor governor(velocity_response(find_regulator("ideal"), spec, kPeriod_s),
                          kBodyRadius_m, kClearance_m, 0.05);
  FreeSpace free(kBounds);
  free.mark_disc(Vec2(-1, 0), 1.2);
  const VehicleState state = make_model(spec.model)->at_rest({0, 0, 1}, {1, 0});
  const GovernedMotion allowed =
      governor.allow({.v_world = Vec2(-2.5, 0)}, state, free, {}, KnownClearance::planned);
  EXPECT_GT(allowed.speed_scale, 0);
  EXPECT_LE(allowed.v_world.norm(), 0.4);
}

// At 0.4 m 3 cm less: closer than that planner and governor would wait for each other.
TEST(SafetyGovernor, KeepsTheClearanceOfPlannersButForItsMargin) {
  const auto speed_scale_beside = [](double aside_m) {
    SafetyGovernor governor(
        velocity_response(find_regulator("ideal"), find_vehicle("ideal"), kPeriod_s), kBodyRadius_m,
        kClearance_m, 0.05);
    FreeSpace free(kBounds);
    free.mark_disc(Vec2(0, 0), 4);
    const auto post = test::base_of({Vec2(0.5, aside_m)});
    VehicleState state = make_model(IdealConfig{})->at_rest({0, 0, 1}, {1, 0});
    state.v_world.x() = 2;
    return governor
        .allow({.v_world = Vec2(2.5, 0)}, state, free, post->snapshot(), KnownClearance::planned)
        .speed_scale;
  };
  EXPECT_LT(speed_scale_beside(0.365), 1);
  EXPECT_EQ(speed_scale_beside(0.375), 1);
}

TEST(SafetyGovernor, AtReducedClearanceAsksOnlyForWhatIsKnownFree) {
  SafetyGovernor governor(
      velocity_response(find_regulator("ideal"), find_vehicle("ideal"), kPeriod_s), kBodyRadius_m,
      kClearance_m, 0.05);
  FreeSpace free(kBounds);
  free.mark_disc(Vec2(0, 0), 3);
  const auto posts = test::base_of({Vec2(0.1, 0.35), Vec2(0.1, -0.35)});
  const ObstacleSnapshot known = posts->snapshot();
  const VehicleState state = make_model(find_vehicle("ideal").model)->at_rest({0, 0, 1}, {1, 0});
  EXPECT_EQ(governor.allow({.v_world = Vec2(1, 0)}, state, free, known, KnownClearance::planned)
                .speed_scale,
            0);
  EXPECT_GT(governor.allow({.v_world = Vec2(1, 0)}, state, free, known, KnownClearance::reduced)
                .speed_scale,
            0);
}

// How far the centre comes out of the bounds at worst [m], negative inside: a pilot who wants to be
// anywhere else, full speed, where all in reach is known to be free.
double farthest_out_m(const std::string& name, const Vec2& start, std::uint64_t seed) {
  const Bounds bounds{Vec2(-1, -1), Vec2(1, 1)};
  const VehicleSpec spec = find_vehicle(name);
  const RegulatorConfig regulator_config = find_regulator(spec.regulator);
  SafetyGovernor governor(velocity_response(regulator_config, spec, kPeriod_s), kBodyRadius_m,
                          kClearance_m, kStepsPerScan * kPeriod_s, bounds);
  FreeSpace free(kBounds);
  free.mark_disc(Vec2(0, 0), 4);
  const auto model = make_model(spec.model);
  const auto pilot = make_regulator(regulator_config, spec, kPeriod_s);
  VehicleState state = model->at_rest({start.x(), start.y(), 1}, {1, 0});
  pilot->reset(state);
  Command pending = model->hold();
  Setpoint setpoint;
  setpoint.height_m = 1;
  Random random(seed);
  Vec2 wanted(0, 0);
  double worst_m = -1;
  for (int step = 0; step < 6000; ++step) {
    const Vec2 p = state.p_world.head<2>();
    if (step % 100 == 0) wanted = 2.5 * Vec2(random.uniform(-1, 1), random.uniform(-1, 1));
    if (step % kStepsPerScan == 0)
      setpoint.motion = VelocityCommand{
          governor.allow({.v_world = wanted}, state, free, {}, KnownClearance::planned).v_world};
    worst_m = std::max({worst_m, (p - bounds.max).maxCoeff(), (bounds.min - p).maxCoeff()});
    const Command next = pilot->regulate(setpoint, state);
    state = model->step(state, pending, kPeriod_s);
    pending = next;
  }
  return worst_m;
}

TEST(SafetyGovernor, HoldsTheCentreWithinTheBoundsAndLetsItLeaveTheirEdgeInwards) {
  for (const char* name : {"ideal", "quadrotor"}) {
    for (const Vec2& start : {Vec2(0, 0), Vec2(-1, 0), Vec2(1, 1), Vec2(0.3, -0.999)}) {
      for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        const double out_m = farthest_out_m(name, start, seed);
        EXPECT_LE(out_m, start.cwiseAbs().maxCoeff() == 1 ? 1e-9 : 0.0) << name << " " << seed;
        EXPECT_GT(out_m, -0.1) << "uses the room there is";
      }
    }
  }
}

// Each condition of the proof, broken: the vehicle touches.
TEST(SafetyGovernor, AWorldThatMovesIsNotItsWorld) {
  Dash dash;
  dash.shapes = {};
  dash.shapes_later = wall_at(2.6);
  dash.later_s = 1.0;
  EXPECT_LT(dash.clearance_min_m(), kBodyRadius_m);
}

TEST(SafetyGovernor, RangesThatAreTooLongAreNotForgiven) {
  Dash dash;
  dash.range_bias_m = 0.5;
  EXPECT_LT(dash.clearance_min_m(), kBodyRadius_m);
}

TEST(SafetyGovernor, AVehicleThatBrakesWorseThanPromisedTouches) {
  Dash dash;
  dash.braking = 0.4;
  EXPECT_LT(dash.clearance_min_m(), kBodyRadius_m);
}

TEST(SafetyGovernor, ACourseThatActsTooLateIsNotTheCourseThatWasProved) {
  Dash dash;
  dash.dead_time_s = 0.6;
  EXPECT_LT(dash.clearance_min_m(), kBodyRadius_m);
}

TEST(SafetyGovernor, AStartAtFullSpeedBeforeAWallCannotBeMended) {
  Dash dash;
  dash.shapes = dash.shapes_later = wall_at(0.9);
  dash.start_speed_m_s = 2.5;
  EXPECT_LT(dash.clearance_min_m(), kBodyRadius_m);
}

TEST(SafetyGovernor, APostThinnerThanTheBeamsSpacingSlipsThrough) {
  Dash dash;
  // Half way between two beams of one degree: at 2.5 m they are 4.4 cm apart.
  dash.shapes = post_at(Vec2(4, 0.035), 0.0005);
  dash.shapes_later = dash.shapes;
  const double slips = dash.clearance_min_m();
  dash.shapes = post_at(Vec2(4, 0), 0.03);
  dash.shapes_later = dash.shapes;
  EXPECT_LT(slips, kBodyRadius_m);
  EXPECT_GE(dash.clearance_min_m(), kBodyRadius_m);
}

}  // namespace
}  // namespace voronaut
