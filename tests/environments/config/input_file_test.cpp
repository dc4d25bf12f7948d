#include "voronaut/environments/config/input_file.h"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "voronaut/environments/config/config_node.h"
#include "voronaut/environments/scenario_files/scenario_reader.h"
#include "voronaut/tests/support/error_of.h"

namespace voronaut {
namespace {

std::string read_error(const std::string& path) {
  return error_of<ConfigError>([&] { read_bytes(path); });
}

class InputFile : public testing::Test {
 protected:
  InputFile() {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  ~InputFile() override { std::filesystem::remove_all(folder_); }

  const std::string folder_ = testing::TempDir() + "voronaut_input_file";
};

TEST_F(InputFile, IsReadWhole) {
  const std::string bytes = std::string(200'000, 'x') + '\0' + "end";
  std::ofstream(folder_ + "/f", std::ios::binary) << bytes;
  EXPECT_EQ(read_bytes(folder_ + "/f"), bytes);
  EXPECT_FALSE(read_bytes("/proc/self/status").empty());  // says that it has no bytes
}

TEST_F(InputFile, IsRefusedAtOnceWhereReadingWouldNotEnd) {
  // With nobody at its other end, an open pipe is waited for.
  const std::string pipe = folder_ + "/pipe.yaml";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(read_error(pipe), pipe + ": cannot be read (is a pipe)");
  EXPECT_EQ(read_error("/dev/zero"), "/dev/zero: cannot be read (is a device)");
  EXPECT_EQ(read_error(folder_), folder_ + ": cannot be read (is a folder)");
  EXPECT_EQ(read_error(folder_ + "/none"),
            folder_ + "/none: cannot be read (No such file or directory)");
}

TEST_F(InputFile, IsRefusedWhereItHasMoreThanTheStatedSize) {
  const std::string file = folder_ + "/large.csv";
  std::ofstream(file) << "x,y,r\n";
  std::filesystem::resize_file(file, kLargestInputFile_bytes);
  EXPECT_EQ(input_file_problem(file), "");
  std::filesystem::resize_file(file, kLargestInputFile_bytes + 1);
  EXPECT_EQ(read_error(file),
            file + ": cannot be read (has more than the 134217728 bytes that are read of a file)");
}

TEST_F(InputFile, IsOpenedInTheSameWayWhereAScenarioNamesIt) {
  const std::string pipe = folder_ + "/pipe.pgm";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  std::ofstream(folder_ + "/map.yaml") << "image: pipe.pgm\nresolution: 1\norigin: [0, 0, 0]\n"
                                          "occupied_thresh: 0.6\nfree_thresh: 0.2\n";
  const auto scenario_error = [&](const std::string& entry) {
    const std::string rest = "bounds: [[0, 0], [9, 9]]\nstart: [1, 1]\ngoal: [8, 8]\n";
    try {
      read_scenarios(ConfigNode::parse(entry + "\n" + rest, folder_ + "/s.yaml"), {});
    } catch (const ConfigError& error) {
      return std::string(error.what()).substr(folder_.size());
    }
    return std::string("no error");
  };
  EXPECT_EQ(scenario_error("world_file: pipe.pgm"),
            "/s.yaml:1: key 'world_file': '" + pipe + "' cannot be read (is a pipe)");
  EXPECT_EQ(scenario_error("world_file: /dev/zero"),
            "/s.yaml:1: key 'world_file': '/dev/zero' cannot be read (is a device)");
  EXPECT_EQ(scenario_error("world_file: map.yaml"),
            "/map.yaml:1: key 'image': " + pipe + ": cannot be read (is a pipe)");
}

}  // namespace
}  // namespace voronaut
