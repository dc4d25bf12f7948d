#include "voronaut/dynamics/velocity_response.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "voronaut/tests/dynamics/commanded_flight.h"
#include "voronaut/tests/dynamics/track_distance.h"

namespace voronaut {
namespace {

using Eigen::Vector2d;
using testing::CommandedFlight;
using testing::distance_m;
using testing::kPeriod_s;

constexpr double kHold_s = 0.05;

Vector2d random_command(CommandedFlight& flight, const Vector2d& before) {
  const double what = flight.uniform(0, 1);
  if (what < 0.7) return before;
  if (what < 0.8) return {0, 0};
  if (what < 0.9) return -before;
  return flight.uniform(0, flight.spec().limits.max_speed_m_s) * flight.direction();
}

// Predicts and flies a stop. The governor sweeps the whole track: what counts is how far the flight
// strays from it.
double error_m(CommandedFlight& flight, const Vector2d& before, const Vector2d& command) {
  std::vector<Vector2d> track;
  flight.response().predict_stop(flight.motion(), before, command, kHold_s, kPeriod_s, track);
  const double yaw_rate_rad_s = flight.uniform(-2, 2);
  double largest = 0;
  for (int i = 0; i < 400; ++i) {
    largest = std::max(largest, distance_m(flight.motion().p_m, track));
    const bool holding = i * kPeriod_s < kHold_s - 1e-9;
    flight.step(holding ? command : Vector2d(0, 0), yaw_rate_rad_s);
  }
  return largest;
}

// A flight under random commands, held as navigation holds them; at random moments the stop from
// there is both predicted and flown. The largest distance between prediction and flight over that
// many stops, as a share of what is promised.
double largest_share(CommandedFlight flight, int stops) {
  double largest = 0;
  while (stops > 0) {
    flight.begin();
    Vector2d before(0, 0);
    for (int hold = 0; hold < 60 && stops > 0; ++hold) {
      const Vector2d command = random_command(flight, before);
      if (hold > 3 && flight.uniform(0, 1) < 0.1) {
        const double promised = flight.response().error_m(flight.motion(), command);
        largest = std::max(largest, error_m(flight, before, command) / promised);
        --stops;
        break;
      }
      flight.fly(command, kHold_s);
      before = command;
    }
  }
  return largest;
}

TEST(VelocityResponse, PredictsTheStopsOfTheIdealVehicleWithinItsError) {
  const double share = largest_share({find_vehicle("ideal"), find_regulator("ideal"), 1}, 3000);
  RecordProperty("share", std::to_string(share));
  EXPECT_LE(share, 1);
}

TEST(VelocityResponse, PredictsTheStopsOfTheQuadrotorWithinItsError) {
  const double share =
      largest_share({find_vehicle("quadrotor"), find_regulator("pd_rate"), 2}, 3000);
  RecordProperty("share", std::to_string(share));
  EXPECT_LE(share, 1);
}

TEST(VelocityResponse, PredictsTheStopsOfThePrintedInertiaWithinItsError) {
  const double share = largest_share(
      {testing::quadrotor_with_printed_inertia(), find_regulator("pd_rate"), 3}, 3000);
  RecordProperty("share", std::to_string(share));
  EXPECT_LE(share, 1);
}

TEST(VelocityResponse, PromisesNoStopForTheUnstableLiteralLaw) {
  EXPECT_THROW(
      velocity_response(find_regulator("paper_literal"), find_vehicle("quadrotor"), kPeriod_s),
      std::invalid_argument);
}

TEST(VelocityResponse, IsNoneOfWhatCannotMoveSideways) {
  for (const char* name : {"car", "cart", "unicycle"}) {
    const VehicleSpec spec = find_vehicle(name);
    EXPECT_THROW(velocity_response(find_regulator(spec.regulator), spec, kPeriod_s),
                 std::invalid_argument);
  }
}

}  // namespace
}  // namespace voronaut
