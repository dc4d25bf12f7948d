// The quadrotor against reference flights, and how its error falls with the step.
#include <cmath>

#include <gmock/gmock.h>

#include "voronaut/tests/dynamics/closed_loop.h"
#include "voronaut/tests/dynamics/models/rigid_body.h"

namespace voronaut::testing {
namespace {

using InertiaSet = QuadrotorConfig::InertiaSet;

struct Reference {
  Vec3 p, v;
  Eigen::Quaterniond q;
  Vec3 w;
};

void expect_reached(const VehicleState& s, const Reference& r, double tolerance) {
  EXPECT_LT(worst(s.p_world, r.p), tolerance);
  EXPECT_LT(worst(s.v_world, r.v), tolerance);
  EXPECT_LT(attitude_difference(s.q_world_body, r.q), tolerance);
  EXPECT_LT(worst(s.w_body, r.w), tolerance);
}

VehicleState fly_r1(const Quadrotor& model, double duration_s, double period_s = kPeriod_s) {
  return coast(model, level({0, 0, 1}), kR1, duration_s, period_s);
}

VehicleState fly_r2(const Quadrotor& model, double period_s = kPeriod_s) {
  VehicleState state = level({0, 0, 1});
  state = coast(model, state, {{205, 213, 222, 213}}, 0.5, period_s);
  state = coast(model, state, {{222, 207, 205, 220}}, 0.5, period_s);
  return coast(model, state, {{210, 216, 214, 216}}, 1, period_s);
}

// R1, R2: an 8th-order integration with relative tolerance 1e-12, by an independent program.
TEST(Quadrotor, FollowsR1WithThePrintedInertia) {
  const Quadrotor model(free_rotors(InertiaSet::printed));
  expect_reached(fly_r1(model, 1),
                 {{0.0277520301348, -0.0139736574305, 1.00622476921},
                  {0.111053286451, -0.0557903138527, 0.0115059904814},
                  {0.999812956972, 0.0085507504944, 0.016943384459, 0.00372256097579},
                  {0.0341248579347, 0.0678183322535, 0.0148906690141}},
                 1e-10);
  expect_reached(fly_r1(model, 2),
                 {{0.444987152473, -0.220783270153, 1.0107549925},
                  {0.891012149269, -0.437573241172, -0.0193995194502},
                  {0.99700875781, 0.0338825273133, 0.06785195522, 0.0148870200587},
                  {0.0670036294479, 0.13625489982, 0.0297813380282}},
                 1e-10);
}

const Reference kR1Corrected2s{{4.22178055378, -1.7523983946, -0.384296505219},
                               {7.89052497364, -2.85241498923, -4.01256806516},
                               {0.715804818507, 0.278958563252, 0.62351524852, 0.145032122834},
                               {0.533511363222, 1.41999150312, 0.297813380282}};

const Reference kR2Corrected2s{{5.33317945859, -3.46123260796, -13.5131666454},
                               {2.39881512031, -0.90590685597, -16.3101550673},
                               {-0.161502256824, 0.266468336957, -0.927480040429, -0.20662144382},
                               {4.39688172004, 2.72022603368, 0.240179577465}};

TEST(Quadrotor, FollowsR1WithTheCorrectedInertia) {
  const Quadrotor model(free_rotors());
  expect_reached(fly_r1(model, 1),
                 {{0.277827018771, -0.135475317898, 0.982969729592},
                  {1.11040278119, -0.528857721708, -0.127624085385},
                  {0.981354196236, 0.0842093417938, 0.168744798138, 0.0371203634974},
                  {0.330917831242, 0.683268553004, 0.148906690141}},
                 1e-9);
  expect_reached(fly_r1(model, 2), kR1Corrected2s, 2e-9);
}

TEST(Quadrotor, FollowsR2WithBothInertias) {
  expect_reached(fly_r2(Quadrotor(free_rotors(InertiaSet::printed))),
                 {{3.27489567309, -1.45566827287, 0.400782899949},
                  {4.46136962172, -3.3638351214, -1.25531579524},
                  {0.940216065941, 0.272133627384, 0.203246132371, -0.0250608832445},
                  {0.442234924003, 0.270572412129, 0.0240179577465}},
                 2e-9);
  expect_reached(fly_r2(Quadrotor(free_rotors())), kR2Corrected2s, 1e-7);
}

TEST(Quadrotor, IntegratesToOrderFour) {
  const Quadrotor model(free_rotors());
  const VehicleState exact = fly_r2(model, 0.000625);
  const double coarse = worst(fly_r2(model, 0.01).p_world, exact.p_world);
  const double fine = worst(fly_r2(model, 0.005).p_world, exact.p_world);
  EXPECT_NEAR(std::log2(coarse / fine), 4, 0.3);
}

TEST(Quadrotor, KeepsItsQuaternionOnTheSphere) {
  const VehicleState end = fly_r2(Quadrotor(free_rotors()));
  EXPECT_NEAR(end.q_world_body.norm(), 1, 1e-15);
}

}  // namespace
}  // namespace voronaut::testing
