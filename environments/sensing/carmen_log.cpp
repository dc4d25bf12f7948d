#include "voronaut/environments/sensing/carmen_log.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <memory>
#include <numbers>
#include <optional>
#include <sstream>
#include <stdexcept>

#include <sleef.h>
#include <zlib.h>

namespace voronaut {
namespace {

constexpr double kDegree_rad = std::numbers::pi / 180;
constexpr std::size_t kLargestText = std::size_t{1} << 30;
constexpr std::size_t kMostBeams = 100'000;

// A plain file is read as it is.
std::string unzipped(const std::string& path) {
  if (!std::filesystem::is_regular_file(path))
    throw std::runtime_error(path + ": is no file that can be read");
  const gzFile file = gzopen(path.c_str(), "rb");
  if (file == nullptr) throw std::runtime_error(path + ": cannot be opened");
  std::string text;
  std::array<char, 1 << 16> part;
  int read = 0;
  while ((read = gzread(file, part.data(), part.size())) > 0 && text.size() <= kLargestText)
    text.append(part.data(), static_cast<std::size_t>(read));
  // A file that ends too early is told by closing alone.
  const bool whole = gzclose(file) == Z_OK && read >= 0;
  if (!whole) throw std::runtime_error(path + ": the gzip file is cut or damaged");
  if (text.size() > kLargestText)
    throw std::runtime_error(path + ": more than 1 GiB of text (allowed: up to that)");
  return text;
}

struct Bearings {
  double first_rad = 0;
  double step_rad = 0;
  std::size_t beams = 0;

  bool operator==(const Bearings&) const = default;
};

std::shared_ptr<const BeamFan> fan_of(const Bearings& bearings) {
  BeamFan fan;
  fan.first_bearing_rad = bearings.first_rad;
  fan.bearing_step_rad = bearings.step_rad;
  for (std::size_t i = 0; i < bearings.beams; ++i) {
    const auto sin_cos = Sleef_cinz_sincosd1_u10purec(bearings.first_rad +
                                                      static_cast<double>(i) * bearings.step_rad);
    fan.direction_sensor.emplace_back(sin_cos.y, sin_cos.x);
  }
  return std::make_shared<const BeamFan>(std::move(fan));
}

class CarmenReader {
 public:
  CarmenReader(std::string path, double max_range_m)
      : path_(std::move(path)), max_range_m_(max_range_m) {}

  std::vector<Scan> read() {
    std::istringstream lines(unzipped(path_));
    std::string line;
    for (number_ = 1; std::getline(lines, line); ++number_) {
      std::istringstream words(line);
      std::string kind;
      words >> kind;
      if (kind == "PARAM") note_parameter(words);
      if (kind == "FLASER") add_flaser(words);
      if (kind == "ROBOTLASER1") add_robotlaser(words);
    }
    if (scans_.empty())
      throw std::runtime_error(path_ + ": no scan in it (expected lines FLASER or ROBOTLASER1)");
    return std::move(scans_);
  }

 private:
  std::runtime_error error(const std::string& what) const {
    return std::runtime_error(path_ + ":" + std::to_string(number_) + ": " + what);
  }

  void note_parameter(std::istringstream& words) {
    std::string key;
    double value_deg = 0;
    words >> key;
    const bool is_fov = key == "laser_front_laser_fov";
    if (!is_fov && key != "laser_front_laser_resolution") return;
    if (!(words >> value_deg) || !(value_deg > 0) || value_deg > 360)
      throw error("broken PARAM " + key + " (expected degrees, above 0 and up to 360)");
    (is_fov ? fov_rad_ : resolution_rad_) = value_deg * kDegree_rad;
  }

  double field_of_view_rad(std::size_t beams) const {
    const std::size_t even = beams - beams % 2;
    if (fov_rad_) return *fov_rad_;
    if (resolution_rad_) return *resolution_rad_ * static_cast<double>(even);
    if (even == 180 || even == 360) return std::numbers::pi;
    if (even == 100 || even == 200 || even == 400) return 100 * kDegree_rad;
    throw error("FLASER of " + std::to_string(beams) +
                " beams: nothing tells their field of view (expected PARAM laser_front_laser_fov "
                "before it)");
  }

  void add_flaser(std::istringstream& words) {
    Scan scan;
    read_ranges(words, "FLASER", max_range_m_, scan);
    read_pose(words, "FLASER", scan);
    const std::size_t beams = scan.range_m.size();
    const double fov_rad = field_of_view_rad(beams);
    add(std::move(scan), {-fov_rad / 2, fov_rad / static_cast<double>(beams - beams % 2), beams});
  }

  void add_robotlaser(std::istringstream& words) {
    double type = 0, fov_rad = 0, sensor_max_m = 0, accuracy_m = 0, remission_mode = 0;
    Bearings bearings;
    words >> type >> bearings.first_rad >> fov_rad >> bearings.step_rad >> sensor_max_m >>
        accuracy_m >> remission_mode;
    if (!words || !(bearings.step_rad > 0))
      throw error("broken ROBOTLASER1: no bearings (expected an angle between beams above 0)");
    Scan scan;
    read_ranges(words, "ROBOTLASER1",
                sensor_max_m > 0 ? std::min(max_range_m_, sensor_max_m) : max_range_m_, scan);
    bearings.beams = scan.range_m.size();
    const double spread_rad = bearings.step_rad * static_cast<double>(bearings.beams - 1);
    if (spread_rad > 2 * std::numbers::pi + bearings.step_rad)
      throw error("broken ROBOTLASER1: its beams go around more than once");
    std::size_t remissions = 0;
    words >> remissions;
    double unused = 0;
    for (std::size_t i = 0; i < remissions && words; ++i) words >> unused;
    read_pose(words, "ROBOTLASER1", scan);
    add(std::move(scan), bearings);
  }

  void read_ranges(std::istringstream& words, const std::string& kind, double miss_m, Scan& scan) {
    std::size_t beams = 0;
    if (!(words >> beams) || beams < 2 || beams > kMostBeams)
      throw error("broken " + kind + " (expected a number of beams from 2 to 100000)");
    scan.max_range_m = max_range_m_;
    for (std::size_t i = 0; i < beams && words; ++i) {
      double range_m = 0;
      words >> range_m;
      scan.range_m.push_back(range_m >= miss_m ? max_range_m_ : range_m);
    }
    if (!words) throw error("broken " + kind + " (expected " + std::to_string(beams) + " ranges)");
  }

  void read_pose(std::istringstream& words, const std::string& kind, Scan& scan) {
    double heading_rad = 0;
    words >> scan.sensor_world.p_world.x() >> scan.sensor_world.p_world.y() >> heading_rad;
    if (!words) throw error("broken " + kind + " (expected x, y and heading behind the ranges)");
    const auto sin_cos = Sleef_cinz_sincosd1_u10purec(heading_rad);
    scan.sensor_world.heading = {sin_cos.y, sin_cos.x};
  }

  void add(Scan scan, const Bearings& bearings) {
    if (fan_ == nullptr || bearings != fan_bearings_) {
      fan_ = fan_of(bearings);
      fan_bearings_ = bearings;
    }
    scan.beams = fan_;
    scans_.push_back(std::move(scan));
  }

  std::string path_;
  double max_range_m_;
  std::size_t number_ = 0;  // of the line
  std::optional<double> fov_rad_, resolution_rad_;
  std::shared_ptr<const BeamFan> fan_;
  Bearings fan_bearings_;
  std::vector<Scan> scans_;
};

}  // namespace

std::vector<Scan> read_carmen_log(const std::string& path, double max_range_m) {
  return CarmenReader(path, max_range_m).read();
}

}  // namespace voronaut
