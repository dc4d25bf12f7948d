#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include "voronaut/reports/figures/figure_file.h"
#include "voronaut/tests/benchmarks/small_suite.h"

namespace voronaut {
namespace {

using ::testing::HasSubstr;
using ::testing::MatchesRegex;
using ::testing::StartsWith;

struct Answer {
  int exit_code = -1;
  std::string out;
  std::string err;
};

std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

class CommandLine : public ::testing::Test {
 protected:
  // Runs the program in a folder of its own, without the data of whoever runs the tests.
  Answer voronaut(const std::string& arguments) const {
    const std::string command = "cd '" + folder_.path().string() + "' && env -u VORONAUT_DATA '" +
                                VORONAUT_PROGRAM + "' " + arguments + " >out.txt 2>err.txt";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text_of(path("out.txt")),
            text_of(path("err.txt"))};
  }
  std::filesystem::path path(const std::string& name) const { return folder_.path() / name; }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(path(name)) << text;
  }
  // One short flight in the open.
  void write_open_suite() const {
    write("open.yaml",
          "suite: open\nscenarios: [{name: open, world: {circles: [[2, 3, 0.5]]}, bounds: [[-2, "
          "-2], [5, 5]], start: [0, 0], goal: [2, 1]}]\nvehicles: [ideal]\nplanners: [RRTConnect, "
          "PotentialField]\n");
  }

 private:
  TemporaryFolder folder_;
};

TEST_F(CommandLine, SaysInOneLineWhatIsWrongAndWritesNothing) {
  write_open_suite();
  write("broken.yaml", "suite: broken\nplannners: []\n");
  std::filesystem::create_directory(path("empty"));
  const std::string help = " (--help shows what is possible)\n";
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"", "voronaut: A subcommand is required" + help},
      {"rnu open.yaml",
       "voronaut: no command 'rnu' (allowed: init, check, show, run, summary, report, compare, "
       "plot, replay, digest, evidence, export, list, schema, submit, status, merge, cancel, tune, "
       "completion; did you mean 'run'?)" +
           help},
      {"run", "voronaut: SUITE is required" + help},
      {"run open.yaml --jobs 0", "voronaut: --jobs: Value 0 not in range 1 to 1024" + help},
      {"run open.yaml --seed -3",
       "voronaut: --seed: Value -3 not in range 0 to 9223372036854775807" + help},
      {"run open.yaml --colour red",
       "voronaut: run: '--colour' was not expected (allowed: --help, --planners, --seed, "
       "--repetitions, --set, --data, --plugin, --out, --jobs, --shard, --dry-run, --version)" +
           help},
      {"run --planners RRTConnect PotentialField open.yaml",
       "voronaut: run: 'open.yaml' was not expected (values are joined by commas: --planners a,b)" +
           help},
      {"run open.yaml --planners RRTConnect PotentialField",
       "voronaut: run: 'PotentialField' was not expected (values are joined by commas: --planners "
       "a,b)" +
           help},
      {"run nothing.yaml", "voronaut: nothing.yaml: no such file\n"},
      {"run broken.yaml",
       "voronaut: broken.yaml:2: key 'plannners': unknown key (allowed: include, suite, kind, "
       "seed, "
       "repetitions, repeat, data, scenarios, vehicles, planners, sweep, range_finder, mapping, "
       "navigation, loop, "
       "budget, disturbances, declared_errors, limits, traces, acceptance; did you mean "
       "'planners'?)\n"},
      {"run open.yaml --planners RRT",
       "voronaut: no planner 'RRT' in suite 'open' (allowed: RRTConnect, PotentialField)\n"},
      {"run open.yaml --out open.yaml", "voronaut: open.yaml: is no folder\n"},
      {"summary missing", "voronaut: missing: no results here (no results.db)\n"},
      {"digest empty", "voronaut: empty: no results here (no results.db)\n"},
      {"replay empty abc", "voronaut: empty: no results here (no results.db)\n"},
      {"list colours",
       "voronaut: WHAT: no 'colours' (allowed: planners, vehicles, regulators, generators, "
       "scenarios, datasets, formats, suites, results, responses)" +
           help},
      {"list vehicles quadroto",
       "voronaut: no vehicle 'quadroto' (allowed: car, cart, ideal, jackal, quadrotor, "
       "quadrotor_props, unicycle; did you mean 'quadrotor'?)\n"},
      {"list suites smoke",
       "voronaut: list suites: takes no NAME (allowed after planners, vehicles, regulators, "
       "generators)\n"},
      {"show quadrotor -o a.svg",
       "voronaut: 'quadrotor' is a vehicle and has no worlds (`voronaut list vehicles quadrotor` "
       "prints its parameters)\n"},
      {"check missing.yaml", "voronaut: missing.yaml: no such file\n"},
  };
  for (const auto& [arguments, message] : cases) {
    const Answer answer = voronaut(arguments);
    EXPECT_EQ(answer.exit_code, 2) << arguments;
    EXPECT_EQ(answer.err, message) << arguments;
    EXPECT_EQ(answer.out, "") << arguments;
    EXPECT_FALSE(std::filesystem::exists(path("voronaut-results"))) << arguments;
  }
}

TEST_F(CommandLine, NamesTheSuitesThatShipWhenOneIsMisspelt) {
  const Answer answer = voronaut("run smokey");
  EXPECT_EQ(answer.exit_code, 2);
  EXPECT_THAT(answer.err, StartsWith("voronaut: no suite 'smokey' (allowed: ablation, "));
  EXPECT_THAT(answer.err, HasSubstr("did you mean 'smoke'?)"));
}

TEST_F(CommandLine, HelpsEverywhereAndKnowsItsVersion) {
  std::string commands = voronaut("--help").out;
  commands.erase(0, commands.find("Subcommands:\n") + 13);
  std::istringstream lines("\n" + commands.substr(0, commands.find("\n\n")));
  int count = 0;
  for (std::string line; std::getline(lines, line); ++count) {
    std::string command;
    std::istringstream(line) >> command;
    const Answer help = voronaut(command + " --help");
    EXPECT_EQ(help.exit_code, 0) << command;
    EXPECT_THAT(help.out, HasSubstr("Exit codes: 0 success;")) << command;
    const Answer version = voronaut(command + " --version");
    EXPECT_EQ(version.exit_code, 0) << command;
    EXPECT_THAT(version.out, StartsWith("voronaut 0.")) << command;
  }
  EXPECT_EQ(count, 21) << "the program itself and its commands";
}

TEST_F(CommandLine, ListsWhatThereIs) {
  EXPECT_THAT(voronaut("list planners").out, HasSubstr("RRTConnect"));
  EXPECT_THAT(voronaut("list vehicles").out, HasSubstr("quadrotor_props"));
  EXPECT_THAT(voronaut("list regulators").out, HasSubstr("pd_rate"));
  EXPECT_THAT(voronaut("list responses").out, HasSubstr("| corrected | se3 |"));
  EXPECT_THAT(voronaut("list scenarios").out, HasSubstr("paper-between"));
  EXPECT_THAT(voronaut("list suites").out, HasSubstr("smoke"));
}

TEST_F(CommandLine, ListsTheParametersOfOneALineEach) {
  EXPECT_THAT(voronaut("list planners RRTConnect").out,
              MatchesRegex("parameter .*\nrange  +number from 0 to 10000  +0\n"));
  const std::string jackal = voronaut("list vehicles jackal").out;
  EXPECT_THAT(jackal, HasSubstr("\nmax_speed_m_s          number from 0.01 to 100   m/s    2 "));
  EXPECT_THAT(jackal, HasSubstr("\nregulator arc_tracker, params\n"));
  EXPECT_THAT(
      voronaut("list generators forest").out,
      HasSubstr("\ncrossing               one of corners, sides                 corners  "));
  EXPECT_THAT(voronaut("list regulators lqr").out, HasSubstr("\nspeed_profile "));
}

// The names in the first column of a list.
std::vector<std::string> first_words(const std::string& text) {
  std::vector<std::string> words;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    words.push_back(line.substr(0, line.find(' ')));
  return words;
}

TEST_F(CommandLine, ChecksAndDrawsWhateverItLists) {
  for (const char* what : {"scenarios", "generators", "suites"}) {
    const auto names = first_words(voronaut(std::string("list ") + what).out);
    EXPECT_GT(names.size(), 5U) << what;
    for (const std::string& name : names) {
      const Answer check = voronaut("check " + name);
      const bool wants_data = check.err.find("VORONAUT_DATA") != std::string::npos;
      EXPECT_TRUE(check.exit_code == 0 || wants_data) << name << ": " << check.err;
      if (what == std::string("suites")) continue;
      const Answer drawn = voronaut("show " + name + " -o drawn.svg");
      EXPECT_EQ(drawn.exit_code, 0) << name << ": " << drawn.err;
      EXPECT_THAT(text_of(path("drawn.svg")), HasSubstr("<svg")) << name;
      std::filesystem::remove(path("drawn.svg"));
    }
  }
  EXPECT_EQ(voronaut("show smoke -o drawn.svg").exit_code, 0);
  EXPECT_THAT(text_of(path("drawn.svg")), HasSubstr(">grove<"));
  for (const std::string& name : first_words(voronaut("list datasets").out))
    EXPECT_THAT(voronaut("show " + name + " -o drawn.svg").err, HasSubstr("VORONAUT_DATA")) << name;
}

TEST_F(CommandLine, AnOptionOfSeveralValuesTakesNoWordThatIsMeantForSomethingElse) {
  write_open_suite();
  EXPECT_EQ(voronaut("run --planners RRTConnect,PotentialField open.yaml --jobs 1").exit_code, 0);
  EXPECT_EQ(voronaut("run open.yaml --planners RRTConnect --planners PotentialField").out,
            voronaut("run --planners RRTConnect --planners PotentialField open.yaml").out);
  const std::string results = "voronaut-results/open ";
  EXPECT_EQ(voronaut("status --planners RRTConnect " + results + "open.yaml").exit_code, 0);
  EXPECT_EQ(voronaut("plot --scenario open " + results + "-o a.svg").exit_code, 0);
  EXPECT_EQ(voronaut("compare --statistics path_ratio_median " + results + results).exit_code, 0);
  EXPECT_EQ(voronaut("run --set seed=2 open.yaml --out other").exit_code, 0);
}

TEST_F(CommandLine, ARunSaysWhatBecameOfItsCriteriaAndFailsIfOneIsBroken) {
  write_open_suite();
  const auto with_criteria = [&](const std::string& criteria) {
    write("judged.yaml", text_of(path("open.yaml")) + "acceptance: [" + criteria + "]\n");
    return voronaut("run judged.yaml --out " + std::to_string(criteria.size()));
  };
  const Answer holds = with_criteria("{collision_share_max: 0}");
  EXPECT_EQ(holds.exit_code, 0) << holds.err;
  EXPECT_THAT(holds.out,
              HasSubstr("acceptance:\n  holds: every trial: collisions <= 0 % (0 of 2)\n"));
  const Answer broken = with_criteria(
      "{planner: RRTConnect, clearance_smallest_m_min: 90}, {collision_share_max: 0}");
  EXPECT_EQ(broken.exit_code, 1);
  EXPECT_THAT(broken.out, HasSubstr("  broken: RRTConnect: "));
  EXPECT_THAT(broken.out, HasSubstr("  holds: every trial: "));
  const Answer part = voronaut("run judged.yaml --planners PotentialField --out part");
  EXPECT_EQ(part.exit_code, 0) << part.out;
  EXPECT_THAT(part.out, HasSubstr("  not judged: RRTConnect was left out\n"));
}

TEST_F(CommandLine, AFirstSuiteWithoutKeysReachesTheGoal) {
  write("first.yaml",
        "suite: first\nrepetitions: 5\nscenarios:\n"
        "  - {name: wood, generator: {name: forest, side_m: 12, density_per_m2: 0.12}}\n"
        "  - {name: flat, generator: {name: rooms}}\n"
        "vehicles: [quadrotor]\nplanners: [VoronoiRoadmap, RRTConnect]\n"
        "acceptance: [{goal_reached_share_min: 1}]\n");
  const Answer run = voronaut("run first.yaml");
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("  holds: every trial: goal reached >= 100 % (20 of 20)\n"));
}

TEST_F(CommandLine, BeginsWithAFolderThatRuns) {
  ASSERT_EQ(voronaut("init own").exit_code, 0);
  EXPECT_FALSE(std::filesystem::exists(path("own.part")));
  EXPECT_THAT(voronaut("check own/suite.yaml").out, HasSubstr("suite 'own', 3 scenarios"));
  const Answer run = voronaut("run own/suite.yaml --repetitions 1");
  EXPECT_EQ(run.exit_code, 0) << run.out << run.err;
  EXPECT_THAT(run.out, HasSubstr("  holds: VoronoiRoadmap: "));

  const std::string before = text_of(path("own/suite.yaml"));
  const Answer again = voronaut("init own");
  EXPECT_EQ(again.exit_code, 2);
  EXPECT_EQ(again.err, "voronaut: own: is not empty; name a new folder\n");
  EXPECT_EQ(text_of(path("own/suite.yaml")), before);
  EXPECT_EQ(voronaut("init own/suite.yaml").err, "voronaut: own/suite.yaml: is no folder\n");
  EXPECT_EQ(voronaut("init own/suite.yaml/below").exit_code, 2);

  const std::string full = "ulimit -f 1; cd '" + path("").string() + "' && '" + VORONAUT_PROGRAM +
                           "' init full 2>/dev/null";  // no file of more than 1 KiB: a full disk
  EXPECT_EQ(WEXITSTATUS(std::system(("bash -c \"" + full + "\"").c_str())), 1);
  EXPECT_FALSE(std::filesystem::exists(path("full")));
  EXPECT_FALSE(std::filesystem::exists(path("full.part")));

  std::filesystem::create_directory(path("there"));
  EXPECT_EQ(voronaut("init there/").exit_code, 0) << "an empty one";
  EXPECT_FALSE(std::filesystem::exists(path("there/.part")));
  EXPECT_EQ(voronaut("check there/suite.yaml").exit_code, 0);
}

TEST_F(CommandLine, ChecksSuitesAndScenarios) {
  write_open_suite();
  EXPECT_EQ(voronaut("check open.yaml").out,
            "open.yaml: suite 'open', 1 scenarios x 1 vehicles x 2 planners x 1 repetitions = 2 "
            "trials\n");
  write("world.yaml",
        "name: w\nworld: {}\nbounds: [[0, 0], [2, 2]]\nstart: [1, 1]\ngoal: [1.5, 1.5]\n");
  EXPECT_EQ(voronaut("check world.yaml").out, "world.yaml: scenario 'w'\n");
  EXPECT_THAT(voronaut("check smoke").out, StartsWith("smoke: suite 'smoke', "));
  EXPECT_THAT(voronaut("check smokey").err, HasSubstr("did you mean 'smoke'?)"));
}

TEST_F(CommandLine, DrawsScenariosAndForeignWorlds) {
  write("world.yaml",
        "name: w\nworld: {}\nbounds: [[0, 0], [2, 2]]\nstart: [1, 1]\ngoal: [1.5, 1.5]\n");
  write("cells.map", "type octile\nheight 2\nwidth 3\nmap\n...\n.@.\n");
  EXPECT_EQ(voronaut("show world.yaml -o w.svg").out, "w.svg\n");
  EXPECT_THAT(text_of(path("w.svg")), HasSubstr("<circle"));
  EXPECT_EQ(voronaut("show cells.map -o c.svg").out, "c.svg\n");
  EXPECT_THAT(text_of(path("c.svg")), ::testing::Not(HasSubstr("<circle")));  // no start
  write("cells", text_of(path("cells.map")));
  EXPECT_THAT(voronaut("show cells -o f.svg").err, HasSubstr("cells:1: not recognised as one of"));
  EXPECT_EQ(voronaut("show cells --format movingai -o f.svg").out, "f.svg\n");
  EXPECT_EQ(text_of(path("f.svg")).size(), text_of(path("c.svg")).size() - 4);  // its name
  EXPECT_EQ(voronaut("show cells --format moving -o f.svg").exit_code, 2);
  const Answer picture = voronaut("show cells.map -o c.gif");
  EXPECT_EQ(picture.exit_code, 2);
  EXPECT_THAT(picture.err, StartsWith("voronaut: -o 'c.gif': expected a name that ends in .svg"));
}

TEST_F(CommandLine, DrawsAPngOrSaysWhatItNeedsForOne) {
  write("cells.map", "type octile\nheight 2\nwidth 3\nmap\n...\n.@.\n");
  const Answer answer = voronaut("show cells.map -o c.png");
  if (!can_write_png()) {
    EXPECT_EQ(answer.exit_code, 2);
    EXPECT_THAT(answer.err, HasSubstr("-o 'c.png': this build has no librsvg"));
    EXPECT_FALSE(std::filesystem::exists(path("c.png")));
    return;
  }
  EXPECT_EQ(answer.exit_code, 0) << answer.err;
  EXPECT_THAT(text_of(path("c.png")), StartsWith("\x89PNG\r\n"));
}

TEST_F(CommandLine, FindsNothingWrongWithTheSuitesThatShip) {
  std::istringstream lines(voronaut("list suites").out);
  int suites = 0;
  for (std::string line; std::getline(lines, line); ++suites) {
    const std::string name = line.substr(0, line.find(' '));
    const Answer answer = voronaut("check " + name);
    if (answer.err.find("which is not known: give --data") != std::string::npos) continue;
    EXPECT_EQ(answer.exit_code, 0) << answer.err;
    EXPECT_THAT(answer.out, HasSubstr(" trials\n")) << name;
  }
  EXPECT_GE(suites, 6);
}

TEST_F(CommandLine, ExportsPlannersWithTheirParameters) {
  write("tuned.yaml",
        "suite: tuned\nkind: static\nscenarios: [{name: open, world: {circles: [[2, 3, 0.5]]}, "
        "bounds: [[-2, -2], [5, 5]], start: [0, 0], goal: [2, 1]}]\nvehicles: [ideal]\nplanners: "
        "[{name: RRTConnect, label: short, params: {range: 0.5}}]\n");
  ASSERT_EQ(voronaut("run tuned.yaml --out r").exit_code, 0);
  EXPECT_EQ(voronaut("export r --format plannerarena").exit_code, 0);
  ASSERT_EQ(voronaut("export r --format ompl-log").exit_code, 0);
  EXPECT_THAT(text_of(path("r/export.log")), HasSubstr("\nplanner = RRTConnect\nrange = 0.5\n"));
}

TEST_F(CommandLine, RunsASuiteAndAnswersQuestionsAboutIt) {
  write_open_suite();
  const Answer run = voronaut("run open.yaml --out r --jobs 2");
  ASSERT_EQ(run.exit_code, 0) << run.out << run.err;
  EXPECT_THAT(run.err, HasSubstr("2/2 trials"));
  EXPECT_THAT(run.out, HasSubstr("report: r/report.html\n"));
  for (const char* file : {"results.db", "results.csv", "report.html", "manifest.json"})
    EXPECT_GT(text_of(path("r") / file).size(), 100U) << file;
  EXPECT_THAT(text_of(path("r/manifest.json")), HasSubstr("\"ompl\": \"1."));
  EXPECT_THAT(voronaut("summary r").out, HasSubstr("RRTConnect"));
  EXPECT_EQ(voronaut("export r --format ompl-log").out, "r/export.log\n");
  EXPECT_THAT(text_of(path("r/export.log")), HasSubstr("Experiment open\n"));
  EXPECT_EQ(voronaut("export r --format csv -o all.csv").out, "all.csv\n");
  EXPECT_EQ(text_of(path("all.csv")), text_of(path("r/results.csv")));
  EXPECT_THAT(voronaut("summary r --json").out, StartsWith("{"));

  const std::string digest = voronaut("digest r").out;
  EXPECT_EQ(digest.size(), 65U);
  const Answer again = voronaut("run open.yaml --out r");
  EXPECT_THAT(again.out, HasSubstr("2 trials were there, 0 are new\n"));
  EXPECT_EQ(voronaut("run open.yaml --jobs 1").exit_code, 0);
  EXPECT_EQ(voronaut("digest voronaut-results/open").out, digest);

  const std::string csv = text_of(path("r/results.csv"));
  const std::string id = csv.substr(csv.find('\n') + 1, 64);
  const Answer replay = voronaut("replay r " + id.substr(0, 10));
  EXPECT_EQ(replay.exit_code, 0) << replay.out << replay.err;
  EXPECT_THAT(replay.out, StartsWith("trial " + id + " is the same, bit for bit"));

  EXPECT_EQ(voronaut("plot r " + id.substr(0, 10) + " -o figure.svg").exit_code, 0);
  EXPECT_THAT(text_of(path("figure.svg")), HasSubstr("<svg"));
  EXPECT_EQ(voronaut("plot r --planner RRTConnect --repetition 0 -o chosen.svg").exit_code, 0);
  EXPECT_THAT(text_of(path("chosen.svg")), HasSubstr(">RRTConnect<"));
  for (const auto& [arguments, error] : std::map<std::string, std::string>{
           {"--planner RRTConect", "--planner 'RRTConect': no trial has it"},
           {"--repetition 7", "r: no trial of this choice has a trace"},
           {"", "plot: either trial ids, or a choice"},
           {id + " --repetition 0", "plot: either trial ids, or a choice"}}) {
    const Answer wrong = voronaut("plot r " + arguments + " -o wrong.svg");
    EXPECT_EQ(wrong.exit_code, 2) << arguments;
    EXPECT_THAT(wrong.err, HasSubstr(error));
  }
  EXPECT_FALSE(std::filesystem::exists(path("wrong.svg")));

  EXPECT_THAT(voronaut("evidence r").out, HasSubstr("1 suites, 2 flights, 0 collisions"));
  std::filesystem::remove(path("r/report.html"));
  EXPECT_EQ(voronaut("report r").out, "r/report.html\n");
  EXPECT_TRUE(std::filesystem::exists(path("r/report.html")));
  EXPECT_THAT(text_of(path("r/report.html")), HasSubstr("\"mapping\":null"));
  write("r/micro.json", R"({"benchmarks": [{"name": "mapping/forest/voronaut/rays:181"}]})");
  EXPECT_EQ(voronaut("report r").exit_code, 0);
  EXPECT_THAT(text_of(path("r/report.html")), HasSubstr("mapping/forest/voronaut/rays:181"));
  write("r/micro.json", "{}");
  const Answer no_micro = voronaut("report r");
  EXPECT_EQ(no_micro.exit_code, 2);
  EXPECT_THAT(no_micro.err, HasSubstr("micro.json: no list 'benchmarks'"));
  EXPECT_EQ(voronaut("report r/micro.json").exit_code, 2);
  EXPECT_FALSE(std::filesystem::exists(path("r/micro.html"))) << "no half a page";
  std::filesystem::remove(path("r/micro.json"));

  EXPECT_EQ(voronaut("report r -o page.html --compare voronaut-results/open").out, "page.html\n");
  EXPECT_THAT(text_of(path("page.html")), HasSubstr("\"title\":\"voronaut-results/open\""));
  EXPECT_THAT(text_of(path("page.html")), HasSubstr("\"folder\":\"r\""));
  EXPECT_EQ(voronaut("report r --format csv").out, csv);
  EXPECT_THAT(voronaut("report r --format md").out, HasSubstr("| RRTConnect"));
  EXPECT_EQ(voronaut("report r --format md -o r.md --compare voronaut-results/open").out, "r.md\n");
  EXPECT_THAT(text_of(path("r.md")),
              HasSubstr("0 of 2 trials flew differently, 0 end differently"));
  for (const char* wrong :
       {"report r --format pdf", "report r --compare nowhere", "report r --format csv --compare r",
        "report r --published nowhere", "report r --format csv --published r"}) {
    const Answer refused = voronaut(wrong);
    EXPECT_EQ(refused.exit_code, 2) << wrong;
    EXPECT_EQ(std::count(refused.err.begin(), refused.err.end(), '\n'), 1) << refused.err;
  }
}

TEST_F(CommandLine, ComparesRunsAndPlannersAndRefusesUnlikeSuites) {
  write_open_suite();
  ASSERT_EQ(voronaut("run open.yaml --out a").exit_code, 0);
  ASSERT_EQ(voronaut("run open.yaml --out b").exit_code, 0);
  const Answer same = voronaut("compare a b");
  EXPECT_EQ(same.exit_code, 0) << same.err;
  EXPECT_EQ(same.out, "identical: all 2 trials flew alike\n");
  EXPECT_THAT(voronaut("compare a b --format json").out, HasSubstr("\"changed\":0"));

  const Answer planners = voronaut("compare a --planners RRTConnect,PotentialField");
  EXPECT_EQ(planners.exit_code, 0) << "one pair says nothing: " << planners.err;
  EXPECT_THAT(planners.out, HasSubstr("against RRTConnect: 1 of 1 trials flew differently"));
  EXPECT_THAT(planners.out, HasSubstr("McNemar, exact"));

  write("open.yaml", text_of(path("open.yaml")) + "navigation: {off_path_m: 3}\n");
  ASSERT_EQ(voronaut("run open.yaml --out c").exit_code, 0);
  const Answer unlike = voronaut("compare a c");
  EXPECT_EQ(unlike.exit_code, 2);
  EXPECT_THAT(unlike.err, HasSubstr("not to be compared with a: navigation.off_path_m: "));
  EXPECT_EQ(voronaut("compare a c --across navigation.off_path_m").exit_code, 0);
  for (const char* wrong :
       {"compare a", "compare a b --planners RRTConnect,PotentialField", "compare a nowhere",
        "compare a --planners RRTConnect,RRT", "compare a b --statistics success"})
    EXPECT_EQ(voronaut(wrong).exit_code, 2) << wrong;
  EXPECT_THAT(voronaut("compare a --planners RRTConnect,RRT").err,
              HasSubstr("--planners: no trial of 'RRT' (allowed: PotentialField, RRTConnect"));
}

TEST_F(CommandLine, ComparesNoTrialsOfTwoWorlds) {
  write_open_suite();
  ASSERT_EQ(voronaut("run open.yaml --out a").exit_code, 0);
  std::string moved = text_of(path("open.yaml"));
  moved.replace(moved.find("[[2, 3, 0.5]]"), 13, "[[2, 3, 0.4]]");
  write("open.yaml", moved);
  ASSERT_EQ(voronaut("run open.yaml --out b").exit_code, 0);
  EXPECT_THAT(voronaut("report b --compare a").err, HasSubstr("has another world"));
  const Answer other = voronaut("compare a b --across scenarios");
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_EQ(other.err,
            "voronaut: b: not to be compared with a: scenario 'open', repetition 0, has another "
            "world\n");
}

TEST_F(CommandLine, KeepsResultsOfAnotherVersionOfTheSuiteApart) {
  write_open_suite();
  ASSERT_EQ(voronaut("run open.yaml --planners RRTConnect").exit_code, 0);
  ASSERT_EQ(voronaut("run open.yaml --planners RRTConnect --out r").exit_code, 0);
  write("open.yaml", text_of(path("open.yaml")) + "seed: 2\n");
  const Answer refused = voronaut("run open.yaml --planners RRTConnect --out r");
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_EQ(refused.err,
            "voronaut: r: holds results of another version of this suite; give another --out or "
            "remove it\n");
  const Answer moved = voronaut("run open.yaml --planners RRTConnect");
  EXPECT_EQ(moved.exit_code, 0);
  EXPECT_THAT(moved.err, HasSubstr("results of another version of this suite moved to "
                                   "voronaut-results/open.1\n"));
  EXPECT_TRUE(std::filesystem::exists(path("voronaut-results/open.1/results.db")));
}

}  // namespace
}  // namespace voronaut
