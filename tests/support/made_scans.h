#pragma once

#include <vector>

#include "voronaut/environments/sensing/scan.h"

namespace voronaut {

// A scan from `origin` whose returns lie at the given places, right to left, each on a beam of its
// own, with a miss at both ends. The fan covers a quarter turn on paper only.
inline Scan scan_of(const std::vector<Vec2>& returns_world, const Vec2& origin = Vec2::Zero()) {
  constexpr double kRangeM = 100;
  BeamFan fan;
  fan.bearing_step_rad = 1e-3;
  fan.direction_sensor.push_back(Vec2::UnitX());
  Scan scan{0, {origin, Vec2::UnitX()}, nullptr, kRangeM, {kRangeM}};
  for (const Vec2& p : returns_world) {
    // Ranges are 1, so that the return lies exactly there.
    fan.direction_sensor.push_back(p - origin);
    scan.range_m.push_back(1);
  }
  fan.direction_sensor.push_back(Vec2::UnitX());
  scan.range_m.push_back(kRangeM);
  scan.beams = std::make_shared<const BeamFan>(fan);
  return scan;
}

// Places from a to b, both included, not farther apart than spacing_m.
inline std::vector<Vec2> along(const Vec2& a, const Vec2& b, double spacing_m) {
  const auto steps = static_cast<int>((b - a).norm() / spacing_m) + 1;
  std::vector<Vec2> places;
  for (int i = 0; i <= steps; ++i) places.push_back(a + (b - a) * i / steps);
  return places;
}

}  // namespace voronaut
