#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "voronaut/benchmarks/episode/episode.h"
#include "voronaut/environments/world.h"

// A box with a door of 0.7 m, narrower than planners plan for (2 x 0.4 m). The vehicle is put along
// a way through the door, as if it had come in before its sides were known.
namespace voronaut {
namespace {

constexpr double kDt_s = 0.05;  // from scan to scan

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
  spec.vehicle = find_vehicle("ideal");
  spec.vehicle.planning_clearance_m = 0.4;  // the opening of 0.7 m is too narrow for it
  spec.regulator_name = spec.vehicle.regulator;
  spec.regulator = find_regulator(spec.regulator_name);
  spec.planner = {"VoronoiRoadmap", "VoronoiRoadmap", {}};
  spec.flight.navigation = NavigationConfig::paper();
  spec.flight.navigation.recovery = true;
  spec.shortest_length_m = 10;
  return spec;
}

// A navigator that is put at one place after another and shown what can be seen from there.
class Shown {
 public:
  explicit Shown(const TrialSpec& spec) : flight_(spec, PlannerCatalog::built_in(), false) {}

  const NavigationReport& at(const Vec2& p, const Vec2& heading) {
    const VehicleState state = flight_.model->at_rest(Vec3(p.x(), p.y(), 1), heading);
    flight_.navigator.update(flight_.sense(state, state, now_s_), state, now_s_);
    now_s_ += kDt_s;
    return report();
  }
  const NavigationReport& report() const { return flight_.navigator.report(); }
  const Path& path() const { return flight_.navigator.path(); }

 private:
  Flight flight_;
  double now_s_ = 0;
};

// Into the box and once around. False if a verdict was given on the way.
bool fly_into(Shown& shown) {
  bool no_verdict = true;
  for (int i = 0; i <= 70; ++i)
    no_verdict = shown.at(Vec2(0.05 * i, 0), Vec2(1, 0)).infeasible.empty() && no_verdict;
  for (int i = 1; i <= 24; ++i) {
    const double heading_rad = i * std::numbers::pi / 12;
    const Vec2 heading(std::cos(heading_rad), std::sin(heading_rad));
    no_verdict = shown.at(Vec2(3.5, 0), heading).infeasible.empty() && no_verdict;
  }
  return no_verdict;
}

TEST(Retracing, LeadsOutOfAPocketFromWhichNoPathExists) {
  const TrialSpec spec = beside_a_box(Vec2(8, 0));
  Shown shown(spec);
  EXPECT_TRUE(fly_into(shown));
  EXPECT_EQ(shown.report().executive, ExecutiveState::retracing);
  ASSERT_FALSE(shown.path().empty());
  EXPECT_LT(shown.path().back().x(), 3.2);
  EXPECT_NEAR(shown.path().back().y(), 0, 0.01);
}

TEST(Retracing, IsNotTriedAndNoVerdictGivenWhereRecoveryIsOff) {
  TrialSpec spec = beside_a_box(Vec2(8, 0));
  spec.flight.navigation.recovery = false;
  Shown shown(spec);
  EXPECT_TRUE(fly_into(shown));
  EXPECT_TRUE(shown.path().empty());
}

TEST(Retracing, IsNotTriedWhereTheMissionHasNoPathEither) {
  const TrialSpec spec = beside_a_box(Vec2(4.2, 0.5));
  Shown shown(spec);
  // Around the box, until all of it is known.
  for (int i = 0; i < 400 && shown.report().infeasible.empty(); ++i) {
    const double bearing_rad = std::numbers::pi * (1 + i / 200.0);
    const Vec2 outward(std::cos(bearing_rad), std::sin(bearing_rad));
    shown.at(Vec2(3.5, 0) + 3.5 * outward, -outward);
  }
  EXPECT_EQ(shown.report().infeasible, "the planner proved that no path exists");
}

}  // namespace
}  // namespace voronaut
