#include "voronaut/benchmarks/results/output_folder.h"

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <set>
#include <sstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "voronaut/benchmarks/results/digest.h"
#include "voronaut/tests/support/temporary_folder.h"

// Folders of results as the program makes them: killed at every call, on a disk that is full, by
// two at once, and away from the files they came from.
namespace voronaut {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::StartsWith;

const std::set<std::string> kWholeFolder = {"manifest.json", "report.html", "results.csv",
                                            "results.db"};

class Folder : public ::testing::Test {
 protected:
  void SetUp() override {
    write("s.yaml",
          "suite: s\ntraces: none\nrepetitions: 2\nscenarios: [{name: open, world: {circles: "
          "[[2, 3, 0.5]]}, bounds: [[-2, -2], [5, 5]], start: [0, 0], goal: [2, 1]}]\n"
          "vehicles: [ideal]\nplanners: [RRTConnect]\n");
  }

  fs::path path(const std::string& name) const { return folder_.path() / name; }
  void write(const std::string& name, const std::string& text) const {
    fs::create_directories(path(name).parent_path());
    std::ofstream(path(name)) << text;
  }
  // The exit code as a shell sees it; what was said passes through a pipe into said.txt.
  int voronaut(const std::string& arguments, const std::string& before = "") {
    const std::string command = "cd '" + folder_.path().string() + "' && ( " + before + " '" +
                                VORONAUT_PROGRAM + "' " + arguments +
                                " ; echo \\$? >code.txt ) 2>&1 | cat >said.txt";
    static_cast<void>(std::system(("env -u VORONAUT_DATA sh -c \"" + command + "\"").c_str()));
    return std::atoi(text_of("code.txt").c_str());
  }
  std::string text_of(const std::string& name) const {
    std::ostringstream text;
    text << std::ifstream(path(name)).rdbuf();
    return text.str();
  }
  std::string said() const { return text_of("said.txt"); }
  std::string digest_of(const std::string& results) const {
    return digest(OutputFolder::open(path(results)).store().records());
  }
  std::set<std::string> files_in(const std::string& results) const {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(path(results)))
      names.insert(entry.path().filename().string());
    return names;
  }
  std::string killed_at(int call) const {
    return "env LD_PRELOAD=" VORONAUT_KILL_AT_CALL_LIBRARY " VORONAUT_KILL_AT_CALL=" +
           std::to_string(call);
  }

 private:
  TemporaryFolder folder_;
};

TEST_F(Folder, KilledAtAnyCallIsCompletedByTheSameCommand) {
  ASSERT_EQ(voronaut("run s.yaml --out whole"), 0) << said();
  const std::string whole = digest_of("whole");
  int killed = 0;
  for (int call = 1; call <= 60; ++call) {
    fs::remove_all(path("r"));
    if (voronaut("run s.yaml --out r", killed_at(call)) == 0) break;
    ++killed;
    ASSERT_EQ(voronaut("run s.yaml --out r"), 0) << "killed at call " << call << ": " << said();
    ASSERT_EQ(digest_of("r"), whole) << "killed at call " << call;
    ASSERT_EQ(files_in("r"), kWholeFolder) << "killed at call " << call;
  }
  EXPECT_GT(killed, 20) << "the library counts no calls";
}

TEST_F(Folder, KilledAgainAndAgainIsCompletedByTheSameCommand) {
  ASSERT_EQ(voronaut("run s.yaml --out whole"), 0) << said();
  for (int call = 1; call <= 60; call += 4)
    if (voronaut("run s.yaml --out r", killed_at(call)) == 0) break;
  ASSERT_EQ(voronaut("run s.yaml --out r"), 0) << said();
  EXPECT_EQ(digest_of("r"), digest_of("whole"));
  EXPECT_EQ(files_in("r"), kWholeFolder);
}

TEST_F(Folder, OnADiskThatIsFullIsCompletedByTheSameCommandWhenItIsNot) {
  ASSERT_EQ(voronaut("run s.yaml --out whole"), 0) << said();
  for (const char* blocks : {"1", "8", "40", "120", "300", "600"}) {
    fs::remove_all(path("r"));
    const int code = voronaut("run s.yaml --out r", std::string("ulimit -f ") + blocks + ";");
    if (code != 0) {
      EXPECT_THAT(said(), HasSubstr("voronaut: ")) << blocks;
      EXPECT_THAT(said(), ::testing::AnyOf(HasSubstr("File too large"), HasSubstr("disk")));
    }
    ASSERT_EQ(voronaut("run s.yaml --out r"), 0) << blocks << ": " << said();
    EXPECT_EQ(digest_of("r"), digest_of("whole"));
    EXPECT_EQ(files_in("r"), kWholeFolder);
  }
}

TEST_F(Folder, BelongsToOneRunnerAndSaysWhoHoldsIt) {
  fs::create_directories(path("r"));
  {
    const FolderLock lock(path("r"));
    EXPECT_EQ(voronaut("run s.yaml --out r"), 2);
    EXPECT_THAT(said(),
                StartsWith("voronaut: r: in use by process " + std::to_string(getpid()) + " on "));
    EXPECT_EQ(files_in("r"), std::set<std::string>{"in-use"});
  }
  EXPECT_TRUE(files_in("r").empty());
  write("r/in-use", "process 1 on nowhere since ever\n");  // of one that was killed
  EXPECT_EQ(voronaut("run s.yaml --out r"), 0) << said();
  EXPECT_EQ(files_in("r"), kWholeFolder);
}

TEST_F(Folder, IsMovedAsideWholeWhenTheSuiteIsAnother) {
  ASSERT_EQ(voronaut("run s.yaml"), 0) << said();
  write("s.yaml", text_of("s.yaml") + "seed: 2\n");
  ASSERT_EQ(voronaut("run s.yaml"), 0) << said();
  EXPECT_EQ(files_in("voronaut-results/s.1"), kWholeFolder);
  EXPECT_EQ(files_in("voronaut-results/s"), kWholeFolder);
}

TEST_F(Folder, LosesLeftoverTemporaryFilesAndNothingElse) {
  for (const char* name : {"r/report.html.part4711", "r/results.csv.part", "r/my.part.txt"})
    write(name, "x");
  EXPECT_EQ(voronaut("run s.yaml --out r"), 0) << said();
  auto expected = kWholeFolder;
  expected.insert("my.part.txt");
  EXPECT_EQ(files_in("r"), expected);
}

TEST_F(Folder, WithADatabaseThatHoldsNothingYetIsNoOtherVersion) {
  write("r/results.db", "");
  EXPECT_EQ(voronaut("run s.yaml --out r"), 0) << said();
  EXPECT_EQ(files_in("r"), kWholeFolder);
}

TEST_F(Folder, SaysWhichRepetitionsASummaryShows) {
  ASSERT_EQ(voronaut("run s.yaml --out r"), 0) << said();
  EXPECT_THAT(said(), ::testing::Not(HasSubstr("stored trials are shown")));
  const std::string note =
      "all 2 stored trials are shown, 1 of them beyond the 1 repetitions asked for last (2 are "
      "stored)\n";
  ASSERT_EQ(voronaut("run s.yaml --out r --repetitions 1"), 0) << said();
  EXPECT_THAT(said(), HasSubstr(note));
  voronaut("summary r");
  EXPECT_THAT(said(), HasSubstr(note));
}

TEST_F(Folder, IsWholeWithoutTheFilesItCameFrom) {
  write("in/world.yaml",
        "world: {circles: [[2, 3, 0.5]]}\nbounds: [[-2, -2], [5, 5]]\nstart: [0, 0]\ngoal: [2, "
        "1]\n");
  std::string arena = "type octile\nheight 20\nwidth 20\nmap\n";
  for (int row = 0; row < 20; ++row) arena += std::string(20, '.') + "\n";
  write("in/arena.map", arena);
  write("in/s.yaml",
        "# What is shown.\nsuite: s\nscenarios:\n  - {file: world.yaml}\n  - {world_file: "
        "arena.map, name: arena, start: [1.5, 1.5], goal: [3.5, 3]}\nvehicles: [ideal]\n"
        "planners: [StraightLine]\n");
  const std::string plugin = " --plugin " VORONAUT_EXAMPLE_PLUGIN;
  voronaut("run in/s.yaml --out r" + plugin);
  fs::remove_all(path("in"));
  const auto ids = OutputFolder::open(path("r")).store().trial_ids();
  ASSERT_EQ(ids.size(), 2U) << said();
  for (const std::string& id : ids) {
    EXPECT_EQ(voronaut("replay r " + id + plugin), 0) << said();
    EXPECT_THAT(said(), HasSubstr("is the same, bit for bit"));
  }
  voronaut("evidence r" + plugin);  // of no claim; it reads the suite all the same
  EXPECT_THAT(said(), HasSubstr("What is shown."));
}

TEST_F(Folder, TakesLabelsThatBreakNoTableAndRefusesOthers) {
  const auto run_with = [&](const std::string& label) {
    std::string text = text_of("s.yaml");
    text.replace(text.find("[RRTConnect]"), 12, "[{name: RRTConnect, label: " + label + "}]");
    write("l.yaml", text);
    return voronaut("run l.yaml --out " + std::to_string(label.size()));
  };
  EXPECT_EQ(run_with("\"two\\nlines\""), 2);
  EXPECT_THAT(said(), HasSubstr("l.yaml:6: key 'planners[0].label': expected a label of 1 to 200 "
                                "bytes without line breaks or control characters, got 9 bytes, "
                                "'two?lines'\n"));
  EXPECT_EQ(run_with(std::string(10'000, 'x')), 2);
  EXPECT_THAT(said(), HasSubstr("got 10000 bytes, 'xxxx"));
  EXPECT_LT(said().size(), 400U);
  EXPECT_EQ(run_with("'=1+2'"), 0) << said();
  EXPECT_THAT(text_of("6/results.csv"), HasSubstr(",'=1+2,"));
}

}  // namespace
}  // namespace voronaut
