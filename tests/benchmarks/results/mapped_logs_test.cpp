#include "voronaut/benchmarks/results/mapped_logs.h"

#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>

namespace voronaut {
namespace {

namespace fs = std::filesystem;

TEST(MappedLogs, AreAllLogsOfTheFolderUnderAnyName) {
  const fs::path data = fs::temp_directory_path() / "voronaut-mapped-logs";
  fs::create_directories(data / "lidar");
  for (const char* name : {"b-corrected.log.gz", "c.log", "a.log", "index.csv", "notes.gz"}) {
    std::ofstream log(data / "lidar" / name);
    log << "FLASER 181";
    for (int beam = 0; beam < 181; ++beam) log << " 2.0";
    log << " 1 2 0.5 0 0 0 1.5 host 1.5\n";
  }
  std::vector<std::string> names;
  for (const LidarLog& log : lidar_logs(data.string())) names.push_back(log.name);
  EXPECT_THAT(names, ::testing::ElementsAre("a", "b", "c"));
  const std::vector<MappedLog> logs = map_logs(data.string());
  ASSERT_EQ(logs.size(), 3U);
  EXPECT_EQ(logs[2].name, "c");
  EXPECT_EQ(logs[2].returns, 181U);
  fs::remove_all(data);
  EXPECT_THAT(lidar_logs(data.string()), ::testing::IsEmpty());
}

}  // namespace
}  // namespace voronaut
