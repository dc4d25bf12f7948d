#include "voronaut/planners/navigation/recovery.h"

#include <numbers>

#include <gtest/gtest.h>

#include "voronaut/environments/sensing/scan.h"
#include "voronaut/planners/mapping/virtual_obstacles.h"
#include "voronaut/planners/navigation/look_around.h"

namespace voronaut {
namespace {

constexpr double kTimeout_s = 1.5;

// The next action other than none, of a vehicle that stands at p.
RecoveryAction next_action(RecoveryPolicy& policy, double& now_s, MissionProgress progress) {
  for (int scan = 0; scan < 100; ++scan) {
    now_s += 0.05;
    progress.now_s = now_s;
    const RecoveryAction action = policy.advise(progress);
    if (action != RecoveryAction::none) return action;
  }
  return RecoveryAction::none;
}

TEST(RecoveryPolicy, GoesFromTheMildestStepToTheHarshest) {
  RecoveryPolicy policy(kTimeout_s);
  double now_s = 0;
  MissionProgress stalled;
  stalled.wants_to_move = true;
  stalled.obstacle_within_clearance = true;
  EXPECT_EQ(next_action(policy, now_s, stalled), RecoveryAction::back_off);
  EXPECT_GE(now_s, kTimeout_s);
  EXPECT_EQ(next_action(policy, now_s, stalled), RecoveryAction::look_around);
  EXPECT_EQ(next_action(policy, now_s, stalled), RecoveryAction::reduce_clearance);
  EXPECT_EQ(next_action(policy, now_s, stalled), RecoveryAction::add_virtual_obstacle);
}

TEST(RecoveryPolicy, BeginsANewRoundWithoutTheVirtualObstaclesOfTheLast) {
  RecoveryPolicy policy(kTimeout_s);
  double now_s = 0;
  MissionProgress stalled;
  stalled.wants_to_move = true;
  stalled.obstacle_within_clearance = true;
  for (int step = 0; step < 4; ++step) next_action(policy, now_s, stalled);
  stalled.virtual_in_force = true;
  EXPECT_EQ(next_action(policy, now_s, stalled), RecoveryAction::drop_virtual_obstacles);
  EXPECT_EQ(next_action(policy, now_s, stalled), RecoveryAction::look_around);
  EXPECT_EQ(next_action(policy, now_s, stalled), RecoveryAction::reduce_clearance);
}

TEST(RecoveryPolicy, LooksBeforeItBacksOffFromWhatIsUnknown) {
  RecoveryPolicy policy(kTimeout_s);
  double now_s = 0;
  MissionProgress stalled;
  stalled.wants_to_move = true;
  stalled.unknown_within_clearance = true;
  EXPECT_EQ(next_action(policy, now_s, stalled), RecoveryAction::look_around);
  EXPECT_EQ(next_action(policy, now_s, stalled), RecoveryAction::back_off);
  EXPECT_EQ(next_action(policy, now_s, stalled), RecoveryAction::reduce_clearance);
  EXPECT_EQ(next_action(policy, now_s, stalled), RecoveryAction::add_virtual_obstacle);
}

TEST(RecoveryPolicy, LetsAVehicleThatMovesAlone) {
  RecoveryPolicy policy(kTimeout_s);
  double now_s = 0;
  MissionProgress moving;
  moving.wants_to_move = true;
  moving.speed_m_s = 0.5;
  EXPECT_EQ(next_action(policy, now_s, moving), RecoveryAction::none);
}

TEST(RecoveryPolicy, StartsAnewOnceItHasGotAway) {
  RecoveryPolicy policy(kTimeout_s);
  double now_s = 0;
  MissionProgress stalled;
  stalled.wants_to_move = true;
  EXPECT_EQ(next_action(policy, now_s, stalled), RecoveryAction::look_around);
  EXPECT_EQ(next_action(policy, now_s, stalled), RecoveryAction::look_around);
  stalled.p_world = Vec2(3, 0);
  EXPECT_EQ(next_action(policy, now_s, stalled), RecoveryAction::look_around);
}

// Half a metre from the place is away from it.
TEST(RecoveryPolicy, GoesOnWithItsStepsAsLongAsItIsStillNearThePlace) {
  const auto second_step_at = [](double moved_m) {
    RecoveryPolicy policy(kTimeout_s);
    double now_s = 0;
    MissionProgress stalled;
    stalled.wants_to_move = true;
    stalled.obstacle_within_clearance = true;
    EXPECT_EQ(next_action(policy, now_s, stalled), RecoveryAction::back_off);
    stalled.p_world = Vec2(moved_m, 0);
    return next_action(policy, now_s, stalled);
  };
  EXPECT_EQ(second_step_at(0.45), RecoveryAction::look_around);
  EXPECT_EQ(second_step_at(0.55), RecoveryAction::back_off);
}

TEST(RecoveryPolicy, DropsVirtualObstaclesWhenPlanningFailsWithThemButNotForEver) {
  RecoveryPolicy policy(kTimeout_s);
  double now_s = 0;
  MissionProgress without_path;
  without_path.virtual_in_force = true;
  for (int i = 0; i < 3; ++i)
    EXPECT_EQ(next_action(policy, now_s, without_path), RecoveryAction::drop_virtual_obstacles);
  EXPECT_EQ(next_action(policy, now_s, without_path), RecoveryAction::none);
}

TEST(RecoveryPolicy, GoesBackFromWhatIsTooCloseWhereNoPathIsFound) {
  RecoveryPolicy policy(kTimeout_s);
  double now_s = 0;
  MissionProgress without_path;
  without_path.obstacle_within_clearance = true;
  EXPECT_EQ(next_action(policy, now_s, without_path), RecoveryAction::back_off);
  EXPECT_EQ(next_action(policy, now_s, without_path), RecoveryAction::look_around);
  EXPECT_EQ(next_action(policy, now_s, without_path), RecoveryAction::retrace);
  without_path.obstacle_within_clearance = false;
  EXPECT_EQ(next_action(policy, now_s, without_path), RecoveryAction::look_around);
}

TEST(LookAround, EndsWhenEveryDirectionHasBeenInView) {
  const double field_rad = std::numbers::pi / 2;
  LookAround look(field_rad);
  look.begin(Vec2(1, 0));
  double turned_rad = 0;
  while (look.active()) {
    turned_rad += 0.1;
    look.advance(Vec2(std::cos(turned_rad), std::sin(turned_rad)));
    ASSERT_LT(turned_rad, 2 * std::numbers::pi);
  }
  EXPECT_GT(turned_rad, 2 * std::numbers::pi - field_rad);
}

TEST(LookAround, HasNothingToDoForASensorThatSeesAllAround) {
  LookAround look(2 * std::numbers::pi);
  look.begin(Vec2(1, 0));
  EXPECT_FALSE(look.active());
}

TEST(VirtualObstacles, AreSeenByPlannersAndLeaveTheMapAlone) {
  ObstacleBase base({});
  VirtualObstacles virtual_obstacles;
  EXPECT_TRUE(virtual_obstacles.over(base.snapshot()).disc_is_clear(Vec2(2, 1), 0.4));
  virtual_obstacles.add(Vec2(2, 1));
  EXPECT_FALSE(virtual_obstacles.over(base.snapshot()).disc_is_clear(Vec2(2, 1), 0.4));
  EXPECT_TRUE(base.snapshot().disc_is_clear(Vec2(2, 1), 0.4));
  virtual_obstacles.clear();
  EXPECT_TRUE(virtual_obstacles.over(base.snapshot()).disc_is_clear(Vec2(2, 1), 0.4));
}

}  // namespace
}  // namespace voronaut
