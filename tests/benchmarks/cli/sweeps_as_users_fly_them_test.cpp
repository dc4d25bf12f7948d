#include <filesystem>

#include <gmock/gmock.h>

#include "voronaut/reports/store/store.h"
#include "voronaut/tests/benchmarks/cli/program_in_folder.h"

// Settings, includes, sweeps and dry runs, by running the program.
namespace voronaut {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

class SweepsAsUsersFlyThem : public ProgramInFolder {
 protected:
  void SetUp() override {
    write("open.yaml",
          "suite: open\nscenarios: [{name: open, world: {circles: [[2, 3, 0.5]]}, bounds: [[-2, "
          "-2], [5, 5]], start: [0, 0], goal: [2, 1]}]\nvehicles: [ideal]\nplanners: [RRTConnect, "
          "PotentialField]\n");
    write("swept.yaml",
          "include: open.yaml\nsuite: swept\n"
          "sweep: {planners.RRTConnect.range: [0.5, 2], vehicle.max_speed_m_s: [1, 2]}\n");
  }
};

TEST_F(SweepsAsUsersFlyThem, ARunKeepsWhatWasSetForAllThatComesAfter) {
  voronaut(
      "run open.yaml --out a --set planners.RRTConnect.range=0.7 --set vehicle.max_speed_m_s=1");
  EXPECT_THAT(text_of("a/manifest.json"), HasSubstr("\"range\": \"0.7\""));
  std::filesystem::remove(path("open.yaml"));
  EXPECT_THAT(voronaut("status a"), HasSubstr("all"));
  const std::string csv = text_of("a/results.csv");
  const std::string id = csv.substr(csv.find("\r\n") + 2, 64);
  EXPECT_THAT(voronaut("replay a " + id), HasSubstr("is the same, bit for bit"));
  voronaut("merge a -o merged");
  EXPECT_THAT(voronaut("replay merged " + id), HasSubstr("is the same, bit for bit"));
  EXPECT_THAT(voronaut("status a --set planners.RRTConnect.range=0.8", 2),
              HasSubstr("another version of this suite"));
}

TEST_F(SweepsAsUsersFlyThem, OtherSettingsAreAnotherSuite) {
  voronaut("run open.yaml --out a --set planners.RRTConnect.range=0.7");
  EXPECT_THAT(voronaut("run open.yaml --out a", 2), HasSubstr("another version of this suite"));
  // What decides no result may change, and is not remembered any longer than it is said.
  voronaut("run open.yaml --out b --set limits.cpu_s=50");
  const auto remembered = [&] { return ResultStore::open(path("b/results.db")).meta("set"); };
  EXPECT_EQ(remembered(), "[\"limits.cpu_s=50\"]");
  voronaut("run open.yaml --out b");
  EXPECT_EQ(remembered(), "[]");
  EXPECT_EQ(ResultStore::open(path("a/results.db")).meta("sweep"), std::nullopt);
}

TEST_F(SweepsAsUsersFlyThem, ShardsGetTheSettings) {
  const std::string settings = " --set planners.RRTConnect.range=0.7 --set seed=4";
  voronaut("submit open.yaml --engine script --shards 2 --out a --dry-run" + settings);
  EXPECT_THAT(text_of("a/engines/script/shards.txt"),
              HasSubstr("--set planners.RRTConnect.range=0.7 --set seed=4"));
  voronaut("run open.yaml --out whole" + settings);
  for (const char* shard : {"1/2", "2/2"})
    voronaut("run open.yaml --out a --shard " + std::string(shard) + settings);
  voronaut("merge a -o a");
  EXPECT_EQ(voronaut("digest a"), voronaut("digest whole"));
}

TEST_F(SweepsAsUsersFlyThem, AxesAreColumns) {
  voronaut("run swept.yaml --out a");
  const std::string csv = text_of("a/results.csv");
  EXPECT_THAT(csv.substr(0, csv.find('\n')),
              HasSubstr(",memory_max_mb,planners.RRTConnect.range,vehicle.max_speed_m_s\r"));
  EXPECT_THAT(csv, HasSubstr(",0.5,2\r\n"));
  EXPECT_THAT(csv, HasSubstr(",,2\r\n")) << "who is not swept has no value";
  EXPECT_THAT(voronaut("summary a --csv"),
              HasSubstr("open,ideal max_speed_m_s=2,ideal,RRTConnect range=0.5,0.5,2,1,1,"));
  EXPECT_THAT(voronaut("summary a --json"),
              HasSubstr("\"axes\":{\"planners.RRTConnect.range\":\"0.5\""));
  voronaut("merge a -o merged");
  EXPECT_EQ(text_of("merged/results.csv"), csv);
}

TEST_F(SweepsAsUsersFlyThem, ADryRunSaysWhatARunWouldDoAndWritesNothing) {
  const std::string first = voronaut("run swept.yaml --dry-run --repetitions 3 --jobs 2");
  EXPECT_THAT(first, StartsWith("suite 'swept', 1 scenarios x 2 vehicles x 3 planners x 3 "
                                "repetitions = 18 trials\n  over planners.RRTConnect.range: 2 "
                                "values\n  over vehicle.max_speed_m_s: 2 values\n"));
  EXPECT_THAT(first, HasSubstr("RRTConnect range=0.5       6       0       6"));
  EXPECT_THAT(first, HasSubstr("a probe of 3"));
  EXPECT_THAT(first, HasSubstr(path("open.yaml").string()));
  EXPECT_THAT(first, HasSubstr("by 0 trials stored in voronaut-results/swept and a probe of 9"));
  EXPECT_FALSE(std::filesystem::exists(path("voronaut-results")));

  voronaut("run swept.yaml --out a");
  const std::string then = voronaut("run swept.yaml --dry-run --repetitions 3 --out a");
  EXPECT_THAT(then, HasSubstr("RRTConnect range=0.5       6       2       4"));
  EXPECT_THAT(then, HasSubstr("2 stored"));
  EXPECT_THAT(then, HasSubstr("by 6 trials stored in a and a probe of 0"));
  EXPECT_THAT(voronaut("run swept.yaml --dry-run --out a --shard 1/2"), HasSubstr("shard 1/2: "));
  EXPECT_FALSE(std::filesystem::exists(path("a/shards")));
}

}  // namespace
}  // namespace voronaut
