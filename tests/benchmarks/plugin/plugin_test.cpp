#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include "voronaut/benchmarks/results/output_folder.h"
#include "voronaut/tests/benchmarks/small_suite.h"

// Planners of somebody else, as they come: in a program of their own, in a shared library.
namespace voronaut {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

const std::string kExample = VORONAUT_SOURCE_DIR "/benchmarks/examples/straight-line.yaml";

class Plugin : public ::testing::Test {
 protected:
  int run(const std::string& program, const std::string& arguments) {
    const std::string command = "cd '" + folder_.path().string() + "' && '" + program + "' " +
                                arguments + " >said.txt 2>&1";
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  std::string said() const {
    std::ostringstream text;
    text << std::ifstream(folder_.path() / "said.txt").rdbuf();
    return text.str();
  }
  // Outcome and reason of each trial, by "scenario/planner".
  std::map<std::string, std::string> ends(const std::string& results) const {
    std::map<std::string, std::string> found;
    for (const RunRecord& record : OutputFolder::open(folder_.path() / results).store().records())
      found[record.scenario + "/" + record.planner] =
          std::string(to_string(record.outcome)) + ": " + record.reason;
    return found;
  }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_.path() / name) << text;
  }
  void expect_example_flown(const std::string& results) const {
    const auto found = ends(results);
    ASSERT_EQ(found.size(), 4U) << said();
    EXPECT_THAT(found.at("open/StraightLine"), StartsWith("goal_reached"));
    EXPECT_THAT(found.at("open/RRTConnect"), StartsWith("goal_reached"));
    EXPECT_THAT(found.at("pillar/RRTConnect"), StartsWith("goal_reached"));
  }

 private:
  TemporaryFolder folder_;
};

TEST_F(Plugin, AProgramOfThreeLinesFliesItsPlanner) {
  run(VORONAUT_EXAMPLE_PROGRAM, "run " + kExample + " --out own");
  expect_example_flown("own");
}

TEST_F(Plugin, ALibraryAddsItsPlannerToTheProgram) {
  const std::string plugin = " --plugin " VORONAUT_EXAMPLE_PLUGIN;
  EXPECT_EQ(run(VORONAUT_PROGRAM, "list planners" + plugin), 0);
  EXPECT_THAT(said(), HasSubstr("StraightLine"));
  EXPECT_EQ(run(VORONAUT_PROGRAM, "check " + kExample + plugin), 0) << said();
  run(VORONAUT_PROGRAM, "run " + kExample + " --out results" + plugin);
  expect_example_flown("results");
  EXPECT_EQ(run(VORONAUT_PROGRAM, "check " + kExample), 2);
  EXPECT_THAT(said(), HasSubstr("no planner 'StraightLine'"));
}

const std::string kOpen =
    "scenarios: [{name: open, world: {circles: [[2, 3, 0.5]]}, bounds: [[-2, -2], [5, 5]], "
    "start: [0, 0], goal: [2, 1]}]\nvehicles: [ideal]\n"
    "limits: {memory_mb: 200, cpu_s: 600, wall_s: 600}\n";
const std::string kHostile = " --plugin " VORONAUT_HOSTILE_PLUGIN;

TEST_F(Plugin, WhatALibraryDoesToItsProcessIsARow) {
  write("hostile.yaml",
        "suite: hostile\nplanners: [Throws, Aborts, Leaks, StillBorn, Boastful, "
        "RRTConnect]\n" +
            kOpen);
  EXPECT_EQ(run(VORONAUT_PROGRAM, "run hostile.yaml" + kHostile), 1);
  const auto found = ends("voronaut-results/hostile");
  ASSERT_EQ(found.size(), 6U) << said();
  EXPECT_EQ(found.at("open/Throws"), "crash: exception: no idea how to go on");
  EXPECT_THAT(found.at("open/Aborts"), StartsWith("crash: ended by SIGABRT"));
  EXPECT_THAT(found.at("open/StillBorn"), StartsWith("crash: ended by SIGABRT"));
  EXPECT_EQ(found.at("open/Leaks"), "memory: asked for more than 200 MB of memory");
  EXPECT_EQ(found.at("open/Boastful"),
            "crash: exception: the planner says 'Exact solution' but has added no geometric path");
  EXPECT_THAT(found.at("open/RRTConnect"), StartsWith("goal_reached"));
}

TEST_F(Plugin, APlannerThatComputesForEverIsStoppedByItsCpuLimit) {
  std::string text = "suite: loops\nplanners: [Loops]\n" + kOpen;
  text.replace(text.find("cpu_s: 600"), 10, "cpu_s: 1");
  write("loops.yaml", text);
  EXPECT_EQ(run(VORONAUT_PROGRAM, "run loops.yaml" + kHostile), 1);
  EXPECT_EQ(ends("voronaut-results/loops").at("open/Loops"),
            "killed: used more than 1 s of CPU time");
}

// What case by case once lost results, whatever the system allows: rows of others stay.
TEST_F(Plugin, APlannerThatAttacksTheResultsLosesNoRowOfOthers) {
  write("attack.yaml",
        "suite: attack\nplanners: [{name: RRTConnect, label: first}, WritesToThree, "
        "UnlinksDatabase, KillsParent, {name: RRTConnect, label: last}]\n" +
            kOpen);
  run(VORONAUT_PROGRAM, "run attack.yaml --jobs 1 --out attacked" + kHostile);
  const auto found = ends("attacked");
  ASSERT_EQ(found.size(), 5U) << said();
  EXPECT_THAT(found.at("open/first"), StartsWith("goal_reached"));
  EXPECT_THAT(found.at("open/last"), StartsWith("goal_reached"));
  EXPECT_THAT(found.at("open/WritesToThree"), ::testing::Not(StartsWith("crash")));
}

TEST_F(Plugin, AClaimThatIsNotTrueIsNoSuccessInAStaticTrial) {
  write("static.yaml", "suite: static\nkind: static\nplanners: [Boastful, Homebody]\n" + kOpen);
  run(VORONAUT_PROGRAM, "run static.yaml" + kHostile);
  const auto found = ends("voronaut-results/static");
  ASSERT_EQ(found.size(), 2U) << said();
  EXPECT_EQ(found.at("open/Boastful"),
            "crash: exception: the planner says 'Exact solution' but has added no geometric path");
  EXPECT_EQ(found.at("open/Homebody"),
            "timeout: Exact solution, but its path does not end at the goal");
}

// A pillar stands on the straight way.
TEST_F(Plugin, APathIsJudgedByAProblemThatNoPlannerSawAndNotByWhatIsKept) {
  const std::string suite =
      "kind: known\nplanners: [NoNumberFirst, NoNumberOnTheWay, NoNumberInOneAxis, NoNumberLast, "
      "InfiniteOnTheWay, FarAway, OutOfBounds, Straight, StraightIfAllowed, GoalIsEverywhere, "
      "GoalIsStart, GoalIsAnother, StartIsGoal]\n"
      "scenarios: [{name: pillar, world: {circles: [[1, 0.5, 0.2]]}, "
      "bounds: [[-2, -2], [5, 5]], start: [0, 0], goal: [2, 1]}]\nvehicles: [ideal]\n";
  const std::string no_place =
      "crash: exception: the planner says 'Exact solution' but its path has a position that is no "
      "place";
  for (const std::string traces : {"none", "all"}) {
    write("forged.yaml", "suite: " + traces + "\ntraces: " + traces + "\n" + suite);
    run(VORONAUT_PROGRAM, "run forged.yaml" + kHostile);
    const auto found = ends("voronaut-results/" + traces);
    ASSERT_EQ(found.size(), 13U) << said();
    for (const char* planner : {"NoNumberFirst", "NoNumberOnTheWay", "NoNumberInOneAxis",
                                "NoNumberLast", "InfiniteOnTheWay", "FarAway"})
      EXPECT_EQ(found.at(std::string("pillar/") + planner), no_place) << planner << traces;
    for (const char* planner : {"OutOfBounds", "Straight", "StraightIfAllowed"})
      EXPECT_EQ(found.at(std::string("pillar/") + planner), "collision: Exact solution")
          << planner << traces;
    for (const char* planner : {"GoalIsEverywhere", "GoalIsStart", "GoalIsAnother"})
      EXPECT_EQ(found.at(std::string("pillar/") + planner),
                "timeout: Exact solution, but its path does not end at the goal")
          << planner << traces;
    EXPECT_EQ(found.at("pillar/StartIsGoal"),
              "timeout: Exact solution, but its path begins elsewhere")
        << traces;
  }
}

TEST_F(Plugin, NobodyFliesToAGoalThatThePlannerPutElsewhere) {
  write("flown.yaml",
        "suite: flown\nplanners: [NoNumberOnTheWay, GoalIsEverywhere, GoalIsStart, GoalIsAnother, "
        "StartIsGoal]\n" +
            kOpen);
  run(VORONAUT_PROGRAM, "run flown.yaml" + kHostile);
  const auto found = ends("voronaut-results/flown");
  ASSERT_EQ(found.size(), 5U) << said();
  EXPECT_THAT(found.at("open/NoNumberOnTheWay"), StartsWith("crash: exception"));
  for (const char* planner : {"GoalIsEverywhere", "GoalIsStart", "GoalIsAnother", "StartIsGoal"})
    EXPECT_THAT(found.at(std::string("open/") + planner),
                AllOf(StartsWith("stuck: stood still"), HasSubstr("Exact solution, but its path")))
        << planner;
}

TEST_F(Plugin, AParameterThatAPlannerDoesNotSurviveIsAnErrorOfItsSuite) {
  const auto refusal = [&](const std::string& planner) {
    write("s.yaml", "suite: s\nplanners:\n  - " + planner + "\n" + kOpen);
    EXPECT_EQ(run(VORONAUT_PROGRAM, "check s.yaml" + kHostile), 2);
    return said();
  };
  EXPECT_THAT(refusal("{name: Loops, params: {fuse: 7}}"),
              StartsWith("voronaut: s.yaml:3: key 'planners[0].params.fuse': planner 'Loops' does "
                         "not survive this value: ended by SIGABRT"));
  write("s.yaml", "suite: s\nplanners: [{name: Loops, params: {fuse: 0}}]\n" + kOpen);
  EXPECT_EQ(run(VORONAUT_PROGRAM, "check s.yaml" + kHostile), 0) << said();
}

TEST_F(Plugin, WhatIsNoPluginIsRefusedInOneLine) {
  EXPECT_EQ(run(VORONAUT_PROGRAM, "run smoke --plugin none.so"), 2);
  EXPECT_EQ(said(), "voronaut: plugin none.so: no such file\n");
  write("text.so", "no library");
  EXPECT_EQ(run(VORONAUT_PROGRAM, "run smoke --plugin text.so"), 2);
  EXPECT_THAT(said(), StartsWith("voronaut: plugin text.so: "));
  EXPECT_EQ(run(VORONAUT_PROGRAM, "run smoke --plugin " VORONAUT_ABORTING_PLUGIN), 2);
  EXPECT_THAT(said(), HasSubstr("libaborting_plugin.so: cannot be loaded: ended by SIGABRT\n"));
  const std::string twice = VORONAUT_EXAMPLE_PLUGIN;
  EXPECT_EQ(run(VORONAUT_PROGRAM, "list planners --plugin " + twice + " --plugin " + twice), 2);
  EXPECT_THAT(said(), HasSubstr("'StraightLine' is in the catalogue already"));
}

}  // namespace
}  // namespace voronaut
