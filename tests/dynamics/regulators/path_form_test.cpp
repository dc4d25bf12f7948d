#include "voronaut/dynamics/regulators/path_form.h"

#include <cmath>
#include <random>

#include <Eigen/Geometry>
#include <gmock/gmock.h>

namespace voronaut::testing {
namespace {

using Eigen::Vector2d;

PathSegment line(const Vector2d& from, const Vector2d& to) { return {.start = from, .end = to}; }

PathSegment arc(const Vector2d& center, const Vector2d& from, const Vector2d& to, bool left) {
  return {.kind = PathSegment::Kind::arc,
          .start = from,
          .end = to,
          .center = center,
          .counter_clockwise = left};
}

TEST(PathForm, OfALineIsTheDistanceToItsLeft) {
  const PathForm form = PathForm::of(line({1, 1}, {4, 5}));
  EXPECT_EQ(form.N, Eigen::Matrix2d::Zero());
  EXPECT_LT((form.L - Vector2d(-0.8, 0.6)).norm(), 1e-15);
  EXPECT_NEAR(form.c, 0.2, 1e-15);
  EXPECT_NEAR(form.psi_m({1 - 0.8 * 3, 1 + 0.6 * 3}), 3, 1e-14);
  EXPECT_NEAR(form.psi_m({4, 5}), 0, 1e-14);
}

TEST(PathForm, OfACircleHasTheCoefficientsOfItsEquation) {
  const PathForm form = PathForm::of(arc({3, 4}, {5, 4}, {3, 6}, true));  // R = 2
  EXPECT_EQ(form.N, Eigen::Matrix2d::Identity() * 0.25);
  EXPECT_EQ(form.L, Vector2d(-1.5, -2));
  EXPECT_EQ(form.c, (25.0 - 4) / 4);
  EXPECT_NEAR(form.psi_m({3, 7}), (9.0 - 4) / 4, 1e-14);
  EXPECT_EQ(form.gradient({3, 4}), Vector2d(0, 0));
}

TEST(PathForm, VanishesOnThePathWithAUnitGradientAndPointsAlongIt) {
  std::mt19937 engine(7);
  std::uniform_real_distribution<double> any(-20, 20), turn(0.3, 5);
  for (int i = 0; i < 200; ++i) {
    const Vector2d start(any(engine), any(engine));
    const Vector2d center(any(engine), any(engine));
    const double angle = turn(engine);
    const Vector2d end = center + Eigen::Rotation2Dd(angle) * (start - center);
    const PathSegment segment = i % 2 == 0 ? line(start, end) : arc(center, start, end, i % 4 == 1);
    Path path;
    path.append(segment);
    const PathForm form = PathForm::of(segment);
    for (const double share : {0.01, 0.37, 0.9}) {
      const double station_m = share * path.length_m();
      const Vector2d p = path.point_at(station_m);
      const Vector2d gradient = form.gradient(p);
      EXPECT_NEAR(form.psi_m(p), 0, 1e-10);
      EXPECT_NEAR(gradient.norm(), 1, 1e-10);
      EXPECT_LT((form.tangent(gradient) - path.direction_at(station_m)).norm(), 1e-10);
    }
  }
}

}  // namespace
}  // namespace voronaut::testing
