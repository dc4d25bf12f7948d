#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "voronaut/environments/shapes/geometry.h"

// What a planar range finder reports: the only thing planners may know of the world.
namespace voronaut {

// The beams of a range finder in its own frame (x ahead, y left): unit directions,
// counter-clockwise, first beam rightmost, equally spaced. The spacing is the same for every scan
// of a sensor, so the directions are computed once and shared.
struct BeamFan {
  double first_bearing_rad = 0;
  double bearing_step_rad = 0;
  std::vector<Vec2> direction_sensor;

  // `rays` beams from -field_of_view_rad/2 to +field_of_view_rad/2, both included; a full circle
  // (2 pi) leaves out the last one, which would repeat the first. A single beam looks straight
  // ahead. rays >= 1, 0 <= field <= 2 pi. O(rays).
  static BeamFan spread(double field_of_view_rad, std::size_t rays);
  // No gap is wider than the spacing: the last beam is the right-hand neighbour of the first.
  bool full_circle() const;
};

struct Scan {
  double stamp_s = 0;
  Pose2 sensor_world;                    // pose of the range finder when it measured
  std::shared_ptr<const BeamFan> beams;  // never null
  double max_range_m = 0;
  // One range per beam, in the order of the beams. 0 < range < max_range_m: a return, its point
  // lies at p_world + range * direction. range == max_range_m: nothing within reach. Anything else
  // (NaN, infinite, zero, negative, beyond max_range_m) is no measurement: it is dropped and
  // counted.
  std::vector<double> range_m;

  std::size_t size() const { return range_m.size(); }

  bool is_return(std::size_t i) const { return range_m[i] > 0 && range_m[i] < max_range_m; }

  Vec2 direction_world(std::size_t i) const {
    const Vec2& d = beams->direction_sensor[i];
    const Vec2& h = sensor_world.heading;
    return {h.x() * d.x() - h.y() * d.y(), h.y() * d.x() + h.x() * d.y()};
  }

  Vec2 point_world(std::size_t i) const {
    return sensor_world.p_world + range_m[i] * direction_world(i);
  }
};

}  // namespace voronaut
