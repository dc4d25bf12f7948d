#include "voronaut/environments/sensing/scan.h"

#include <numbers>

#include <sleef.h>

namespace voronaut {
namespace {

constexpr double kFullCircleRad = 2 * std::numbers::pi;
// Far above the rounding of degrees to radians, far below any beam spacing.
constexpr double kFullCircleToleranceRad = 1e-9;

}  // namespace

BeamFan BeamFan::spread(double field_of_view_rad, std::size_t rays) {
  const bool whole = field_of_view_rad >= kFullCircleRad - kFullCircleToleranceRad;
  BeamFan fan;
  if (rays > 1) {
    const auto gaps = static_cast<double>(whole ? rays : rays - 1);
    fan.first_bearing_rad = -field_of_view_rad / 2;
    fan.bearing_step_rad = field_of_view_rad / gaps;
  }
  fan.direction_sensor.reserve(rays);
  for (std::size_t i = 0; i < rays; ++i) {
    const double bearing_rad =
        fan.first_bearing_rad + static_cast<double>(i) * fan.bearing_step_rad;
    const auto sin_cos = Sleef_cinz_sincosd1_u10purec(bearing_rad);
    fan.direction_sensor.emplace_back(sin_cos.y, sin_cos.x);
  }
  return fan;
}

bool BeamFan::full_circle() const {
  return static_cast<double>(direction_sensor.size()) * bearing_step_rad >=
         kFullCircleRad - kFullCircleToleranceRad;
}

}  // namespace voronaut
