#include "voronaut/planners/navigation/departure.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "voronaut/tests/dynamics/commanded_drive.h"
#include "voronaut/tests/dynamics/commanded_flight.h"

namespace voronaut {
namespace {

using testing::CommandedFlight;

constexpr double kHold_s = 0.1;

Vec2 random_command(CommandedFlight& flight) {
  return flight.uniform(0, kDepartureSpeed_m_s) * flight.direction();
}

// A straight track of 0.2 m that leads away from the place by this share of its length.
bool leads_away_at(double share) {
  const Vec2 place(-0.3, 0);
  const Vec2 along(share, std::sqrt(1 - share * share));
  return leads_away(0.3 * along, std::vector<Vec2>{Vec2(0, 0), 0.2 * along},
                    std::vector<Vec2>{place});
}

// How much closer to the place it comes, at worst, holding the command and then braking [m].
double approach_m(CommandedFlight& flight, const Vec2& command, const Vec2& place) {
  const Vec2 start = flight.motion().p_m;
  const Vec2 towards = (place - start).normalized();
  const double yaw_rate_rad_s = flight.uniform(-2, 2);
  double worst_m = 0;
  for (int i = 0; i < 400; ++i) {
    flight.step(i * testing::kPeriod_s < kHold_s - 1e-9 ? command : Vec2(0, 0), yaw_rate_rad_s);
    worst_m = std::max(worst_m, (flight.motion().p_m - start).dot(towards));
  }
  return worst_m;
}

// The worst of many departures: a vehicle creeps about, mostly brakes, and takes a command that, as
// predicted, leads away from some place.
double worst_approach_m(CommandedFlight flight, int departures) {
  double worst_m = 0;
  while (departures > 0) {
    flight.begin();
    const Vec2 crept = random_command(flight);
    flight.fly(crept, flight.uniform(0, 2));
    const bool braked = flight.uniform(0, 1) < 0.7;
    if (braked) flight.fly(Vec2(0, 0), flight.uniform(0, 1.5));
    const Vec2 command = random_command(flight);
    const PlanarMotion now = flight.motion();
    if (std::max(command.norm(), now.v_m_s.norm()) > kDepartureSpeed_m_s) continue;
    std::vector<Vec2> track;
    flight.response().predict_stop(now, braked ? Vec2(0, 0) : crept, command, kHold_s, 0.05, track);
    const Vec2 place = now.p_m + 0.3 * flight.direction();
    if (!leads_away(command, track, std::vector<Vec2>{place})) continue;
    worst_m = std::max(worst_m, approach_m(flight, command, place));
    --departures;
  }
  return worst_m;
}

TEST(Departure, BringsNoVehicleCloserThanACentimetreToWhatItLeaves) {
  const double ideal_m =
      worst_approach_m({find_vehicle("ideal"), find_regulator("ideal"), 1}, 3000);
  const double quadrotor_m =
      worst_approach_m({find_vehicle("quadrotor"), find_regulator("pd_rate"), 2}, 3000);
  const double printed_m = worst_approach_m(
      {testing::quadrotor_with_printed_inertia(), find_regulator("pd_rate"), 3}, 3000);
  RecordProperty("ideal_m", std::to_string(ideal_m));
  RecordProperty("quadrotor_m", std::to_string(quadrotor_m));
  RecordProperty("printed_m", std::to_string(printed_m));
  EXPECT_LE(std::max({ideal_m, quadrotor_m, printed_m}), 0.01);
}

// The same on wheels: arcs, forwards and backwards, and turns on the spot.
double worst_approach_m(testing::CommandedDrive drive, int departures) {
  double worst_m = 0;
  while (departures > 0) {
    drive.begin();
    const ArcCommand crept = drive.slow_arc(kDepartureSpeed_m_s);
    drive.drive(crept, drive.uniform(0, 2));
    const bool braked = drive.uniform(0, 1) < 0.7;
    if (braked) drive.drive({}, drive.uniform(0, 1.5));
    const ArcCommand command = drive.slow_arc(kDepartureSpeed_m_s);
    const DriveMotion now = drive.motion();
    std::vector<Vec2> track;
    drive.response().predict_stop(now, braked ? ArcCommand{} : crept, command, kHold_s, 0.05,
                                  track);
    const double bearing_rad = drive.uniform(-3.2, 3.2);
    const Vec2 place = now.p_m + 0.3 * Vec2(std::cos(bearing_rad), std::sin(bearing_rad));
    if (!leads_away(command.v_m_s * now.heading, track, std::vector<Vec2>{place})) continue;
    const Vec2 towards = (place - now.p_m).normalized();
    for (int i = 0; i < 300; ++i) {
      drive.step(i * testing::kPeriod_s < kHold_s - 1e-9 ? command : ArcCommand{});
      worst_m = std::max(worst_m, (drive.motion().p_m - now.p_m).dot(towards));
    }
    --departures;
  }
  return worst_m;
}

TEST(Departure, BringsNothingOnWheelsCloserThanACentimetreToWhatItLeaves) {
  unsigned seed = 0;
  for (const VehicleSpec& spec : testing::wheeled()) {
    const double worst_m = worst_approach_m({spec, ++seed}, 3000);
    RecordProperty(spec.name + "_m", std::to_string(worst_m));
    EXPECT_LE(worst_m, 0.01) << spec.name;
  }
}

// A share of three tenths is what the flights above were tried with.
TEST(Departure, LeadsAwayOnlyWithThreeTenthsOfEveryStep) {
  EXPECT_FALSE(leads_away_at(0.29));
  EXPECT_TRUE(leads_away_at(0.31));
  // Each corner of the track counts: here the last one has come back too far.
  const std::vector<Vec2> place{Vec2(-0.3, 0)};
  const auto turning_at = [&](double away_m) {
    const std::vector<Vec2> track{Vec2(0, 0), Vec2(0.1, 0), Vec2(away_m, 0.2)};
    return leads_away(Vec2(0.3, 0), track, place);
  };
  EXPECT_TRUE(turning_at(0.07));
  EXPECT_FALSE(turning_at(0.05));
}

TEST(Departure, LeadsAwayOnlyFromWhatLiesBehind) {
  const std::vector<Vec2> track{Vec2(0, 0), Vec2(0.2, 0)};
  const auto away_from = [&](const Vec2& place) {
    return leads_away(Vec2(0.2, 0), track, std::vector<Vec2>{place});
  };
  EXPECT_TRUE(away_from(Vec2(-0.3, 0)));
  EXPECT_TRUE(away_from(Vec2(-0.2, 0.2)));
  EXPECT_FALSE(away_from(Vec2(0, 0.3)));
  EXPECT_FALSE(away_from(Vec2(0.5, 0)));
  EXPECT_FALSE(away_from(Vec2(0, 0)));
  EXPECT_TRUE(leads_away(Vec2(0.2, 0), track, {}));
  // However short a step towards it would be.
  EXPECT_FALSE(leads_away(Vec2(0.001, 0), std::vector<Vec2>{Vec2(0, 0), Vec2(0.0001, 0)},
                          std::vector<Vec2>{Vec2(0.3, 0)}));
}

TEST(Departure, TurnsNoFartherFromTheWayThanItMust) {
  const std::vector<Vec2> wall{Vec2(-0.1, -0.3), Vec2(0, -0.3), Vec2(0.1, -0.3)};
  const Vec2 along(1, 0);
  const auto left = departing_direction(along, Vec2(0, 0), wall);
  ASSERT_TRUE(left);
  EXPECT_TRUE(leads_away(0.3 * *left, std::vector<Vec2>{Vec2(0, 0), 0.2 * *left}, wall));
  EXPECT_GT(left->x(), 0.5) << "goes on all the same";
  EXPECT_GT(left->y(), 0);
  EXPECT_EQ(departing_direction(Vec2(0, 1), Vec2(0, 0), wall), Vec2(0, 1)) << "leads away already";
  const auto from_above = departing_direction(along, Vec2(0, 0), std::vector<Vec2>{Vec2(0, 0.3)});
  ASSERT_TRUE(from_above);
  EXPECT_LT(from_above->y(), 0);
}

TEST(Departure, HasNoDirectionBetweenPlacesOnBothSides) {
  const std::vector<Vec2> both{Vec2(0, 0.3), Vec2(0, -0.3)};
  EXPECT_FALSE(departing_direction(Vec2(1, 0), Vec2(0, 0), both));
}

}  // namespace
}  // namespace voronaut
