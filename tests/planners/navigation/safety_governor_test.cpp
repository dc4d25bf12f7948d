#include "voronaut/planners/navigation/safety_governor.h"

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

#include "voronaut/tests/planners/mapping/known_points.h"
#include "voronaut/tests/planners/navigation/dash.h"

namespace voronaut {
namespace {

using testing::command;
using testing::Dash;
using testing::kBodyRadius_m;
using testing::kBounds;
using testing::kClearance_m;
using testing::kPeriod_s;
using testing::kStepsPerScan;

TEST(SafetyGovernor, StopsACarelessPilotBeforeTheWall) {
  for (const char* name : {"ideal", "quadrotor", "unicycle", "jackal", "cart", "car"}) {
    Dash dash;
    dash.vehicle_name = name;
    EXPECT_GE(dash.clearance_smallest_m(), kBodyRadius_m) << name;
    dash.governed = false;
    EXPECT_LT(dash.clearance_smallest_m(), kBodyRadius_m) << name;
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

// What a vehicle is given that wants to go straight on, allowed all it wants before or nothing:
// from 0.6 m ahead of it on, it is known to be free right_m to its right and left_m to its left.
GovernedMotion before_walls(bool fast_before, double right_m, double left_m) {
  SafetyGovernor governor(
      velocity_response(find_regulator("ideal"), find_vehicle("ideal"), kPeriod_s), kBodyRadius_m,
      0.29, 0.05);
  FreeSpace free(kBounds, {.cell_m = 0.01});
  free.mark_disc(Vec2(0, 0), 0.6);
  const double half_m = 0.5 * (right_m + left_m), middle_m = 0.5 * (left_m - right_m);
  for (double x = -1; x < 3.9 - half_m; x += 0.02) free.mark_disc(Vec2(x, middle_m), half_m);
  VehicleState state = make_model(find_vehicle("ideal").model)->at_rest({0, 0, 1}, {1, 0});
  const WantedMotion ahead{.v_world = Vec2(2.5, 0)};
  // Fast before, in the open.
  FreeSpace open(kBounds);
  open.mark_disc(Vec2(0, 0), 3.5);
  if (fast_before) governor.allow(ahead, state, open, {}, KnownClearance::planned);
  state.v_world.x() = 1.5;
  return governor.allow(ahead, state, free, {}, KnownClearance::planned);
}

TEST(SafetyGovernor, GoesAsideAtFullSpeedWhereThereIsRoom) {
  for (const bool wall_is_left : {true, false}) {
    const double right_m = wall_is_left ? 1.5 : 0.24, left_m = wall_is_left ? 0.24 : 1.5;
    const GovernedMotion fast = before_walls(true, right_m, left_m);
    EXPECT_EQ(fast.speed_scale, 1) << wall_is_left;
    EXPECT_LT(fast.v_world.y() * (wall_is_left ? 1 : -1), -0.1);
    EXPECT_GT(fast.v_world.x(), 1.5);
    EXPECT_FALSE(fast.tube_world.empty());
    EXPECT_EQ(std::get<VelocityCommand>(fast.command).v_world_m_s, fast.v_world)
        << "what was proved";
  }
  const GovernedMotion straight = before_walls(true, 0.6, 0.6);
  EXPECT_EQ(straight.speed_scale, 1);
  EXPECT_EQ(straight.v_world.y(), 0);
  const GovernedMotion between = before_walls(true, 0.24, 0.24);
  EXPECT_LT(between.speed_scale, 1) << "no room";
}

TEST(SafetyGovernor, GoesStraightWhenItWasHeldBack) {
  const GovernedMotion slow = before_walls(false, 1.5, 0.24);
  EXPECT_EQ(slow.v_world.y(), 0);
  EXPECT_LT(slow.speed_scale, 1);
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

// Half the narrowest strip that a governor lets a vehicle into.
double narrowest_m(const MotionResponse& response, const DeclaredErrors& errors = {}) {
  const VehicleState state = make_model(IdealConfig{})->at_rest({0, 0, 1}, {1, 0});
  double narrowest_m = 1;
  for (double half_width_m = 0.2; half_width_m < 0.8; half_width_m += 0.01) {
    const FreeSpace free = strip(-1, 4, half_width_m);
    SafetyGovernor governor(response, kBodyRadius_m, kClearance_m, 0.05,
                            SafetyGovernor::kEverywhere, {}, errors);
    if (governor.allow({.v_world = Vec2(1.5, 0)}, state, free, {}, KnownClearance::planned)
            .speed_scale == 0)
      continue;
    for (const Vec2& side : {Vec2(0, 1), Vec2(0, -1)})
      narrowest_m = std::min(narrowest_m, free_way_m(free, Vec2(0.1, 0), side));
  }
  return narrowest_m;
}

// The edges of what is proved. A tube is as wide as the body and all that it may stray.
TEST(SafetyGovernor, LeavesRoomForAllThatAStopMayStrayFromItsPrediction) {
  for (const double stray_m : {0.0, 0.1, 0.2, 0.3}) {
    VelocityResponse velocities;
    DriveResponse arcs;
    CarResponse steered;
    velocities.error_at_rest_m = arcs.error_at_rest_m = steered.error_at_rest_m = stray_m;
    for (const MotionResponse& response :
         {MotionResponse(velocities), MotionResponse(arcs), MotionResponse(steered)}) {
      EXPECT_GE(narrowest_m(response), kBodyRadius_m + stray_m) << response.index();
      EXPECT_LT(narrowest_m(response), kBodyRadius_m + stray_m + 0.04) << "not at the edge";
    }
  }
}

TEST(SafetyGovernor, LeavesRoomForWhatIsDeclaredToBeOff) {
  const MotionResponse response = DriveResponse{};
  const double exact_m = narrowest_m(response);
  for (const double position_m : {0.1, 0.2}) {
    const double room_m = narrowest_m(response, {.sensing = {.position_m = position_m}}) - exact_m;
    EXPECT_NEAR(room_m, position_m, 0.021);
  }
  EXPECT_GT(narrowest_m(response, {.stop_per_speed_s = 1}), exact_m + 0.04);
}

// Where a heading is off, too: the faster, the longer is a stop.
TEST(SafetyGovernor, GoesSlowerWhereStopsAreDeclaredToStrayWithSpeed) {
  const FreeSpace free = strip(-1, 4, kBodyRadius_m + 0.1);
  const auto scale_at = [&](double speed_m_s, const DeclaredErrors& errors) {
    VehicleState state = make_model(IdealConfig{})->at_rest({0, 0, 1}, {1, 0});
    state.v_world.x() = speed_m_s;
    SafetyGovernor governor(DriveResponse{}, kBodyRadius_m, kClearance_m, 0.05,
                            SafetyGovernor::kEverywhere, {}, errors);
    return governor.allow({.v_world = Vec2(1.5, 0)}, state, free, {}, KnownClearance::planned)
        .speed_scale;
  };
  EXPECT_EQ(scale_at(0, {}), 1);
  EXPECT_LT(scale_at(0, {.stop_per_speed_s = 0.1}), 0.7);
  EXPECT_GT(scale_at(0, {.stop_per_speed_s = 0.1}), 0);
  EXPECT_EQ(scale_at(1.5, {}), 1);
  EXPECT_LT(scale_at(1.5, {.sensing = {.heading_rad = 0.5}}), 1);
}

// Flies towards the end of what is known free for so many periods of the governor, then brakes.
// What is left between the body and that end where it has come to rest, at the least.
double room_left_m(const std::string& name, double hold_s, const FreeSpace& free, double end_m,
                   int periods) {
  const VehicleSpec spec = find_vehicle(name);
  const RegulatorConfig law = find_regulator(spec.regulator);
  SafetyGovernor governor(motion_response(law, spec, kPeriod_s), kBodyRadius_m, kClearance_m,
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
      command(governor.allow({.v_world = Vec2(2.5, 0)}, state, free, {}, KnownClearance::planned)
                  .command,
              setpoint);
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
  for (const char* name : {"ideal", "quadrotor", "unicycle", "jackal", "cart", "car"}) {
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
  SafetyGovernor governor(motion_response(regulator_config, spec, kPeriod_s), kBodyRadius_m,
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
    if (step % kStepsPerScan == 0) {
      command(governor.allow({.v_world = wanted}, state, free, {}, KnownClearance::planned).command,
              setpoint);
    }
    worst_m = std::max({worst_m, (p - bounds.max).maxCoeff(), (bounds.min - p).maxCoeff()});
    const Command next = pilot->regulate(setpoint, state);
    state = model->step(state, pending, kPeriod_s);
    pending = next;
  }
  return worst_m;
}

TEST(SafetyGovernor, HoldsTheCentreWithinTheBoundsAndLetsItLeaveTheirEdgeInwards) {
  for (const char* name : {"ideal", "quadrotor", "unicycle", "jackal", "cart", "car"}) {
    for (const Vec2& start : {Vec2(0, 0), Vec2(-1, 0), Vec2(1, 1), Vec2(0.3, -0.999)}) {
      for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        const double out_m = farthest_out_m(name, start, seed);
        // Turning on the spot at the very edge, the cart's axle wanders by so much.
        const double at_edge_m = std::string(name) == "cart" ? 2e-3 : 1e-9;
        EXPECT_LE(out_m, start.cwiseAbs().maxCoeff() == 1 ? at_edge_m : 0.0) << name << " " << seed;
        EXPECT_GT(out_m, -0.1) << "uses the room there is";
      }
    }
  }
}

}  // namespace
}  // namespace voronaut
