#include <gtest/gtest.h>

#include "voronaut/planners/navigation/path_tracker.h"
#include "voronaut/planners/navigation/replan_policy.h"
#include "voronaut/planners/navigation/shortcut.h"
#include "voronaut/planners/navigation/speed_rule.h"
#include "voronaut/planners/navigation/yaw_policy.h"

namespace voronaut {
namespace {

constexpr double kMaxSpeed_m_s = 2.5;
const ObstacleSnapshot kNothing;

PathTracker tracker_on(const std::vector<Vec2>& points, PathEnd end = PathEnd::goal) {
  PathTracker tracker({}, SpeedProfile({}), kMaxSpeed_m_s);
  tracker.follow(Path::through(points), end);
  return tracker;
}

TEST(PathTracker, AimsFurtherAheadTheFasterItGoes) {
  PathTracker tracker = tracker_on({Vec2(0, 0), Vec2(10, 0)});
  tracker.advance(Vec2(1, 0.2));
  EXPECT_NEAR(tracker.lookahead(Vec2(1, 0.2), 0, kNothing, 0.4).p_world.x(), 1.25, 1e-12);
  EXPECT_NEAR(tracker.lookahead(Vec2(1, 0.2), 2, kNothing, 0.4).p_world.x(), 1.95, 1e-12);
  EXPECT_NEAR(tracker.distance_off_path_m(), 0.2, 1e-12);
}

TEST(PathTracker, StaysOnItsLegOfAHairpin) {
  // The way back runs 0.1 m beside the way out: a tracker that projects on the whole path jumps.
  PathTracker tracker = tracker_on({Vec2(0, 0), Vec2(5, 0), Vec2(5, 0.1), Vec2(0, 0.1)});
  for (double x = 0; x <= 3; x += 0.02) tracker.advance(Vec2(x, 0.09));
  EXPECT_NEAR(tracker.station_m(), 3, 0.03);
}

TEST(PathTracker, BrakesForTheGoalAndNotForTheEndOfALeg) {
  PathTracker to_goal = tracker_on({Vec2(0, 0), Vec2(1, 0)}, PathEnd::goal);
  PathTracker leg = tracker_on({Vec2(0, 0), Vec2(1, 0)}, PathEnd::leg);
  EXPECT_LT(to_goal.lookahead(Vec2(0, 0), 0, kNothing, 0.4).speed_limit_m_s, 1.0);
  EXPECT_DOUBLE_EQ(leg.lookahead(Vec2(0, 0), 0, kNothing, 0.4).speed_limit_m_s, kMaxSpeed_m_s);
  EXPECT_EQ(to_goal.lookahead(Vec2(0, 0), 2.5, kNothing, 0.4).end, PathEnd::goal);
  EXPECT_EQ(leg.lookahead(Vec2(0, 0), 2.5, kNothing, 0.4).end, PathEnd::leg);
}

TEST(PathTracker, HandsOverTheSegmentThatHoldsItsTargetButNoneAtTheEnd) {
  Path path = Path::through({Vec2(0, 0), Vec2(2, 0)});
  path.append({.kind = PathSegment::Kind::arc,
               .start = Vec2(2, 0),
               .end = Vec2(3, 1),
               .center = Vec2(2, 1)});
  PathTracker tracker({}, SpeedProfile({}), kMaxSpeed_m_s);
  tracker.follow(path, PathEnd::goal);
  const auto segment_at = [&](double station_m, double speed_m_s) {
    tracker.advance(path.point_at(station_m));
    return tracker.lookahead(path.point_at(station_m), speed_m_s, kNothing, 0.4).segment;
  };
  const auto line = segment_at(1.5, 0);
  ASSERT_TRUE(line);
  EXPECT_EQ(line->end, Vec2(2, 0));
  const auto arc = segment_at(1.5, 1);
  ASSERT_TRUE(arc);
  EXPECT_EQ(arc->kind, PathSegment::Kind::arc) << "0.6 m ahead is past the joint";
  EXPECT_TRUE(segment_at(2.4, 0));
  EXPECT_FALSE(segment_at(3.4, 0));
  tracker.drop();
  EXPECT_FALSE(tracker.lookahead(Vec2(0, 0), 0, kNothing, 0.4).segment);
}

TEST(PathTracker, SlowsDownBeforeASharpCorner) {
  const Path bent = Path::through({Vec2(0, 0), Vec2(4, 0), Vec2(0, 0.1)});
  const Path straight = Path::through({Vec2(0, 0), Vec2(4, 0), Vec2(8, 0)});
  EXPECT_DOUBLE_EQ(corner_speed_limit_m_s(straight, 3.9, kMaxSpeed_m_s, 1), kMaxSpeed_m_s);
  EXPECT_LT(corner_speed_limit_m_s(bent, 3.9, kMaxSpeed_m_s, 1), 0.6);
  EXPECT_DOUBLE_EQ(corner_speed_limit_m_s(bent, 0, kMaxSpeed_m_s, 1), kMaxSpeed_m_s);
}

TEST(YawPolicy, FixedNeverTurnsAndAlongThePathLooksAMetreAhead) {
  const PathTracker tracker = tracker_on({Vec2(0, 0), Vec2(0, 5)});
  YawPolicy fixed(YawReference::fixed, Vec2(1, 0));
  EXPECT_EQ(fixed.heading(tracker, Vec2(0, 0), Vec2(0, -1)), Vec2(1, 0));
  YawPolicy along(YawReference::path, Vec2(1, 0));
  EXPECT_NEAR((along.heading(tracker, Vec2(0, 0), {}) - Vec2(0, 1)).norm(), 0, 1e-12);
  EXPECT_EQ(along.heading(tracker, Vec2(0, 0), Vec2(-0.4, 0)), Vec2(-1, 0));
}

// A wall without thickness along x = 1 from y = -inf to y = top.
class WallBelow : public KnownGeometry {
 public:
  explicit WallBelow(double top_m) : top_m_(top_m) {}
  const ObstacleSnapshot& known_obstacles() const override { return kNothing; }
  double planning_clearance_m() const override { return 0; }
  bool motion_is_clear(const Vec2& a, const Vec2& b) const override {
    if ((a.x() < 1) == (b.x() < 1)) return true;
    const double t = (1 - a.x()) / (b.x() - a.x());
    return a.y() + t * (b.y() - a.y()) >= top_m_;
  }
  const Belief* belief() const override { return nullptr; }

 private:
  double top_m_;
};

TEST(Shortcut, KeepsOnlyTheCornersThatTheKnownObstaclesNeed) {
  const Path zigzag = Path::through(
      {Vec2(0, 0), Vec2(0.2, 0.9), Vec2(0.5, 0.1), Vec2(1, 1), Vec2(1.5, 0), Vec2(2, 0)});
  const Path straight = shortcut(zigzag, WallBelow(-5));
  EXPECT_EQ(straight.segments().size(), 1U);
  EXPECT_DOUBLE_EQ(straight.length_m(), 2.0);
  const Path around = shortcut(zigzag, WallBelow(0.8));
  EXPECT_LT(around.length_m(), zigzag.length_m());
  EXPECT_GT(around.segments().size(), 1U);
  EXPECT_EQ(around.back(), Vec2(2, 0));
}

Scan clear_scan() {
  Scan scan;
  scan.beams = std::make_shared<BeamFan>(BeamFan::spread(1.5707963267948966, 91));
  scan.max_range_m = 2.5;
  scan.range_m.assign(91, 2.5);
  return scan;
}

TEST(SpeedRule, UnlimitedIsTheVehiclesOwnLimit) {
  const Scan scan = clear_scan();
  const Belief belief{kNothing, &scan, {}, {}};
  EXPECT_EQ(speed_limit_m_s(SpeedRule::unlimited, belief, Vec2(-1, 0), {}, 0.1, 2.5), 2.5);
}

TEST(SpeedRule, StopsWithinTheRangeAndCreepsWhereItCannotSee) {
  const Scan scan = clear_scan();
  const Belief belief{kNothing, &scan, {}, {}};
  const Braking braking{1.786, 3.57, 0.4};
  const auto rule = SpeedRule::stopping_distance;
  EXPECT_GT(speed_limit_m_s(rule, belief, Vec2(1, 0), braking, 0.06, 2.5), 2.4);
  EXPECT_LT(speed_limit_m_s(rule, belief, Vec2(1, 0), braking, 1.0, 2.5), 2.0);
  EXPECT_EQ(speed_limit_m_s(rule, belief, Vec2(0, 1), braking, 0.06, 2.5), kBlindSpeed_m_s);
}

TEST(SpeedRule, SlowsDownTowardsAKnownPoint) {
  Scan scan = clear_scan();
  scan.range_m[45] = 1.2;
  ObstacleBase base({});
  base.update(scan);
  const Belief belief{base.snapshot(), &scan, {}, {}};
  const Braking braking{1.786, 3.57, 0.4};
  const double limit_m_s =
      speed_limit_m_s(SpeedRule::stopping_distance, belief, Vec2(1, 0), braking, 0.06, 2.5);
  // 0.8 m until the disc of 0.4 m touches the point: V/k + V t_r = 0.8.
  EXPECT_NEAR(limit_m_s, 0.9 * 0.8 / (1 / 1.786 + 0.06), 0.1);
}

}  // namespace
}  // namespace voronaut
