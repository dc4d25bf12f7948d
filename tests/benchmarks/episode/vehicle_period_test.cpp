#include <algorithm>

#include <gtest/gtest.h>

#include "voronaut/benchmarks/episode/episode.h"
#include "voronaut/environments/world.h"

// Regulators are sampled laws: they must be told how often they are called. Told another period,
// pd_rate takes its acceleration, a difference of velocities over a period, for half or twice what
// it is, and the cart counts on another delay of its commands.
namespace voronaut {
namespace {

TrialSpec in_the_open(const std::string& vehicle_name, double vehicle_period_s) {
  TrialSpec spec;
  spec.scenario.name = "open";
  spec.scenario.world = std::make_shared<World>(Bounds{Vec2(-4, -4), Vec2(12, 4)}, Shapes{});
  spec.scenario.goal_world = Vec2(8, 0);
  spec.vehicle = find_vehicle(vehicle_name);
  if (vehicle_name == "cart") spec.scenario.cruise_height_m = 0;
  spec.regulator_name = spec.vehicle.regulator;
  spec.regulator = find_regulator(spec.regulator_name);
  spec.planner = {"VoronoiRoadmap", "VoronoiRoadmap", {}};
  spec.flight.loop.vehicle_period_s = vehicle_period_s;
  spec.flight.navigation = NavigationConfig::paper();
  spec.shortest_length_m = 8;
  return spec;
}

EpisodeLog flown(const TrialSpec& spec) {
  Flight flight(spec, PlannerCatalog::built_in(), false);
  EpisodeLog log = fly(flight);
  EXPECT_EQ(log.verdict.outcome, Outcome::goal_reached) << log.verdict.reason;
  return log;
}

// Largest distance between the two flights at the same time, in speed [m/s].
double apart_m_s(const EpisodeLog& a, const EpisodeLog& b) {
  double apart = 0;
  for (std::size_t i = 0, j = 0; i < a.ticks.size() && j < b.ticks.size();) {
    const double ahead_s = a.ticks[i].t_s - b.ticks[j].t_s;
    if (std::abs(ahead_s) < 1e-6) {
      apart = std::max(apart, (a.ticks[i].state.v_world - b.ticks[j].state.v_world).norm());
      ++i;
    } else {
      ++(ahead_s < 0 ? i : j);
    }
  }
  return apart;
}

TEST(VehiclePeriod, AQuadrotorFliesNearlyTheSameAtEveryPeriod) {
  const EpisodeLog usual = flown(in_the_open("quadrotor", 0.01));
  EXPECT_LT(apart_m_s(usual, flown(in_the_open("quadrotor", 0.005))), 0.25);
  EXPECT_LT(apart_m_s(usual, flown(in_the_open("quadrotor", 0.02))), 0.25);
}

TEST(VehiclePeriod, ACartDrivesNearlyTheSameAtEveryPeriod) {
  const EpisodeLog usual = flown(in_the_open("cart", 0.01));
  EXPECT_LT(apart_m_s(usual, flown(in_the_open("cart", 0.005))), 0.1);
  EXPECT_LT(apart_m_s(usual, flown(in_the_open("cart", 0.02))), 0.1);
}

// The executive slows down for the goal as the regulator is configured to.
TEST(GoalProfile, OfTheRegulatorBoundsTheSpeedThatTheTrackerAllows) {
  TrialSpec spec = in_the_open("ideal", 0.01);
  SpeedProfileConfig gentle;
  gentle.deceleration_m_s2 = 0.3;
  std::get<IdealRegulatorConfig>(spec.regulator).profile = gentle;
  const EpisodeLog log = flown(spec);
  const SpeedProfile profile(gentle);
  double closest_m = 1e9;
  for (const ScanEvent& event : log.scans) {
    const auto* pass = std::get_if<PassTarget>(&event.setpoint.motion);
    if (pass == nullptr) continue;
    const double to_go_m =
        (log.ticks[event.tick].state.p_world.head<2>() - spec.scenario.goal_world).norm();
    closest_m = std::min(closest_m, to_go_m);
    EXPECT_LE(pass->speed_limit_m_s,
              profile.speed_m_s(to_go_m, spec.vehicle.limits.max_speed_m_s) + 1e-6);
  }
  EXPECT_LT(closest_m, 2);
}

}  // namespace
}  // namespace voronaut
