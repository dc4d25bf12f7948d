#pragma once

#include <memory>
#include <numbers>

#include "voronaut/environments/random.h"
#include "voronaut/environments/sensing/scan.h"
#include "voronaut/environments/world.h"

namespace voronaut {

struct RangeFinderConfig {
  double field_of_view_rad = std::numbers::pi / 2;
  double max_range_m = 2.5;
  int rays = 91;
  double rate_hz = 20;
  double noise_sigma_m = 0;
  double dropout_probability = 0;

  template <class Visitor>
  void visit(Visitor& v) {
    v.number("field_of_view_rad", field_of_view_rad, 0, 2 * std::numbers::pi,
             "Centred on the heading");
    v.number("max_range_m", max_range_m, 0.01, 10'000, "How far a beam sees");
    v.count("rays", rays, 1, 100'000, "Beams of a scan");
    v.number("rate_hz", rate_hz, 0.01, 10'000, "Scans per time");
    v.number("noise_sigma_m", noise_sigma_m, 0, 100,
             "Standard deviation of Gaussian noise on returns");
    v.number("dropout_probability", dropout_probability, 0, 1,
             "Of each beam in each scan to measure nothing");
  }
};

// A planar range finder in a true world.
class RangeFinder {
 public:
  // Throws std::invalid_argument on values out of the bounds above.
  explicit RangeFinder(const RangeFinderConfig& config);

  const RangeFinderConfig& config() const { return config_; }
  const std::shared_ptr<const BeamFan>& beams() const { return beams_; }

  // Fills `out`, reusing its memory: allocates only when `out` had fewer beams. Ranges as Scan
  // defines them: exactly max_range_m where nothing is within reach, NaN for a dropped beam; every
  // beam is 0, no measurement, when the sensor is in or on a shape. Noise may make a return
  // max_range_m (out of reach) or 0. Draws in the order of the beams: one uniform per beam if
  // dropouts are on, then one normal if noise is on and the beam is a return. O(beams).
  void sense(const World& world, const Pose2& sensor, double stamp_s, Random& rng, Scan& out) const;

 private:
  void disturb(Random& rng, Scan& scan) const;

  RangeFinderConfig config_;
  std::shared_ptr<const BeamFan> beams_;
};

}  // namespace voronaut
