#include "voronaut/planners/navigation/departure.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

#include <gtest/gtest.h>

#include "voronaut/dynamics/catalog.h"
#include "voronaut/dynamics/velocity_response.h"

namespace voronaut {
namespace {

constexpr double kPeriod_s = 0.01;
constexpr double kHold_s = 0.1;

// A vehicle that creeps about; at random moments a course that leads away from some place, as
// predicted, is flown and braked.
class Departures {
 public:
  Departures(VehicleSpec spec, const RegulatorConfig& config, unsigned seed)
      : spec_(std::move(spec)),
        config_(config),
        model_(make_model(spec_.model)),
        response_(velocity_response(config, spec_)),
        random_(seed) {}

  // How much closer to the place than at the start the flight came, at worst [m].
  double worst_approach_m(int flights) {
    double worst_m = 0;
    while (flights > 0) {
      regulator_ = make_regulator(config_, spec_);
      state_ = model_->at_rest({0, 0, 1}, {1, 0});
      regulator_->reset(state_);
      pending_ = model_->hold();
      const Vec2 crept = random_course();
      fly(crept, uniform(0, 2));
      const bool braked = uniform(0, 1) < 0.7;
      if (braked) fly(Vec2(0, 0), uniform(0, 1.5));
      const Vec2 course = random_course();
      const PlanarMotion now = response_.motion_of(state_);
      if (std::max(course.norm(), now.v_m_s.norm()) > kDepartureSpeed_m_s) continue;
      std::vector<Vec2> track;
      response_.predict_stop(now, braked ? Vec2(0, 0) : crept, course, kHold_s, 0.05, track);
      const Vec2 place = now.p_m + 0.3 * direction();
      if (!leads_away(course, track, std::vector<Vec2>{place})) continue;
      worst_m = std::max(worst_m, approach_m(course, place));
      --flights;
    }
    return worst_m;
  }

 private:
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  Vec2 direction() {
    const double angle = uniform(-3.2, 3.2);
    return {std::cos(angle), std::sin(angle)};
  }
  Vec2 random_course() { return uniform(0, kDepartureSpeed_m_s) * direction(); }
  void step(const Setpoint& setpoint) {
    const Command next = regulator_->regulate(setpoint, state_);
    state_ = model_->step(state_, pending_, kPeriod_s);
    pending_ = next;
  }
  Setpoint hold(const Vec2& course, double yaw_rate_rad_s) {
    Setpoint setpoint;
    setpoint.p_target_world = {0, 0, 1};
    setpoint.course_m_s = course;
    setpoint.yaw_rate_rad_s = yaw_rate_rad_s;
    return setpoint;
  }
  void fly(const Vec2& course, double duration_s) {
    const Setpoint setpoint = hold(course, uniform(-2, 2));
    for (int i = 0; i < static_cast<int>(duration_s / kPeriod_s); ++i) step(setpoint);
  }
  double approach_m(const Vec2& course, const Vec2& place) {
    const Vec2 start = state_.p_world.head<2>();
    const Vec2 towards = (place - start).normalized();
    const double yaw_rate_rad_s = uniform(-2, 2);
    double worst_m = 0;
    for (int i = 0; i < 400; ++i) {
      step(hold(i * kPeriod_s < kHold_s - 1e-9 ? course : Vec2(0, 0), yaw_rate_rad_s));
      worst_m = std::max(worst_m, (state_.p_world.head<2>() - start).dot(towards));
    }
    return worst_m;
  }

  VehicleSpec spec_;
  RegulatorConfig config_;
  std::unique_ptr<Model> model_;
  VelocityResponse response_;
  std::mt19937 random_;
  std::unique_ptr<Regulator> regulator_;
  VehicleState state_;
  Command pending_;
};

TEST(Departure, BringsNoVehicleFifteenMillimetresCloserToWhatItLeaves) {
  VehicleSpec printed = vehicle("quadrotor");
  std::get<QuadrotorConfig>(printed.model).inertia = QuadrotorConfig::InertiaSet::printed;
  const double ideal_m = Departures(vehicle("ideal"), regulator("ideal"), 1).worst_approach_m(3000);
  const double quadrotor_m =
      Departures(vehicle("quadrotor"), regulator("pd_rate"), 2).worst_approach_m(3000);
  const double printed_m = Departures(printed, regulator("pd_rate"), 3).worst_approach_m(3000);
  RecordProperty("ideal_m", std::to_string(ideal_m));
  RecordProperty("quadrotor_m", std::to_string(quadrotor_m));
  RecordProperty("printed_m", std::to_string(printed_m));
  EXPECT_LE(std::max({ideal_m, quadrotor_m, printed_m}), 0.015);
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
