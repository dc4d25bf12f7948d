#include "voronaut/planners/navigation/footprint_sweep.h"

#include <gtest/gtest.h>

#include "voronaut/environments/shapes/convex_distance.h"
#include "voronaut/planners/mapping/points/convex_polygon.h"
#include "voronaut/planners/navigation/safety_governor.h"
#include "voronaut/tests/dynamics/commanded_drive.h"

namespace voronaut {
namespace {

using testing::CommandedDrive;
using testing::kPeriod_s;

constexpr double kHold_s = 0.05;
const Bounds kBounds{Vec2(-5, -5), Vec2(5, 5)};

Footprint rectangle(double length_m, double width_m, double ahead_m = 0) {
  return {.corners_body = box(Vec2(ahead_m, 0), length_m, width_m).vertices};
}

// How far corners of a body that drives and stops come out of all that was predicted, beside the
// stop's stray.
double sticks_out_m(CommandedDrive& drive, const ArcCommand& before, const ArcCommand& command,
                    const Footprint& footprint) {
  std::vector<Vec2> track, headings;
  drive.response().predict_stop(drive.motion(), before, command, kHold_s, FootprintSweep::kSample_s,
                                track, &headings);
  EXPECT_EQ(track.size(), headings.size());
  std::vector<std::vector<Vec2>> hulls;
  for (std::size_t i = 0; i + 1 < track.size(); ++i) {
    std::vector<Vec2> hull, next;
    place_corners(footprint.corners_body, track[i], headings[i], hull);
    place_corners(footprint.corners_body, track[i + 1], headings[i + 1], next);
    hull.insert(hull.end(), next.begin(), next.end());
    reduce_to_convex_hull(hull);
    hulls.push_back(hull);
  }
  const double stray_m = drive.response().error_m(drive.motion(), command);
  double largest_m = 0;
  std::vector<Vec2> corners;
  for (int i = 0; i < 300; ++i) {
    const DriveMotion now = drive.motion();
    place_corners(footprint.corners_body, now.p_m, now.heading, corners);
    for (const Vec2& corner : corners) {
      double out_m = kInfinity;
      for (const auto& hull : hulls)
        out_m = std::min(out_m, distance(std::span<const Vec2>(hull), corner));
      largest_m = std::max(largest_m, out_m - stray_m);
    }
    drive.step(i * kPeriod_s < kHold_s - 1e-9 ? command : ArcCommand{});
  }
  return largest_m;
}

TEST(FootprintSweep, HoldsAllThatABodySweepsOnItsWayToAStop) {
  unsigned seed = 0;
  for (const char* name : {"unicycle", "jackal", "cart"}) {
    for (const Footprint& footprint : {rectangle(0.5, 0.4), rectangle(0.8, 0.3, 0.2)}) {
      const double slack_m = FootprintSweep(footprint).slack_m();
      CommandedDrive drive(find_vehicle(name), ++seed);
      double largest_m = 0;
      for (int stops = 0; stops < 400;) {
        drive.begin();
        ArcCommand before;
        for (int hold = 0; hold < 60; ++hold) {
          const ArcCommand command = drive.next_command(before);
          if (hold > 3 && drive.uniform(0, 1) < 0.1) {
            largest_m = std::max(largest_m, sticks_out_m(drive, before, command, footprint));
            ++stops;
            break;
          }
          drive.drive(command, kHold_s);
          before = command;
        }
      }
      RecordProperty(name, std::to_string(largest_m / slack_m));
      EXPECT_LE(largest_m, slack_m) << name;
    }
  }
}

// Known to be free: |x| < half_length_m, |y| < half_width_m, in cells small enough to hide nothing.
FreeSpace free_box(double half_length_m, double half_width_m) {
  FreeSpace free(kBounds, {.cell_m = 0.01});
  const std::vector<Vec2> corners = box(Vec2(0, 0), 2 * half_length_m, 2 * half_width_m).vertices;
  free.mark_convex(corners);
  return free;
}

SafetyGovernor governor_of(const Footprint& footprint) {
  const VehicleSpec spec = find_vehicle("jackal");
  return {motion_response(find_regulator(spec.regulator), spec, kPeriod_s),
          circumscribed_radius_m(footprint.corners_body),
          0.3,
          kHold_s,
          SafetyGovernor::kEverywhere,
          footprint};
}

GovernedMotion allowed(const Footprint& footprint, const FreeSpace& free,
                       const WantedMotion& wanted) {
  SafetyGovernor governor = governor_of(footprint);
  const VehicleState state = make_model(UnicycleConfig{})->at_rest({0, 0, 0}, {1, 0});
  return governor.allow(wanted, state, free, {}, KnownClearance::planned);
}

TEST(FootprintSweep, LetsARectanglePassWhereTheDiscThatHoldsItDoesNot) {
  const Footprint footprint = rectangle(0.5, 0.4);  // a disc of 0.32 m
  const WantedMotion ahead{.v_world = Vec2(1, 0)};
  EXPECT_EQ(allowed(footprint, free_box(3, 0.24), ahead).speed_scale, 1);
  EXPECT_EQ(allowed(footprint, free_box(3, 0.19), ahead).speed_scale, 0);
}

TEST(FootprintSweep, LeavesTheWidthOfTheBodyAndLittleMore) {
  const Footprint footprint = rectangle(0.5, 0.4);
  double narrowest_m = 1;
  for (double half_width_m = 0.35; half_width_m > 0.15; half_width_m -= 0.01) {
    if (allowed(footprint, free_box(3, half_width_m), {.v_world = Vec2(1, 0)}).speed_scale > 0)
      narrowest_m = half_width_m;
  }
  EXPECT_GE(narrowest_m, 0.2);
  EXPECT_LE(narrowest_m, 0.23);
}

TEST(FootprintSweep, TurnsOnTheSpotOnlyWhereItsCornersHaveRoom) {
  const Footprint footprint = rectangle(0.5, 0.4);
  const WantedMotion turn{.v_world = Vec2(0, 0), .heading_world = Vec2(0, 1)};
  const auto rate = [&](const FreeSpace& free) {
    return std::get<ArcCommand>(allowed(footprint, free, turn).command).w_rad_s;
  };
  EXPECT_GT(rate(free_box(0.5, 0.5)), 1);
  EXPECT_LT(rate(free_box(3, 0.22)), 0.5) << "no more than its corners have room for";
}

TEST(FootprintSweep, DrivesAheadWhereItCouldNotTurn) {
  // The way to the point is an arc; turning to it on the spot, which disc bodies may do instead,
  // has no room.
  const Footprint footprint = rectangle(0.9, 0.4);
  const WantedMotion wanted{.v_world = Vec2(1, 0.02), .lookahead_m = 2};
  const GovernedMotion motion = allowed(footprint, free_box(4, 0.26), wanted);
  EXPECT_GT(motion.speed_scale, 0);
}

// At rest beside cells that nobody knows, a body may slide along them and leave them, and nothing
// that takes a part of it closer.
TEST(FootprintSweep, LeavesWhatItTouchesWithoutComingCloser) {
  const Footprint footprint = rectangle(0.5, 0.4);
  const FreeSpace free = [] {
    FreeSpace space(kBounds, {.cell_m = 0.01});
    const std::vector<Vec2> under = box(Vec2(0, 0), 0.5, 0.4).vertices;
    const std::vector<Vec2> ahead = box(Vec2(1.15, 0), 1.9, 1).vertices;
    space.mark_convex(under);
    space.mark_convex(ahead);  // from 5 cm before its front
    return space;
  }();
  const auto scale = [&](const WantedMotion& wanted) {
    return allowed(footprint, free, wanted).speed_scale;
  };
  EXPECT_GT(scale({.v_world = Vec2(1, 0)}), 0);
  EXPECT_LT(scale({.v_world = Vec2(1, 0)}), 0.5) << "slowly";
  EXPECT_EQ(scale({.v_world = Vec2(-1, 0), .may_reverse = true}), 0);
  EXPECT_EQ(scale({.v_world = Vec2(0.8, 0.6)}), 0);
}

TEST(FootprintSweep, FindsTheWayOutAlongItsHeading) {
  const Footprint footprint = rectangle(0.5, 0.4);
  FreeSpace free(kBounds, {.cell_m = 0.01});
  const std::vector<Vec2> behind = box(Vec2(-0.77, 0), 2.04, 1).vertices;
  free.mark_convex(behind);  // up to its front
  SafetyGovernor governor = governor_of(footprint);
  const VehicleState state = make_model(UnicycleConfig{})->at_rest({0, 0, 0}, {1, 0});
  const auto way = governor.way_out(Vec2(0.6, 0.8), state, 0.003, free, std::nullopt);
  ASSERT_TRUE(way);
  EXPECT_EQ(*way, Vec2(-1, 0));
  EXPECT_FALSE(governor.way_out(Vec2(1, 0), state, 0.003, free_box(2, 2), std::nullopt));
}

}  // namespace
}  // namespace voronaut
