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
  const double period_s = flight.period_s();
  flight.response().predict_stop(flight.motion(), before, command, kHold_s, period_s, track);
  const double yaw_rate_rad_s = flight.uniform(-2, 2);
  double largest = 0;
  for (int i = 0; i * period_s < 4; ++i) {
    largest = std::max(largest, distance_m(flight.motion().p_m, track));
    const bool holding = i * period_s < kHold_s - 1e-9;
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

// The same under commands as the governor gives them, v + 1.6 (wanted - v) with levels of speed
// that change from one hold to the next: harsher than what random ones come to.
double largest_governed_share(CommandedFlight flight, int stops) {
  constexpr double kVelocityGain = 1.6;
  constexpr double kScales[] = {0, 0.05, 0.12, 0.25, 0.4, 0.6, 0.8, 1};
  const auto wanted_velocity = [&]() -> Vector2d {
    return flight.uniform(0.3, flight.spec().limits.max_speed_m_s) * flight.direction();
  };
  double largest = 0;
  for (; stops > 0; --stops) {
    flight.begin();
    Vector2d before(0, 0);
    Vector2d wanted = wanted_velocity();
    int level = 7;
    const int holds = static_cast<int>(flight.uniform(5, 100));
    for (int hold = 0; hold <= holds; ++hold) {
      if (flight.uniform(0, 1) < 0.1) wanted = wanted_velocity();
      if (flight.uniform(0, 1) < 0.5)
        level = std::clamp(level + static_cast<int>(flight.uniform(-2.99, 2.99)), 0, 7);
      const Vector2d v = flight.motion().v_m_s;
      const Vector2d allowed = kScales[level] * wanted;
      const Vector2d command =
          level == 0 ? Vector2d(0, 0) : Vector2d(v + kVelocityGain * (allowed - v));
      if (hold < holds) {
        flight.fly(command, kHold_s);
        before = command;
      } else {
        const double promised = flight.response().error_m(flight.motion(), allowed);
        largest = std::max(largest, error_m(flight, before, command) / promised);
      }
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

// On both sets of inertia.
void expect_kept(const std::string& regulator, double period_s, int stops, unsigned seed) {
  for (const VehicleSpec& vehicle :
       {find_vehicle("quadrotor"), testing::quadrotor_with_printed_inertia()}) {
    const double share =
        largest_share({vehicle, find_regulator(regulator), ++seed, period_s}, stops);
    const double governed =
        largest_governed_share({vehicle, find_regulator(regulator), seed, period_s}, stops);
    ::testing::Test::RecordProperty(regulator + std::to_string(seed),
                                    std::to_string(share) + " " + std::to_string(governed));
    EXPECT_LE(governed, 1) << regulator << " governed, at " << period_s << " s, seed " << seed;
    EXPECT_LE(share, 1) << regulator << " at " << period_s << " s, seed " << seed;
  }
}

TEST(VelocityResponse, PredictsTheStopsOfEveryRegulatorOfTheQuadrotorWithinItsError) {
  for (const char* regulator : {"pd_rate", "cascade_pid", "se3", "lqr"})
    expect_kept(regulator, kPeriod_s, 2000, 10);
}

TEST(VelocityResponse, PredictsTheStopsAtOtherPeriodsWithinItsError) {
  for (const char* regulator : {"pd_rate", "cascade_pid", "se3", "lqr"}) {
    expect_kept(regulator, 0.005, 600, 20);
    expect_kept(regulator, 0.02, 600, 30);
  }
}

TEST(VelocityResponse, PredictsTheStopsOfARegulatorThatReadsTheTiltWithinItsError) {
  PdRateConfig config;
  config.acceleration = PdRateConfig::Acceleration::attitude;
  EXPECT_LE(largest_share({find_vehicle("quadrotor"), config, 40}, 3000), 1);
}

// Where a stop ends that begins tilted back, the way there included.
TEST(VelocityResponse, PredictsAStopFromFullTiltBetterWhereThePushGrows) {
  CommandedFlight flight(find_vehicle("quadrotor"), find_regulator("pd_rate"), 1);
  flight.begin();
  flight.fly({2.5, 0}, 4);
  flight.fly({-2.5, 0}, 0.3);
  VelocityResponse flat = flight.response();
  EXPECT_GT(flat.push_growth, 1);
  flat.push_growth = 0;
  std::vector<Vector2d> track, flat_track;
  const Vector2d before(-2.5, 0), stop(0, 0);
  flight.response().predict_stop(flight.motion(), before, stop, 0, kPeriod_s, track);
  flat.predict_stop(flight.motion(), before, stop, 0, kPeriod_s, flat_track);
  flight.fly(stop, 6);
  const Vector2d end = flight.motion().p_m;
  EXPECT_LT((track.back() - end).norm(), 0.8 * (flat_track.back() - end).norm());
}

TEST(VelocityResponse, PromisesNoStopForTheUnstableLiteralLaw) {
  EXPECT_THROW(
      velocity_response(find_regulator("paper_literal"), find_vehicle("quadrotor"), kPeriod_s),
      std::invalid_argument);
}

TEST(VelocityResponse, PromisesNoStopAtPeriodsAtWhichNobodyFlewThem) {
  const VehicleSpec vehicle = find_vehicle("quadrotor");
  EXPECT_NO_THROW(velocity_response(find_regulator("pd_rate"), vehicle, 0.02));
  EXPECT_THROW(velocity_response(find_regulator("pd_rate"), vehicle, 0.021), std::invalid_argument);
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
