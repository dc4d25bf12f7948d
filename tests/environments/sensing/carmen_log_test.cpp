#include "voronaut/environments/sensing/carmen_log.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <stdexcept>

#include <gmock/gmock.h>
#include <zlib.h>

#include "voronaut/tests/support/error_of.h"

namespace voronaut {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

constexpr double kDegree_rad = std::numbers::pi / 180;

class CarmenLog : public ::testing::Test {
 protected:
  CarmenLog() { fs::create_directories(folder_); }
  ~CarmenLog() override { fs::remove_all(folder_); }

  std::string file(const std::string& name) const { return (folder_ / name).string(); }
  std::string plain(const std::string& text) const {
    std::ofstream(file("a.log")) << text;
    return file("a.log");
  }
  std::string zipped(const std::string& text) const {
    const gzFile out = gzopen(file("a.log.gz").c_str(), "wb");
    gzwrite(out, text.data(), static_cast<unsigned>(text.size()));
    gzclose(out);
    return file("a.log.gz");
  }

  fs::path folder_ = fs::temp_directory_path() /
                     ("voronaut-carmen-" +
                      std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
};

std::string ranges(int beams, const std::string& range_m = "2.0") {
  std::string text = std::to_string(beams);
  for (int i = 0; i < beams; ++i) text += " " + range_m;
  return text;
}

std::string flaser(int beams) {
  return "FLASER " + ranges(beams) + " 1 2 0.5 0 0 0 1.5 host 1.5\n";
}

std::string error_in(const std::string& path) {
  return error_of<std::runtime_error>([&] { read_carmen_log(path, 20); });
}

TEST_F(CarmenLog, IsReadZippedAndPlain) {
  const std::string text = "# CARMEN\nODOM 0 0 0\n" + flaser(181) + flaser(181);
  for (const std::string& path : {plain(text), zipped(text)}) {
    const std::vector<Scan> scans = read_carmen_log(path, 20);
    ASSERT_EQ(scans.size(), 2U);
    EXPECT_EQ(scans[0].sensor_world.p_world, Vec2(1, 2));
    EXPECT_NEAR(scans[0].sensor_world.heading.y(), std::sin(0.5), 1e-15);
    EXPECT_NEAR(scans[0].beams->first_bearing_rad, -90 * kDegree_rad, 1e-12);
    EXPECT_NEAR(scans[0].beams->bearing_step_rad, 1 * kDegree_rad, 1e-12);
  }
}

TEST_F(CarmenLog, KnowsTheFieldOfViewOfEachNumberOfBeamsThatASickScannerGives) {
  const struct {
    int beams;
    double first_deg, step_deg;
  } scanners[] = {{180, -90, 1}, {181, -90, 1},   {360, -90, 0.5}, {361, -90, 0.5},
                  {101, -50, 1}, {201, -50, 0.5}, {401, -50, 0.25}};
  for (const auto& [beams, first_deg, step_deg] : scanners) {
    const std::vector<Scan> scans = read_carmen_log(plain(flaser(beams)), 20);
    EXPECT_NEAR(scans[0].beams->first_bearing_rad, first_deg * kDegree_rad, 1e-12) << beams;
    EXPECT_NEAR(scans[0].beams->bearing_step_rad, step_deg * kDegree_rad, 1e-12) << beams;
    EXPECT_EQ(scans[0].beams->direction_sensor.size(), static_cast<std::size_t>(beams));
  }
}

TEST_F(CarmenLog, TakesTheFieldOfViewThatItsParametersTell) {
  const auto step_deg = [&](const std::string& parameter, int beams) {
    return read_carmen_log(plain("PARAM " + parameter + " host 0\n" + flaser(beams)), 20)[0]
               .beams->bearing_step_rad /
           kDegree_rad;
  };
  EXPECT_NEAR(step_deg("laser_front_laser_fov 270", 541), 0.5, 1e-12);
  EXPECT_NEAR(step_deg("laser_front_laser_fov 100", 181), 100.0 / 180, 1e-12);
  EXPECT_NEAR(step_deg("laser_front_laser_resolution 0.25", 541), 0.25, 1e-12);
  EXPECT_NEAR(step_deg("robot_width 0.5", 181), 1, 1e-12);
  EXPECT_THAT(error_in(plain("PARAM laser_front_laser_fov wide\n" + flaser(181))),
              HasSubstr("a.log:1: broken PARAM laser_front_laser_fov"));
}

TEST_F(CarmenLog, ReadsTheBearingsOfRobotlaserLinesAndWhatTheirSensorMissed) {
  const std::string line = "ROBOTLASER1 0 -1.0 2.0 0.5 8.0 0.01 0 5 2 3 8.0 4 30 " + ranges(2) +
                           " 7 8 0.25 7 8 0.25 0 0 0 0 0 1.5 host 1.5\n";
  const std::vector<Scan> scans = read_carmen_log(plain(line), 20);
  ASSERT_EQ(scans.size(), 1U);
  EXPECT_EQ(scans[0].beams->first_bearing_rad, -1);
  EXPECT_EQ(scans[0].beams->bearing_step_rad, 0.5);
  EXPECT_EQ(scans[0].sensor_world.p_world, Vec2(7, 8));
  const bool returns[] = {true, true, false, true, false};
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(scans[0].is_return(i), returns[i]) << i;
}

TEST_F(CarmenLog, ThatIsCutIsAnErrorAndNoShorterLog) {
  std::string text;
  for (int i = 0; i < 200; ++i) text += "FLASER " + ranges(181, std::to_string(i)) + " 1 2 0 \n";
  const std::string path = zipped(text);
  fs::resize_file(path, fs::file_size(path) / 2);
  EXPECT_THAT(error_in(path), HasSubstr("a.log.gz: the gzip file is cut or damaged"));
  EXPECT_THAT(error_in(plain(flaser(181).substr(0, 200))),
              HasSubstr("a.log:1: broken FLASER (expected 181 ranges)"));
}

TEST_F(CarmenLog, NamesTheLineAndWhatIsExpectedThere) {
  EXPECT_THAT(error_in(plain("\n" + flaser(77))),
              HasSubstr("a.log:2: FLASER of 77 beams: nothing tells their field of view"));
  EXPECT_THAT(error_in(plain("FLASER 0 1 2 0\n")), HasSubstr("number of beams from 2 to 100000"));
  EXPECT_THAT(error_in(plain("FLASER " + ranges(181) + " 1 2\n")), HasSubstr("x, y and heading"));
  EXPECT_THAT(error_in(plain("ODOM 0 0 0\n")), HasSubstr("a.log: no scan in it"));
  EXPECT_THAT(error_in(plain("ROBOTLASER1 0 -1 2 0 8 0 0 " + ranges(5) + " 0 1 2 0\n")),
              HasSubstr("a.log:1: broken ROBOTLASER1"));
  EXPECT_THAT(error_in(file("none.log")), HasSubstr("none.log: is no file"));
}

}  // namespace
}  // namespace voronaut
