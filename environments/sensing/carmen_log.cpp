#include "voronaut/environments/sensing/carmen_log.h"

#include <algorithm>
#include <array>
#include <memory>
#include <numbers>
#include <sstream>
#include <stdexcept>

#include <sleef.h>
#include <zlib.h>

namespace voronaut {
namespace {

std::string unzipped(const std::string& path) {
  const gzFile file = gzopen(path.c_str(), "rb");
  if (file == nullptr) throw std::runtime_error(path + ": cannot be opened");
  std::string text;
  std::array<char, 1 << 16> part;
  int read = 0;
  while ((read = gzread(file, part.data(), part.size())) > 0) {
    text.append(part.data(), static_cast<std::size_t>(read));
  }
  gzclose(file);
  if (read < 0) throw std::runtime_error(path + ": is no gzip file, or a damaged one");
  return text;
}

std::shared_ptr<const BeamFan> carmen_fan(std::size_t beams) {
  const double step_rad =
      std::numbers::pi / static_cast<double>(beams % 2 == 0 ? beams : beams - 1);
  BeamFan fan;
  fan.first_bearing_rad = -std::numbers::pi / 2;
  fan.bearing_step_rad = step_rad;
  for (std::size_t i = 0; i < beams; ++i) {
    const auto sin_cos =
        Sleef_cinz_sincosd1_u10purec(fan.first_bearing_rad + static_cast<double>(i) * step_rad);
    fan.direction_sensor.emplace_back(sin_cos.y, sin_cos.x);
  }
  return std::make_shared<const BeamFan>(std::move(fan));
}

}  // namespace

std::vector<Scan> read_carmen_log(const std::string& path, double max_range_m) {
  std::istringstream lines(unzipped(path));
  std::vector<Scan> scans;
  std::shared_ptr<const BeamFan> fan;
  std::string line;
  for (std::size_t number = 1; std::getline(lines, line); ++number) {
    std::istringstream words(line);
    std::string kind;
    std::size_t beams = 0;
    if (!(words >> kind) || kind != "FLASER") continue;
    Scan scan;
    scan.max_range_m = max_range_m;
    words >> beams;
    for (std::size_t i = 0; i < beams && words; ++i) {
      double range_m = 0;
      words >> range_m;
      scan.range_m.push_back(std::min(range_m, max_range_m));
    }
    double heading_rad = 0;
    words >> scan.sensor_world.p_world.x() >> scan.sensor_world.p_world.y() >> heading_rad;
    if (!words) throw std::runtime_error(path + ":" + std::to_string(number) + ": broken FLASER");
    const auto sin_cos = Sleef_cinz_sincosd1_u10purec(heading_rad);
    scan.sensor_world.heading = {sin_cos.y, sin_cos.x};
    if (fan == nullptr || fan->direction_sensor.size() != beams) fan = carmen_fan(beams);
    scan.beams = fan;
    scans.push_back(std::move(scan));
  }
  return scans;
}

}  // namespace voronaut
