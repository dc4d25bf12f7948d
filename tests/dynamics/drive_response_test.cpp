#include "voronaut/dynamics/drive_response.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "voronaut/tests/dynamics/commanded_drive.h"
#include "voronaut/tests/dynamics/track_distance.h"

namespace voronaut {
namespace {

using Eigen::Vector2d;
using testing::CommandedDrive;
using testing::distance_m;
using testing::kPeriod_s;

constexpr double kHold_s = 0.05;
constexpr double kSample_s = 0.05;  // as the governor samples: chords of arcs are part of the error

// Predicts and drives a stop. The governor sweeps the whole track: what counts is how far the drive
// strays from it.
double error_m(CommandedDrive& drive, const ArcCommand& before, const ArcCommand& command) {
  std::vector<Vector2d> track;
  drive.response().predict_stop(drive.motion(), before, command, kHold_s, kSample_s, track);
  double largest = 0;
  for (int i = 0; i < 400; ++i) {
    largest = std::max(largest, distance_m(drive.motion().p_m, track));
    drive.step(i * kPeriod_s < kHold_s - 1e-9 ? command : ArcCommand{});
  }
  return largest;
}

// A drive under random arcs, held as navigation holds them; at random moments the stop from there
// is both predicted and driven. The largest distance between prediction and drive over that many
// stops, as a share of what is promised.
double largest_share(CommandedDrive drive, int stops) {
  double largest = 0;
  while (stops > 0) {
    drive.begin();
    ArcCommand before;
    for (int hold = 0; hold < 60 && stops > 0; ++hold) {
      const ArcCommand command = drive.next_command(before);
      if (hold > 3 && drive.uniform(0, 1) < 0.1) {
        const double promised = drive.response().error_m(drive.motion(), command);
        largest = std::max(largest, error_m(drive, before, command) / promised);
        --stops;
        break;
      }
      drive.drive(command, kHold_s);
      before = command;
    }
  }
  return largest;
}

TEST(DriveResponse, PredictsTheStopsOfEverythingOnWheelsWithinItsError) {
  unsigned seed = 0;
  for (const VehicleSpec& spec : testing::wheeled()) {
    const double share = largest_share({spec, ++seed}, 3000);
    RecordProperty(spec.name, std::to_string(share));
    EXPECT_LE(share, 1) << spec.name;
    EXPECT_GT(share, 0.1) << spec.name << ": promises far less than it keeps";
  }
}

// What the bound is made for: brakes that are weaker than predicted by a quarter break it.
TEST(DriveResponse, StraysFromThePredictionOfAnotherLaw) {
  VehicleSpec spec = find_vehicle("unicycle");
  CommandedDrive drive(spec, 1);
  spec.limits.max_acceleration_m_s2 *= 1.3;
  std::get<UnicycleConfig>(spec.model).max_acceleration_m_s2 *= 1.3;
  const auto wrong =
      std::get<DriveResponse>(motion_response(find_regulator(spec.regulator), spec, kPeriod_s));
  drive.begin();
  const ArcCommand arc{2, 1};
  drive.drive(arc, 2);
  std::vector<Vector2d> track;
  wrong.predict_stop(drive.motion(), arc, arc, kHold_s, kSample_s, track);
  const double promised_m = wrong.error_m(drive.motion(), arc);
  drive.drive(arc, kHold_s);
  drive.drive({}, 3);
  EXPECT_GT(distance_m(drive.motion().p_m, track), promised_m);
}

TEST(DriveResponse, TurnsOnTheSpotWithoutLeavingIt) {
  for (const VehicleSpec& spec : testing::wheeled()) {
    CommandedDrive drive(spec, 1);
    drive.begin();
    const ArcCommand turn{0, drive.response().limits.max_yaw_rate_rad_s};
    std::vector<Vector2d> track;
    drive.response().predict_stop(drive.motion(), {}, turn, kHold_s, kSample_s, track);
    for (const Vector2d& p : track) EXPECT_EQ(p.norm(), 0) << spec.name;
    const Vector2d start = drive.motion().p_m;
    drive.drive(turn, 2);
    // The cart's centre of mass lies ahead of its axle and pulls it along.
    EXPECT_LT((drive.motion().p_m - start).norm(), 5e-4) << spec.name;
  }
}

}  // namespace
}  // namespace voronaut
