#include "voronaut/benchmarks/results/published_file.h"

#include <cmath>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "voronaut/environments/config/config_error.h"
#include "voronaut/tests/support/temporary_folder.h"

namespace voronaut {
namespace {

using ::testing::HasSubstr;

const std::string kHeader =
    "method,world,runs,successes,collisions,timeouts,mean_time_success_s,optimal_time_s,score\n";

class PublishedFile : public testing::Test {
 protected:
  std::vector<PublishedMethod> read(const std::string& rows) {
    const auto file = folder_.path() / "p.csv";
    std::ofstream(file) << kHeader << rows;
    return read_published(file.string());
  }

  TemporaryFolder folder_;
};

TEST_F(PublishedFile, GivesEachMethodItsWorldsByOurNames) {
  const auto methods =
      read("DWA,6,10,9,1,0,39.7,6.2,0.16\nLiCS,6,10,0,10,0,,6.2,0\nDWA,18,10,10,0,0,35,5.8,0.17\n");
  ASSERT_EQ(methods.size(), 2U);
  ASSERT_EQ(methods[0].worlds.size(), 2U);
  EXPECT_EQ(methods[0].name, "DWA");
  EXPECT_EQ(methods[0].worlds[1].scenario, "barn_018");
  EXPECT_EQ(methods[0].worlds[0].successes, 9);
  EXPECT_EQ(methods[0].worlds[0].collisions, 1);
  EXPECT_EQ(methods[0].worlds[0].score, 0.16);
  EXPECT_TRUE(std::isnan(methods[1].worlds[0].time_s)) << "none arrived";
}

TEST_F(PublishedFile, IsRefusedWithItsLineWhereItCannotBeTrue) {
  try {
    read("DWA,6,10,11,0,0,39.7,6.2,0.16\n");
    FAIL() << "more successes than runs";
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(), HasSubstr("p.csv:2"));
    EXPECT_THAT(error.what(), HasSubstr("successes"));
  }
  EXPECT_THROW(read("DWA,6,10,9,0,0,39.7,6.2,0.7\n"), ConfigError) << "the best score is 0.5";
}

}  // namespace
}  // namespace voronaut
