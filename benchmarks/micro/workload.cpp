#include "voronaut/benchmarks/micro/workload.h"

#include <cmath>
#include <memory>
#include <numbers>

#include <sleef.h>

#include "voronaut/environments/random.h"

namespace voronaut::micro {
namespace {

constexpr double kAmplitudeM = 3;
constexpr double kWavelengthPerRadM = 8;
constexpr double kHalfCorridorM = 12;
constexpr double kFreeBesideCurveM = 0.6;
constexpr double kCurveSampleM = 0.05;

struct CurvePoint {
  Vec2 p;
  double slope;
};

CurvePoint curve_at(double x_m) {
  const auto sin_cos = Sleef_cinz_sincosd1_u10purec(x_m / kWavelengthPerRadM);
  return {{x_m, kAmplitudeM * sin_cos.x}, kAmplitudeM / kWavelengthPerRadM * sin_cos.y};
}

bool leaves_curve_free(const Circle& circle) {
  const double reach_m = circle.radius_m + kFreeBesideCurveM;
  for (double x_m = circle.center.x() - reach_m; x_m <= circle.center.x() + reach_m;
       x_m += kCurveSampleM) {
    if ((curve_at(x_m).p - circle.center).norm() < reach_m) return false;
  }
  return true;
}

Shapes plant(const ForestWalkConfig& config) {
  Random random(config.seed);
  const double before_m = config.max_range_m;
  const double length_m =
      config.step_m * static_cast<double>(config.scans) + 2 * config.max_range_m;
  const double area_m2 = length_m * 2 * kHalfCorridorM;
  const auto planted = static_cast<std::size_t>(std::round(area_m2 * config.density_per_m2));
  Shapes shapes;
  for (std::size_t i = 0; i < planted; ++i) {
    const double x_m = random.uniform(-before_m, length_m - before_m);
    const double y_m = random.uniform(-kHalfCorridorM, kHalfCorridorM);
    const Circle circle{{x_m, y_m}, random.uniform(0.3, 1.0)};
    if (!leaves_curve_free(circle)) continue;
    if (config.walls) {
      const Vec2 half{0, circle.radius_m};
      shapes.segments.push_back({circle.center - half, circle.center + half});
    } else {
      shapes.circles.push_back(circle);
    }
  }
  return shapes;
}

}  // namespace

ForestWalk::ForestWalk(const ForestWalkConfig& config) : config_(config), forest_(plant(config)) {
  const double field_rad = config.field_of_view_deg * std::numbers::pi / 180;
  scan_.beams = std::make_shared<BeamFan>(BeamFan::spread(field_rad, config.rays));
  scan_.max_range_m = config.max_range_m;
  scan_.range_m.resize(config.rays);
}

const Scan& ForestWalk::next() {
  const CurvePoint at = curve_at(x_m_);
  const Vec2 along = Vec2{1, at.slope} / std::sqrt(1 + at.slope * at.slope);
  scan_.sensor_world = {at.p, along};
  cast_fan(forest_, scan_.sensor_world, *scan_.beams, scan_.max_range_m, scan_.range_m);
  scan_.sensor_world.p_world.y() += config_.aside_m;
  x_m_ += config_.step_m * along.x();
  return scan_;
}

}  // namespace voronaut::micro
