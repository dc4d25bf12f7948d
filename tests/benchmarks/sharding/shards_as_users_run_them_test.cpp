#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "voronaut/benchmarks/results/folder_lock.h"
#include "voronaut/benchmarks/results/output_folder.h"
#include "voronaut/tests/support/temporary_folder.h"

namespace voronaut {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;

class ShardedRunByCommands : public ::testing::Test {
 protected:
  void SetUp() override {
    std::ofstream(path("s.yaml"))
        << "suite: s\nrepetitions: 4\nscenarios:\n  - {name: open, world: {circles: [[2, 3, 0.5]]},"
           " bounds: [[-2, -2], [5, 5]], start: [0, 0], goal: [2, 1]}\n  - {name: wood, generator:"
           " {name: forest, side_m: 6, density_per_m2: 0.05}}\n"
           "vehicles: [{name: ideal, params: {planning_clearance_m: 0.4}}]\n"
           "planners: [RRTConnect, PotentialField]\n";
  }
  int voronaut(const std::string& arguments) {
    const std::string command = "cd '" + folder_.path().string() +
                                "' && env -u VORONAUT_DATA '" VORONAUT_PROGRAM "' " + arguments +
                                " >said.txt 2>&1";
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  std::string text_of(const std::string& name) const {
    std::ostringstream text;
    text << std::ifstream(path(name)).rdbuf();
    return text.str();
  }
  std::string said() const { return text_of("said.txt"); }
  std::string digest_of(const std::string& folder) {
    voronaut("digest " + folder);
    return said();
  }
  fs::path path(const std::string& name) const { return folder_.path() / name; }

 private:
  TemporaryFolder folder_;
};

TEST_F(ShardedRunByCommands, IsMergedToWhatTheSerialRunIsAndReplays) {
  ASSERT_EQ(voronaut("run s.yaml --out serial"), 0) << said();
  for (const char* shard : {"3/3", "1/3", "2/3"}) {
    ASSERT_EQ(voronaut("status r s.yaml"), 1) << said();
    ASSERT_EQ(voronaut(std::string("run s.yaml --out r --shard ") + shard), 0) << said();
  }
  EXPECT_EQ(voronaut("status r"), 0) << said();
  EXPECT_THAT(said(), ContainsRegex("all +16 +0 +0\n"));
  EXPECT_THAT(text_of("r/shards/2-of-3/manifest.json"), HasSubstr("\"shard\": \"2/3\""));
  ASSERT_EQ(voronaut("merge r -o r"), 0) << said();
  ASSERT_EQ(voronaut("merge r/shards/3-of-3 r/shards/1-of-3 r/shards/2-of-3 -o m"), 0) << said();
  const std::string serial = digest_of("serial");
  EXPECT_EQ(digest_of("r"), serial);
  EXPECT_EQ(digest_of("m"), serial);
  EXPECT_EQ(voronaut("status m"), 0) << said();
  EXPECT_EQ(voronaut("summary m"), 0) << said();
  for (const char* file : {"results.csv", "report.html", "manifest.json"})
    EXPECT_TRUE(fs::exists(path("m") / file)) << file;
  const auto ids = OutputFolder::open(path("m")).store().trial_ids();
  EXPECT_EQ(voronaut("replay m " + ids.front()), 0) << said();
  // Nothing is flown twice when the number of shards changes.
  ASSERT_EQ(voronaut("run s.yaml --out r --shard 1/2"), 0) << said();
  EXPECT_TRUE(OutputFolder::open(path("r/shards/1-of-2")).store().trial_ids().empty());
}

TEST_F(ShardedRunByCommands, CountsWhatFailedAndWhatIsMissingByPlanner) {
  ASSERT_EQ(voronaut("run s.yaml --out r --shard 1/2 --planners RRTConnect"), 0) << said();
  EXPECT_EQ(voronaut("status r"), 1);
  EXPECT_THAT(said(), ContainsRegex("PotentialField +0 +8 +0\n"));
  EXPECT_EQ(voronaut("status nowhere"), 2);
  EXPECT_THAT(said(), HasSubstr("voronaut: nowhere: no results here"));
}

TEST_F(ShardedRunByCommands, WaitsForTheCopyOfItThatIsJustBeingEnded) {
  fs::create_directories(path("r/shards/1-of-2"));
  auto lock = std::make_unique<FolderLock>(path("r/shards/1-of-2"));
  std::thread ends([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    lock.reset();
  });
  EXPECT_EQ(voronaut("run s.yaml --out r --shard 1/2"), 0) << said();
  ends.join();
}

TEST_F(ShardedRunByCommands, RefusesAnotherSuiteInTheFolderOfAShard) {
  ASSERT_EQ(voronaut("run s.yaml --shard 1/2"), 0) << said();
  std::ofstream(path("s.yaml"), std::ios::app) << "seed: 9\n";
  EXPECT_EQ(voronaut("run s.yaml --shard 1/2"), 2);
  EXPECT_THAT(said(), HasSubstr("holds results of another version of this suite"));
}

TEST_F(ShardedRunByCommands, EndsInOrderWhenItIsAskedToAndNotAtATerminal) {
  std::ofstream(path("long.yaml")) << "suite: long\nrepetitions: 5000\ntraces: none\n" +
                                          text_of("s.yaml").substr(text_of("s.yaml").find("sce"));
  for (const auto& [signal, code] :
       {std::pair("TERM", 0), std::pair("USR1", 0), std::pair("INT", 1)}) {
    const std::string out = std::string("out-") + signal;
    // A row is there: it flies.
    const std::string wait = "until [ $('" VORONAUT_PROGRAM "' summary --csv " + out +
                             " 2>/dev/null | wc -l) -gt 1 ]; do sleep 0.05; done; ";
    const std::string script = "cd " + path("").string() +
                               " && trap '' HUP; set -m; '" VORONAUT_PROGRAM
                               "' run long.yaml --out " +
                               out + " >said.txt 2>&1 & p=$!; cd " + path("").string() + "; " +
                               wait + "kill -" + signal + " $p; wait $p; echo $? >code.txt";
    static_cast<void>(std::system(("bash -c '" +
                                   [&] {
                                     std::string quoted;
                                     for (const char c : script)
                                       quoted +=
                                           c == '\'' ? std::string("'\\''") : std::string(1, c);
                                     return quoted;
                                   }() +
                                   "'")
                                      .c_str()));
    EXPECT_EQ(std::atoi(text_of("code.txt").c_str()), code) << signal << ": " << said();
    EXPECT_THAT(said(), HasSubstr("the same command goes on from here")) << signal;
    EXPECT_FALSE(fs::exists(path(out) / "in-use"));
  }
}

TEST_F(ShardedRunByCommands, WritesWhatItWouldSubmitAndCancelsOnlyThat) {
  for (const char* engine : {"slurm", "parallel", "snakemake", "script"})
    EXPECT_EQ(
        voronaut(std::string("submit s.yaml --out r --shards 3 --dry-run --engine ") + engine), 0)
        << said();
  EXPECT_THAT(said(), ::testing::Not(HasSubstr("wall clock")));
  EXPECT_TRUE(fs::exists(path("r/engines/slurm/shards.sbatch")));
  EXPECT_FALSE(fs::exists(path("r/shards"))) << "nothing was started";
  EXPECT_EQ(voronaut("cancel r"), 0) << said();
  EXPECT_EQ(voronaut("cancel nowhere"), 2);
  EXPECT_THAT(said(), HasSubstr("nothing was submitted from here"));
  EXPECT_EQ(voronaut("submit s.yaml --engine condor"), 2);
  // One command a line, each from anywhere.
  EXPECT_EQ(std::system(("cd / && sh -e " + path("r/engines/script/shards.txt").string() +
                         " >/dev/null 2>&1 && sh " + path("r/engines/script/merge.txt").string() +
                         " >/dev/null 2>&1")
                            .c_str()),
            0);
  EXPECT_EQ(voronaut("status r"), 0) << said();
}

TEST_F(ShardedRunByCommands, WarnsOfSuitesThatNoDigestCanRepeat) {
  std::ofstream(path("s.yaml"), std::ios::app) << "budget: {wall_clock_s: 0.2}\n";
  EXPECT_EQ(voronaut("submit s.yaml --out r --shards 3 --dry-run --engine script"), 0);
  EXPECT_THAT(said(), HasSubstr(": its budget is wall clock (budget.wall_clock_s)"));
}

}  // namespace
}  // namespace voronaut
