#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "voronaut/benchmarks/episode/episode.h"
#include "voronaut/environments/world.h"

// A box with a door of 0.7 m, narrower than planners plan for (2 x 0.4 m). The vehicle is put along
// a way through the door, as if it had come in before its sides were known.
namespace voronaut {
namespace {

constexpr double kDt_s = 0.05;

TrialSpec beside_a_box(const Vec2& goal) {
  const Vec2 corners[] = {{2, -0.35}, {2, -1.5}, {5, -1.5}, {5, 1.5}, {2, 1.5}, {2, 0.35}};
  std::vector<Segment> walls;
  for (std::size_t i = 0; i + 1 < std::size(corners); ++i)
    walls.push_back({corners[i], corners[i + 1]});
  TrialSpec spec;
  spec.scenario.name = "box";
  spec.scenario.world =
      std::make_shared<World>(Bounds{Vec2(-4, -6), Vec2(12, 6)}, Shapes{{}, walls, {}});
  spec.scenario.goal_world = goal;
  spec.vehicle = vehicle("ideal");
  spec.regulator_name = spec.vehicle.regulator;
  spec.regulator = regulator(spec.regulator_name);
  spec.planner = {"VoronoiRoadmap", "VoronoiRoadmap", {}};
  spec.flight.navigation.recovery = true;
  spec.shortest_length_m = 10;
  return spec;
}

// Into the box and once around.
void fly_into(Flight& flight) {
  flight.departed = true;
  VehicleState state = flight.model->at_rest(Vec3(0, 0, 1), Vec2(1, 0));
  double now_s = 0;
  const auto scan_and_plan = [&] {
    flight.log.ticks.push_back({now_s, state, 0});
    flight.sense(state, now_s);
    flight.update_map();
    flight.plan(state, now_s);
    now_s += kDt_s;
  };
  for (int i = 0; i <= 70; ++i) {
    state = flight.model->at_rest(Vec3(0.05 * i, 0, 1), Vec2(1, 0));
    scan_and_plan();
  }
  for (int i = 1; i <= 24; ++i) {
    const double heading_rad = i * std::numbers::pi / 12;
    state = flight.model->at_rest(Vec3(3.5, 0, 1), {std::cos(heading_rad), std::sin(heading_rad)});
    scan_and_plan();
  }
}

TEST(Retracing, LeadsOutOfAPocketFromWhichNoPathExists) {
  const TrialSpec spec = beside_a_box(Vec2(8, 0));
  const PlannerCatalog planners = PlannerCatalog::built_in();
  Flight flight(spec, planners, false);
  fly_into(flight);
  EXPECT_FALSE(flight.referee.verdict());
  EXPECT_TRUE(flight.retracing);
  ASSERT_TRUE(flight.tracker.has_path());
  EXPECT_LT(flight.tracker.path().back().x(), 3.2);
  EXPECT_NEAR(flight.tracker.path().back().y(), 0, 0.01);
}

TEST(Retracing, IsNotTriedAndNoVerdictGivenWhereRecoveryIsOff) {
  TrialSpec spec = beside_a_box(Vec2(8, 0));
  spec.flight.navigation.recovery = false;
  const PlannerCatalog planners = PlannerCatalog::built_in();
  Flight flight(spec, planners, false);
  fly_into(flight);
  EXPECT_FALSE(flight.referee.verdict());
  EXPECT_FALSE(flight.tracker.has_path());
}

TEST(Retracing, IsNotTriedWhereTheMissionHasNoPathEither) {
  const TrialSpec spec = beside_a_box(Vec2(4.2, 0.5));
  const PlannerCatalog planners = PlannerCatalog::built_in();
  Flight flight(spec, planners, false);
  flight.departed = true;
  VehicleState state = flight.model->at_rest(Vec3(0, 0, 1), Vec2(1, 0));
  // Around the box, until all of it is known.
  for (int i = 0; i < 400 && !flight.referee.verdict(); ++i) {
    const double bearing_rad = std::numbers::pi * (1 + i / 200.0);
    const Vec2 outward(std::cos(bearing_rad), std::sin(bearing_rad));
    const Vec2 p = Vec2(3.5, 0) + 3.5 * outward;
    state = flight.model->at_rest(Vec3(p.x(), p.y(), 1), -outward);
    flight.log.ticks.push_back({kDt_s * i, state, 0});
    flight.sense(state, kDt_s * i);
    flight.update_map();
    flight.plan(state, kDt_s * i);
  }
  ASSERT_TRUE(flight.referee.verdict());
  EXPECT_EQ(flight.referee.verdict()->outcome, Outcome::infeasible);
}

}  // namespace
}  // namespace voronaut
