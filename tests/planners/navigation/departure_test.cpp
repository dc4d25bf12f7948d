#include "voronaut/planners/navigation/departure.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "voronaut/tests/dynamics/commanded_flight.h"

namespace voronaut {
namespace {

using testing::CommandedFlight;

constexpr double kHold_s = 0.1;

Vec2 random_command(CommandedFlight& flight) {
  return flight.uniform(0, kDepartureSpeed_m_s) * flight.direction();
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
  const double ideal_m = worst_approach_m({vehicle("ideal"), regulator("ideal"), 1}, 3000);
  const double quadrotor_m =
      worst_approach_m({vehicle("quadrotor"), regulator("pd_rate"), 2}, 3000);
  const double printed_m =
      worst_approach_m({testing::quadrotor_with_printed_inertia(), regulator("pd_rate"), 3}, 3000);
  RecordProperty("ideal_m", std::to_string(ideal_m));
  RecordProperty("quadrotor_m", std::to_string(quadrotor_m));
  RecordProperty("printed_m", std::to_string(printed_m));
  EXPECT_LE(std::max({ideal_m, quadrotor_m, printed_m}), 0.01);
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

}  // namespace
}  // namespace voronaut
