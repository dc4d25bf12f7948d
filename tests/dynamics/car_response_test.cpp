#include "voronaut/dynamics/car_response.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

#include <gtest/gtest.h>

#include "voronaut/dynamics/catalog.h"
#include "voronaut/tests/dynamics/closed_loop.h"
#include "voronaut/tests/dynamics/track_distance.h"

namespace voronaut::testing {
namespace {

using Eigen::Vector2d;

constexpr double kHold_s = 0.05;
constexpr double kSample_s = 0.05;  // as the governor samples

// A car that drives one commanded arc after the other.
class CommandedCar {
 public:
  explicit CommandedCar(unsigned seed)
      : spec_(find_vehicle("car")),
        model_(make_model(spec_.model)),
        regulator_(make_regulator(find_regulator("car_tracker"), spec_, kPeriod_s)),
        response_(std::get<CarResponse>(regulator_->motion_response())),
        random_(seed) {
    begin();
  }

  void begin() {
    state_ = model_->at_rest({0, 0, 0}, {1, 0});
    pending_ = model_->hold();
  }
  void step(const ArcCommand& arc) {
    Setpoint setpoint;
    setpoint.motion = arc;
    const Command next = regulator_->regulate(setpoint, state_);
    state_ = model_->step(state_, pending_, kPeriod_s);
    pending_ = next;
  }
  void drive(const ArcCommand& arc, double duration_s) {
    for (long i = 0; i < std::lround(duration_s / kPeriod_s); ++i) step(arc);
  }
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  // Any arc that it can be steered to, forwards or backwards.
  ArcCommand any_arc() {
    const double angle = uniform(-3, 3);
    const ArcCommand arc =
        steered_towards({{0, 0}, {1, 0}, motion().v_m_s, 0},
                        uniform(0.1, 2) * Vector2d(std::cos(angle), std::sin(angle)),
                        uniform(0, response_.max_speed_m_s), response_);
    return uniform(0, 1) < 0.7 ? arc : ArcCommand{-arc.v_m_s, -arc.w_rad_s};
  }
  ArcCommand next_command(const ArcCommand& before) {
    const double what = uniform(0, 1);
    if (what < 0.7) return before;
    if (what < 0.8) return {};
    return any_arc();
  }
  const CarResponse& response() const { return response_; }
  CarMotion motion() const { return response_.motion_of(state_); }

 private:
  VehicleSpec spec_;
  std::unique_ptr<Model> model_;
  std::unique_ptr<Regulator> regulator_;
  CarResponse response_;
  std::mt19937 random_;
  VehicleState state_;
  Command pending_;
};

// As a share of what is promised, see drive_response_test.cpp.
double largest_share(CommandedCar car, int stops) {
  double largest = 0;
  while (stops > 0) {
    car.begin();
    ArcCommand before;
    for (int hold = 0; hold < 60; ++hold) {
      const ArcCommand command = car.next_command(before);
      if (hold > 3 && car.uniform(0, 1) < 0.1) {
        const double promised_m = car.response().error_m(car.motion(), command);
        std::vector<Vector2d> track;
        car.response().predict_stop(car.motion(), before, command, kHold_s, kSample_s, track);
        for (int i = 0; i < 300; ++i) {
          largest = std::max(largest, distance_m(car.motion().p_m, track) / promised_m);
          car.step(i * kPeriod_s < kHold_s - 1e-9 ? command : ArcCommand{});
        }
        --stops;
        break;
      }
      car.drive(command, kHold_s);
      before = command;
    }
  }
  return largest;
}

TEST(CarResponse, PredictsStopsWithinItsError) {
  const double share = largest_share(CommandedCar(1), 3000);
  RecordProperty("share", std::to_string(share));
  EXPECT_LE(share, 1);
  EXPECT_GT(share, 0.1) << "promises far less than it keeps";
}

TEST(CarResponse, LeadsThroughThePointUnlessThatIsWithinTheTurningCircle) {
  const CarResponse response = CommandedCar(1).response();
  const CarMotion now;
  const Vector2d point = 0.5 * Vector2d(1, 0.3).normalized();
  const ArcCommand arc = steered_towards(now, point, 0.5, response);
  EXPECT_NEAR((point - Vector2d(0, arc.v_m_s / arc.w_rad_s)).norm(), arc.v_m_s / arc.w_rad_s, 1e-9);
  const ArcCommand tight = steered_towards(now, {0.1, 0.3}, 0.5, response);
  EXPECT_NEAR(tight.v_m_s / tight.w_rad_s, response.turning_radius_m(), 1e-9);
  const ArcCommand behind = steered_towards(now, {-3, -0.5}, 0.5, response);
  EXPECT_NEAR(behind.v_m_s / behind.w_rad_s, -response.turning_radius_m(), 1e-9);
}

TEST(CarTracker, HoldsAnArcOnceItIsSteeredToAndBrakesOnIt) {
  CommandedCar car(1);
  car.drive({-0.8, 0.5}, 3);
  const double steering_rad = car.motion().steering_rad;
  EXPECT_NEAR(car.motion().v_m_s, -0.8, 1e-6);
  EXPECT_NEAR(std::tan(car.motion().steering_rad) / 0.3302, 0.5 / -0.8, 1e-6);
  car.drive({}, 3);
  EXPECT_EQ(car.motion().steering_rad, steering_rad);
  EXPECT_NEAR(car.motion().v_m_s, 0, 1e-6);
}

}  // namespace
}  // namespace voronaut::testing
