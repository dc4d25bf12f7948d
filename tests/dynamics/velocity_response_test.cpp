#include "voronaut/dynamics/velocity_response.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "voronaut/dynamics/catalog.h"
#include "voronaut/tests/dynamics/closed_loop.h"

namespace voronaut {
namespace {

using Eigen::Vector2d;
using testing::kPeriod_s;

constexpr double kHold_s = 0.05;

// A flight under random courses, held as navigation holds them; at random moments the stop from
// there is both predicted and flown.
class StopErrors {
 public:
  StopErrors(VehicleSpec spec, const RegulatorConfig& config, unsigned seed)
      : spec_(std::move(spec)),
        config_(config),
        model_(make_model(spec_.model)),
        response_(velocity_response(config, spec_)),
        random_(seed) {}

  // Largest distance between prediction and flight over `stops` of them, as a share of what is
  // promised.
  double largest_share(int stops) {
    double largest = 0;
    while (stops > 0) {
      auto regulator = make_regulator(config_, spec_);
      VehicleState state = model_->at_rest({0, 0, 1}, {1, 0});
      regulator->reset(state);
      Command pending = model_->hold();
      Vector2d before(0, 0);
      for (int hold = 0; hold < 60 && stops > 0; ++hold) {
        const Vector2d course = random_course(before);
        if (hold > 3 && uniform(0, 1) < 0.1) {
          const double promised = response_.error_m(response_.motion_of(state), course);
          const double error = error_m(*regulator, state, pending, before, course);
          largest = std::max(largest, error / promised);
          --stops;
          break;
        }
        fly_on(*regulator, state, pending, course, kHold_s);
        before = course;
      }
    }
    return largest;
  }

 private:
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  Vector2d random_course(const Vector2d& before) {
    const double what = uniform(0, 1);
    if (what < 0.7) return before;
    if (what < 0.8) return {0, 0};
    if (what < 0.9) return -before;
    const double angle = uniform(-3.2, 3.2);
    return uniform(0, spec_.limits.max_speed_m_s) * Vector2d(std::cos(angle), std::sin(angle));
  }
  Setpoint hold(const Vector2d& course) {
    Setpoint setpoint;
    setpoint.p_target_world = {0, 0, 1};
    setpoint.course_m_s = course;
    setpoint.yaw_rate_rad_s = uniform(-2, 2);
    return setpoint;
  }
  void fly_on(Regulator& regulator, VehicleState& state, Command& pending, const Vector2d& course,
              double duration_s) {
    const Setpoint setpoint = hold(course);
    for (int i = 0; i < static_cast<int>(duration_s / kPeriod_s + 0.5); ++i) {
      const Command next = regulator.regulate(setpoint, state);
      state = model_->step(state, pending, kPeriod_s);
      pending = next;
    }
  }
  double error_m(Regulator& regulator, VehicleState state, Command pending, const Vector2d& before,
                 const Vector2d& course) {
    std::vector<Vector2d> track;
    response_.predict_stop(response_.motion_of(state), before, course, kHold_s, kPeriod_s, track);
    // The governor sweeps the whole track: what counts is how far the flight strays from it.
    double largest = 0;
    for (int i = 0; i < 400; ++i) {
      largest = std::max(largest, distance_m(state.p_world.head<2>(), track));
      const double t_s = static_cast<double>(i) * kPeriod_s;
      const Command next =
          regulator.regulate(hold(t_s < kHold_s - 1e-9 ? course : Vector2d(0, 0)), state);
      state = model_->step(state, pending, kPeriod_s);
      pending = next;
    }
    return largest;
  }
  static double distance_m(const Vector2d& p, const std::vector<Vector2d>& track) {
    double closest = (p - track.front()).norm();
    for (std::size_t i = 0; i + 1 < track.size(); ++i) {
      const Vector2d along = track[i + 1] - track[i];
      const double length_sq = along.squaredNorm();
      const double t =
          length_sq > 0 ? std::clamp((p - track[i]).dot(along) / length_sq, 0.0, 1.0) : 0;
      closest = std::min(closest, (p - track[i] - t * along).norm());
    }
    return closest;
  }

  VehicleSpec spec_;
  RegulatorConfig config_;
  std::unique_ptr<Model> model_;
  VelocityResponse response_;
  std::mt19937 random_;
};

TEST(VelocityResponse, PredictsTheStopsOfTheIdealVehicleWithinItsError) {
  const double share = StopErrors(vehicle("ideal"), regulator("ideal"), 1).largest_share(3000);
  RecordProperty("share", std::to_string(share));
  EXPECT_LE(share, 1);
}

TEST(VelocityResponse, PredictsTheStopsOfTheQuadrotorWithinItsError) {
  const double share =
      StopErrors(vehicle("quadrotor"), regulator("pd_rate"), 2).largest_share(3000);
  RecordProperty("share", std::to_string(share));
  EXPECT_LE(share, 1);
}

TEST(VelocityResponse, PredictsTheStopsOfThePrintedInertiaWithinItsError) {
  VehicleSpec spec = vehicle("quadrotor");
  std::get<QuadrotorConfig>(spec.model).inertia = QuadrotorConfig::InertiaSet::printed;
  const double share = StopErrors(spec, regulator("pd_rate"), 3).largest_share(3000);
  RecordProperty("share", std::to_string(share));
  EXPECT_LE(share, 1);
}

TEST(VelocityResponse, PromisesNoStopForTheUnstableLiteralLaw) {
  EXPECT_THROW(velocity_response(regulator("paper_literal"), vehicle("quadrotor")),
               std::invalid_argument);
}

}  // namespace
}  // namespace voronaut
