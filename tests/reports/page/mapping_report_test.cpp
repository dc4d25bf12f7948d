#include "voronaut/reports/page/mapping_report.h"

#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace voronaut {
namespace {

using ::testing::HasSubstr;

MappedLog small_log() {
  MappedLog log;
  log.name = "cellar";
  log.clusters = 1;
  log.points = {{1.23456, 2}, {3, 4}};
  log.cluster = {0, 0};
  return log;
}

TEST(MappingReport, CarriesTheMeasurementsAndTheLogsInCentimetres) {
  const std::string page = mapping_report(
      "T", R"({"benchmarks":[{"name":"mapping/forest/voronaut/rays:181"}]})", {small_log()});
  EXPECT_THAT(page, HasSubstr("mapping/forest/voronaut/rays:181"));
  EXPECT_THAT(page, HasSubstr("cellar"));
  EXPECT_THAT(page, HasSubstr("[1.23,2.0]"));
}

TEST(MappingReport, RefusesWhatNoBenchmarkWrote) {
  EXPECT_THROW(mapping_report("T", "not json", {}), std::invalid_argument);
  EXPECT_THROW(mapping_report("T", "{}", {}), std::invalid_argument);
}

}  // namespace
}  // namespace voronaut
