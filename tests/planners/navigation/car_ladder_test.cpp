#include "voronaut/planners/navigation/car_ladder.h"

#include <gtest/gtest.h>

#include "voronaut/tests/planners/navigation/dash.h"

namespace voronaut {
namespace {

using testing::kPeriod_s;

VehicleSpec car() { return find_vehicle("car"); }

CarLadder ladder_of_car() {
  return CarLadder(
      std::get<CarResponse>(motion_response(find_regulator("car_tracker"), car(), kPeriod_s)));
}

VehicleState standing_at(const Vec2& p) {
  return make_model(car().model)->at_rest({p.x(), p.y(), 0}, {1, 0});
}

ArcCommand all_of(const CarLadder& ladder) {
  return std::get<ArcCommand>(ladder.command(ladder.top()));
}

WantedMotion to(const Vec2& way_m) {
  return {.v_world = way_m.normalized(), .lookahead_m = way_m.norm()};
}

TEST(CarLadder, NeverTurnsOnTheSpot) {
  CarLadder ladder = ladder_of_car();
  for (const Vec2& way : {Vec2(1, 0), Vec2(0, 3), Vec2(-3, 0.1), Vec2(0.1, 0.2)}) {
    ladder.set_up(to(way), standing_at(Vec2(0, 0)));
    for (std::size_t level = 1; level <= ladder.top(); ++level)
      EXPECT_NE(std::get<ArcCommand>(ladder.command(level)).v_m_s, 0);
  }
  ladder.set_up({.heading_world = Vec2(0, 1)}, standing_at(Vec2(0, 0)));
  EXPECT_EQ(ladder.top(), 0U);
}

TEST(CarLadder, BacksUpForWhatLiesWithinItsTurningCircleTurningToItsSide) {
  CarLadder ladder = ladder_of_car();
  ladder.set_up(to(Vec2(0.1, 0.4)), standing_at(Vec2(0, 0)));
  EXPECT_LT(all_of(ladder).v_m_s, 0);
  EXPECT_GT(all_of(ladder).w_rad_s, 0) << "to the left";
}

TEST(CarLadder, BacksUpWhereTheWayAheadIsNotFreeAndGoesAheadWhereTheWayBackIsNot) {
  CarLadder ladder = ladder_of_car();
  const VehicleState here = standing_at(Vec2(0, 0));
  const WantedMotion aside = to(Vec2(0.2, 3));
  ladder.set_up(aside, here);
  EXPECT_GT(all_of(ladder).v_m_s, 0);
  ladder.give(0);  // held back
  ladder.set_up(aside, here);
  EXPECT_LT(all_of(ladder).v_m_s, 0);
  ladder.give(ladder.top());
  ladder.set_up(aside, here);
  EXPECT_LT(all_of(ladder).v_m_s, 0) << "it keeps to it";
  ladder.give(0);
  ladder.set_up(aside, here);
  EXPECT_GT(all_of(ladder).v_m_s, 0);
}

TEST(CarLadder, BacksUpNoFartherThanATurningRadius) {
  CarLadder ladder = ladder_of_car();
  const WantedMotion behind = to(Vec2(-3, 0.5));
  ladder.set_up(behind, standing_at(Vec2(0, 0)));
  ladder.give(0);
  ladder.set_up(behind, standing_at(Vec2(0, 0)));
  ASSERT_LT(all_of(ladder).v_m_s, 0);
  ladder.give(ladder.top());
  ladder.set_up(behind, standing_at(Vec2(-0.6, 0)));
  EXPECT_LT(all_of(ladder).v_m_s, 0);
  ladder.give(ladder.top());
  ladder.set_up(behind, standing_at(Vec2(-0.8, 0)));
  EXPECT_GT(all_of(ladder).v_m_s, 0);
}

// Else it would go to and fro on the spot: each part undoes the reason for the one before.
TEST(CarLadder, KeepsToAPartOfATurnForHalfARadius) {
  CarLadder ladder = ladder_of_car();
  const WantedMotion within = to(Vec2(0.1, 0.4));
  ladder.set_up(within, standing_at(Vec2(0, 0)));
  ladder.give(0);
  ladder.set_up(within, standing_at(Vec2(0, 0)));
  EXPECT_GT(all_of(ladder).v_m_s, 0) << "the way back is not free";
  ladder.give(ladder.top());
  ladder.set_up(within, standing_at(Vec2(0.3, 0)));
  EXPECT_GT(all_of(ladder).v_m_s, 0);
  ladder.give(ladder.top());
  ladder.set_up(within, standing_at(Vec2(0.4, 0)));
  EXPECT_LT(all_of(ladder).v_m_s, 0);
}

TEST(CarLadder, RetracesBackwards) {
  CarLadder ladder = ladder_of_car();
  WantedMotion back = to(Vec2(-1, 0.2));
  back.may_reverse = true;
  ladder.set_up(back, standing_at(Vec2(0, 0)));
  EXPECT_LT(all_of(ladder).v_m_s, 0);
  EXPECT_LT(all_of(ladder).w_rad_s, 0);
}

}  // namespace
}  // namespace voronaut
