#include "voronaut/environments/sensing/range_finder.h"

#include <algorithm>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>

#include "voronaut/environments/sensing/ray_caster.h"

namespace voronaut {
namespace {

// Holds a config against the bounds of its own visit list.
struct BoundsCheck {
  void number(const char* name, double value, double low, double high, const char*) {
    if (value >= low && value <= high) return;
    std::ostringstream text;
    text << name << " = " << value << " is not in [" << low << ", " << high << "]";
    throw std::invalid_argument(text.str());
  }
  void count(const char* name, int value, int low, int high, const char* sentence) {
    number(name, value, low, high, sentence);
  }
};

RangeFinderConfig checked(RangeFinderConfig config) {
  BoundsCheck check;
  config.visit(check);
  return config;
}

}  // namespace

RangeFinder::RangeFinder(const RangeFinderConfig& config)
    : config_(checked(config)),
      beams_(std::make_shared<BeamFan>(
          BeamFan::spread(config.field_of_view_rad, static_cast<std::size_t>(config.rays)))) {}

void RangeFinder::sense(const World& world, const Pose2& sensor, double stamp_s, Random& rng,
                        Scan& out) const {
  out.stamp_s = stamp_s;
  out.sensor_world = sensor;
  out.beams = beams_;
  out.max_range_m = config_.max_range_m;
  out.range_m.resize(beams_->direction_sensor.size());
  cast_fan(world.index(), sensor, *beams_, config_.max_range_m, out.range_m);
  if (config_.noise_sigma_m > 0 || config_.dropout_probability > 0) disturb(rng, out);
}

void RangeFinder::disturb(Random& rng, Scan& scan) const {
  for (std::size_t i = 0; i < scan.size(); ++i) {
    const bool dropped =
        config_.dropout_probability > 0 && rng.uniform() < config_.dropout_probability;
    if (scan.is_return(i) && config_.noise_sigma_m > 0) {
      const double noisy_m = scan.range_m[i] + config_.noise_sigma_m * rng.normal();
      scan.range_m[i] = std::clamp(noisy_m, 0.0, config_.max_range_m);
    }
    if (dropped) scan.range_m[i] = std::numeric_limits<double>::quiet_NaN();
  }
}

}  // namespace voronaut
