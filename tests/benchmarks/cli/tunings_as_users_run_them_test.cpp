#include <filesystem>
#include <fstream>
#include <set>

#include <gmock/gmock.h>

#include "voronaut/reports/store/store.h"
#include "voronaut/tests/benchmarks/cli/program_in_folder.h"

namespace voronaut {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

class TuningsAsUsersRunThem : public ProgramInFolder {
 protected:
  void SetUp() override {
    write("wood.yaml",
          "suite: wood\nseed: 3\nrepetitions: 6\n"
          "scenarios: [{name: wood, generator: {name: forest, side_m: 8, density_per_m2: 0.1}}]\n"
          "vehicles: [{name: ideal, params: {planning_clearance_m: 0.4}}]\n"
          "planners: [{name: RRTConnect, label: mine, params: {intermediate_states: true}}, "
          "PotentialField]\n"
          "acceptance: [{planner: PotentialField, collision_share_max: 1}]\ntraces: none\n");
  }
  const std::string tune_ =
      "tune wood.yaml --planner mine --over range=0.1:5:log,navigation.off_path_m=0.2:1 "
      "--candidates 4 --out ";
};

TEST_F(TuningsAsUsersRunThem, TheWinnerIsTheSameForAnyJobsAndAfterAnEnd) {
  const std::string said = voronaut(tune_ + "a --jobs 1 2>progress.txt");
  EXPECT_THAT(said, HasSubstr("rung 1 of 2: 4 candidates, 3 repetitions"));
  EXPECT_THAT(said, HasSubstr("rung 2 of 2: "));
  const std::string other = voronaut(tune_ + "b --jobs 2 2>progress.txt");
  EXPECT_EQ(said.substr(0, said.find("suite: ")), other.substr(0, other.find("suite: ")));
  EXPECT_EQ(voronaut(tune_ + "a 2>progress.txt"), said) << "nothing is flown twice";
  EXPECT_EQ(text_of("progress.txt"), "");
}

TEST_F(TuningsAsUsersRunThem, TheSuiteThatIsWrittenFliesTheWinnerAmongTheOthers) {
  voronaut(tune_ + "a");
  const std::string tuned = text_of("a/tuned.yaml");
  EXPECT_THAT(tuned, HasSubstr("# mine tuned: range="));
  EXPECT_THAT(tuned,
              HasSubstr("{name: RRTConnect, label: mine, params: {intermediate_states: true, "
                        "range: "));
  EXPECT_THAT(voronaut("check a/tuned.yaml"),
              HasSubstr("suite 'wood', 1 scenarios x 1 vehicles x 2 planners x 6 repetitions"));
}

TEST_F(TuningsAsUsersRunThem, TheLastWordIsSpokenOnWorldsThatTheRaceHasNotSeen) {
  voronaut(tune_ + "a");
  std::set<std::string> raced;
  const ResultStore race = ResultStore::open(path("a/results.db"));
  race.for_each_record([&](const RunRecord& record) { raced.insert(record.world_id); });
  EXPECT_EQ(raced.size(), 6U) << "all candidates meet the same worlds";
  std::set<std::string> planners;
  const ResultStore fresh = ResultStore::open(path("a/fresh/results.db"));
  fresh.for_each_record([&](const RunRecord& record) {
    EXPECT_FALSE(raced.contains(record.world_id));
    planners.insert(record.planner);
  });
  EXPECT_EQ(fresh.size(), 12U);
  EXPECT_EQ(planners.size(), 2U);
  EXPECT_TRUE(planners.contains("mine"));
}

TEST_F(TuningsAsUsersRunThem, RungsMayBeFlownInShards) {
  const std::string whole = voronaut(tune_ + "whole 2>progress.txt");
  for (int i = 0; i < 3; ++i) {
    const std::string next = voronaut(tune_ + "parts --dry-run");
    const auto command = next.find("voronaut submit ");
    if (command == std::string::npos) break;
    std::string line = next.substr(command + 16, next.find('\n', command) - command - 16);
    line.replace(line.find(" --engine ENGINE"), 16, "");
    for (const char* shard : {" --shard 1/2", " --shard 2/2"}) voronaut("run " + line + shard);
  }
  const std::string parts = voronaut(tune_ + "parts");
  EXPECT_EQ(parts.substr(0, parts.find("suite: ")), whole.substr(0, whole.find("suite: ")));
}

TEST_F(TuningsAsUsersRunThem, BadInputIsSaidInOneLineAndNothingIsWritten) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"--planner min --over range=0.1:5", "--planner: no planner 'min' in wood.yaml"},
      {"--planner mine --over rang=0.1:5", "did you mean 'range'?"},
      {"--planner mine --over range=0.1:5 --for speed", "--for: nothing to tune for is called"},
      {"--planner mine --over range=0.1:5,range=1:2", "'range' is given twice"},
      {"--planner mine --over range=0.1:5 --set sweep.planners.mine.range=[1,2]",
       "a tuning makes the planners itself"},
      {"--planner mine --over range=0.1:5 --candidates 1", "not in range 2 to 1024"},
  };
  for (const auto& [arguments, message] : cases)
    EXPECT_THAT(voronaut("tune wood.yaml " + arguments, 2), HasSubstr(message));
  EXPECT_FALSE(std::filesystem::exists(path("voronaut-results")));
}

TEST_F(TuningsAsUsersRunThem, AFolderBelongsToOneTuning) {
  voronaut(tune_ + "a --dry-run");
  EXPECT_THAT(voronaut(tune_ + "a --seed 9", 2), HasSubstr("holds another tuning"));
}

}  // namespace
}  // namespace voronaut
