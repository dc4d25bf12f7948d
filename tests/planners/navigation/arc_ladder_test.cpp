#include "voronaut/planners/navigation/arc_ladder.h"

#include <gtest/gtest.h>

#include "voronaut/tests/planners/mapping/known_points.h"
#include "voronaut/tests/planners/navigation/dash.h"

namespace voronaut {
namespace {

using testing::kBodyRadius_m;
using testing::kBounds;
using testing::kClearance_m;
using testing::kPeriod_s;

constexpr double kHold_s = 0.05;

VehicleSpec unicycle() { return find_vehicle("unicycle"); }

DriveResponse response() {
  return std::get<DriveResponse>(
      motion_response(find_regulator("arc_tracker"), unicycle(), kPeriod_s));
}

VehicleState at_rest(const Vec2& heading = Vec2(1, 0)) {
  return make_model(unicycle().model)->at_rest({0, 0, 0}, heading);
}

VehicleState driving(double v_m_s) {
  VehicleState state = at_rest();
  state.v_world.x() = v_m_s;
  return state;
}

// What a governor allows in the middle of a known-free disc, or in what is too narrow for the body.
GovernedMotion allowed(const WantedMotion& wanted, const VehicleState& state,
                       double free_radius_m = 4) {
  SafetyGovernor governor(response(), kBodyRadius_m, kClearance_m, kHold_s);
  FreeSpace free(kBounds);
  free.mark_disc(Vec2(0, 0), free_radius_m);
  return governor.allow(wanted, state, free, {}, KnownClearance::planned);
}

ArcCommand arc_of(const GovernedMotion& motion) { return std::get<ArcCommand>(motion.command); }

TEST(ArcLadder, ScalesSpeedAndYawRateTogether) {
  ArcLadder ladder(response());
  ladder.set_up({.v_world = Vec2(1, 0.1), .lookahead_m = 0.5}, driving(1));
  const auto full = std::get<ArcCommand>(ladder.command(ladder.top()));
  EXPECT_GT(full.w_rad_s, 0);
  for (std::size_t level = 2; level <= ladder.top(); ++level) {
    const auto arc = std::get<ArcCommand>(ladder.command(level));
    EXPECT_NEAR(arc.w_rad_s / arc.v_m_s, full.w_rad_s / full.v_m_s, 1e-12) << level;
    EXPECT_NEAR(arc.v_m_s, ladder.speed_scale(level) * full.v_m_s, 1e-12) << level;
  }
}

// From where the vehicle will be once its yaw rate has followed, one time constant later.
TEST(ArcLadder, LeadsThroughThePointThatIsWanted) {
  const Vec2 towards = Vec2(1, 0.4).normalized();
  for (const double v_m_s : {0.0, 0.4}) {
    ArcLadder ladder(response());
    ladder.set_up({.v_world = 0.4 * towards, .lookahead_m = 0.4}, driving(v_m_s));
    const auto arc = std::get<ArcCommand>(ladder.command(ladder.top()));
    const Vec2 from(v_m_s / response().yaw_rate_gain_1_s, 0);
    // Its centre lies to the left, as far from there as from the point.
    const Vec2 centre = from + Vec2(0, arc.v_m_s / arc.w_rad_s);
    EXPECT_NEAR((0.4 * towards - centre).norm(), (from - centre).norm(), 1e-9) << v_m_s;
  }
}

TEST(ArcLadder, TurnsOnTheSpotWhereNothingButTheBodyHasRoom) {
  for (const Vec2& aside : {Vec2(0, 1), Vec2(0, -1), Vec2(-1, 0)}) {
    const GovernedMotion motion = allowed({.v_world = aside}, at_rest(), 0.3);
    EXPECT_EQ(arc_of(motion).v_m_s, 0);
    EXPECT_NE(arc_of(motion).w_rad_s, 0);
    EXPECT_EQ(motion.speed_scale, 1) << "nothing holds it back";
  }
}

TEST(ArcLadder, LooksWhereItIsToldWhileItStays) {
  const GovernedMotion motion = allowed({.heading_world = Vec2(0, -1)}, at_rest(), 0.3);
  EXPECT_EQ(arc_of(motion).v_m_s, 0);
  EXPECT_LT(arc_of(motion).w_rad_s, -1);
}

// What is not free at a quarter of the speed is turned to instead, so that what follows is
// straight.
TEST(ArcLadder, TurnsFirstWhereItCouldOnlyCreepAlongAnArc) {
  const Vec2 off = Vec2(1, 0.6).normalized();
  const WantedMotion wanted{.v_world = off, .lookahead_m = 0.3};
  const double full_m_s = arc_of(allowed(wanted, at_rest())).v_m_s;
  int turned = 0, drove = 0;
  for (double free_radius_m = 0.26; free_radius_m < 0.36; free_radius_m += 0.002) {
    SafetyGovernor governor(response(), kBodyRadius_m, kClearance_m, kHold_s);
    FreeSpace free(kBounds, {.cell_m = 0.01});
    free.mark_disc(Vec2(0, 0), free_radius_m);
    const GovernedMotion motion =
        governor.allow(wanted, at_rest(), free, {}, KnownClearance::planned);
    const ArcCommand arc = arc_of(motion);
    EXPECT_TRUE(arc.v_m_s == 0 || arc.v_m_s > 0.24 * full_m_s) << free_radius_m;
    EXPECT_GT(arc.w_rad_s, 0) << free_radius_m;
    EXPECT_EQ(motion.speed_scale == 0, arc.v_m_s == 0) << free_radius_m;
    EXPECT_TRUE(arc.v_m_s > 0 || motion.refused_at) << free_radius_m;
    ++(arc.v_m_s == 0 ? turned : drove);
  }
  EXPECT_GT(turned, 0);
  EXPECT_GT(drove, 0);
}

TEST(ArcLadder, ReversesOnlyIfItMay) {
  const WantedMotion back{.v_world = Vec2(-0.3, 0.05), .lookahead_m = 0.5, .may_reverse = true};
  const ArcCommand reversing = arc_of(allowed(back, at_rest()));
  EXPECT_LT(reversing.v_m_s, 0);
  // Backwards and to its left is a turn to the right.
  EXPECT_LT(reversing.w_rad_s, 0);
  WantedMotion forwards = back;
  forwards.may_reverse = false;
  EXPECT_EQ(arc_of(allowed(forwards, at_rest())).v_m_s, 0);
}

TEST(ArcLadder, ReversesAwayFromAWallThatItStandsTooCloseTo) {
  SafetyGovernor governor(response(), kBodyRadius_m, kClearance_m, kHold_s);
  FreeSpace free(kBounds);
  free.mark_disc(Vec2(-1, 0), 1.2);  // the body's own disc is not wholly known free
  const auto allow = [&](const Vec2& v) {
    return arc_of(governor.allow({.v_world = v, .lookahead_m = 0.5, .may_reverse = true}, at_rest(),
                                 free, {}, KnownClearance::planned));
  };
  EXPECT_LT(allow(Vec2(-0.3, 0)).v_m_s, 0);
  EXPECT_EQ(allow(Vec2(0.3, 0)).v_m_s, 0);
  EXPECT_GE(allow(Vec2(-2.5, 0)).v_m_s, -0.4) << "fast";
}

// Braking on a bend is another track than braking straight on: a turn is not always allowed.
TEST(ArcLadder, BrakesAsProvedWhereATurnMeanwhileWouldLeaveIt) {
  SafetyGovernor governor(response(), kBodyRadius_m, kClearance_m, kHold_s);
  FreeSpace free(kBounds, {.cell_m = 0.01});
  for (double x = -1; x < 3; x += 0.02) free.mark_disc(Vec2(x, 0), kBodyRadius_m + 0.03);
  const auto aside = [&](double v_m_s) {
    return arc_of(
        governor.allow({.v_world = Vec2(0, 1)}, driving(v_m_s), free, {}, KnownClearance::planned));
  };
  EXPECT_EQ(aside(2).v_m_s, 0);
  EXPECT_EQ(aside(2).w_rad_s, 0);
  EXPECT_GT(aside(0).w_rad_s, 1);
}

TEST(ArcLadder, RemembersWhatWasRefusedWhileItTurns) {
  SafetyGovernor governor(response(), kBodyRadius_m, kClearance_m, kHold_s);
  FreeSpace free(kBounds);
  free.mark_disc(Vec2(0, 0), 0.27);
  const auto allow = [&](const WantedMotion& wanted) {
    return governor.allow(wanted, at_rest(), free, {}, KnownClearance::planned);
  };
  const auto refused_at = allow({.v_world = Vec2(2.5, 0)}).refused_at;
  ASSERT_TRUE(refused_at);
  EXPECT_EQ(allow({.heading_world = Vec2(0, 1)}).refused_at, refused_at);
  free.mark_disc(*refused_at, 0.3);
  EXPECT_FALSE(allow({.heading_world = Vec2(0, 1)}).refused_at) << "it is known by now";
}

}  // namespace
}  // namespace voronaut
