#include "voronaut/planners/mapping/free_space/scan_star.h"

#include <algorithm>

namespace voronaut {
namespace {

// Where nothing is in range, one chord spans several beams, a millimetre inside their arc.
constexpr double kChord_rad = 0.07;

std::size_t beams_per_chord(double spacing_rad, std::size_t beams) {
  const double most = static_cast<double>(beams);
  return static_cast<std::size_t>(std::clamp(kChord_rad / spacing_rad, 1.0, most));
}

}  // namespace

void ScanStar::trace(const Scan& scan, const Vec2& sensor, double cell_m) {
  const double* const range_m = scan.range_m.data();
  const double max_range_m = scan.max_range_m;
  // The surface between two beams may stand out towards the sensor: a right-angled corner by half
  // their spacing.
  const double shortened = 1 - 0.5 * scan.beams->bearing_step_rad;
  const auto free_length_m = [=](double range) {
    if (range == max_range_m) return range;
    return range > 0 && range < max_range_m ? range * shortened : 0;
  };

  const bool full = scan.beams->full_circle();
  const std::size_t n = scan.size();
  const std::size_t triangles = full ? n : n - 1;
  const std::size_t chord = beams_per_chord(scan.beams->bearing_step_rad, n);
  const auto beam = [n](std::size_t i) { return i < n ? i : 0; };

  if (corners_.size() < 2 * n + 1) corners_.resize(2 * n + 1);
  Vec2* corner = corners_.data();
  if (!full) *corner++ = sensor;
  double before_m = full ? -1 : 0;  // how far from the sensor the outline has come to the next beam
  double length_m = free_length_m(range_m[0]);
  Vec2 direction = scan.direction_world(0) / cell_m;
  for (std::size_t i = 0; i < triangles;) {
    std::size_t last = i + 1;
    const double last_m = free_length_m(range_m[beam(last)]);
    const double both_m = length_m < last_m ? length_m : last_m;
    if (both_m == max_range_m) {
      const std::size_t farthest = std::min(triangles, i + chord);
      while (last < farthest && range_m[beam(last + 1)] == max_range_m) ++last;
    }
    if (both_m != before_m) *corner++ = sensor + both_m * direction;
    direction = scan.direction_world(beam(last)) / cell_m;
    *corner++ = sensor + both_m * direction;
    before_m = both_m;
    length_m = last_m;
    i = last;
  }
  count_ = static_cast<std::size_t>(corner - corners_.data());
  measure(sensor);
}

void ScanStar::measure(const Vec2& sensor) {
  double low_x = sensor.x(), low_y = sensor.y(), high_x = low_x, high_y = low_y;
  for (const Vec2& corner : corners()) {
    low_x = low_x < corner.x() ? low_x : corner.x();
    high_x = high_x > corner.x() ? high_x : corner.x();
  }
  for (const Vec2& corner : corners()) {
    low_y = low_y < corner.y() ? low_y : corner.y();
    high_y = high_y > corner.y() ? high_y : corner.y();
  }
  low_ = {low_x, low_y};
  high_ = {high_x, high_y};
}

}  // namespace voronaut
