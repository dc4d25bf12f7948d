#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <set>

#include <gmock/gmock.h>
#include <sqlite3.h>

#include "voronaut/reports/trace/trace_json.h"
#include "voronaut/tests/benchmarks/small_suite.h"
#include "voronaut/tests/reports/page/report_in_browser.h"

// Reports of suites that are really flown: what a browser shows is held against the rows that
// SQLite gives for plain questions, not against anything of ours that reads the database.
namespace voronaut {
namespace {

using ::testing::HasSubstr;

using Row = std::vector<std::string>;

std::vector<Row> ask(const std::filesystem::path& database, const std::string& sql) {
  sqlite3* handle = nullptr;
  EXPECT_EQ(sqlite3_open_v2(database.c_str(), &handle, SQLITE_OPEN_READONLY, nullptr), SQLITE_OK);
  sqlite3_stmt* statement = nullptr;
  EXPECT_EQ(sqlite3_prepare_v2(handle, sql.c_str(), -1, &statement, nullptr), SQLITE_OK)
      << sqlite3_errmsg(handle);
  std::vector<Row> rows;
  while (sqlite3_step(statement) == SQLITE_ROW) {
    Row& row = rows.emplace_back();
    for (int i = 0; i < sqlite3_column_count(statement); ++i) {
      const auto* bytes = static_cast<const char*>(sqlite3_column_blob(statement, i));
      row.emplace_back(bytes == nullptr ? "" : bytes,
                       static_cast<std::size_t>(sqlite3_column_bytes(statement, i)));
    }
  }
  sqlite3_finalize(statement);
  sqlite3_close(handle);
  return rows;
}

std::string share(double part, double whole) { return fixed(100 * part / whole, 1); }

class RealRun : public ReportInBrowser {
 protected:
  // Flies a suite and returns its report.
  std::filesystem::path fly(const std::string& suite, const std::string& text,
                            const std::string& report_options = "") {
    std::ofstream(folder_.path() / (suite + ".yaml")) << text;
    say("run " + suite + ".yaml --jobs 2 --out " + suite);
    std::ofstream(folder_.path() / suite / "micro.json")
        << R"({"context":{},"benchmarks":[{"name":"mapping/forest/voronaut/rays:181",)"
        << R"("cpu_time":2.5,"time_unit":"us"}]})";
    say("report " + suite + report_options);
    const auto kept = pages_folder() / (suite + ".html");
    std::filesystem::copy_file(folder_.path() / suite / "report.html", kept,
                               std::filesystem::copy_options::overwrite_existing);
    return kept;
  }
  void say(const std::string& arguments) const {
    const std::string command = "cd '" + folder_.path().string() + "' && '" + VORONAUT_PROGRAM +
                                "' " + arguments + " >said.txt 2>&1";
    if (std::system(command.c_str()) == 0) return;
    std::ifstream said(folder_.path() / "said.txt");
    ADD_FAILURE() << arguments << ":\n" << std::string(std::istreambuf_iterator<char>(said), {});
  }
  std::filesystem::path database(const std::string& suite) const {
    return folder_.path() / suite / "results.db";
  }
  std::string dataset(const std::string& selector, const std::string& key) {
    return session_->evaluate("document.querySelector('" + selector + "').dataset." + key);
  }

  TemporaryFolder folder_;
};

// Something of everything: the paper's figure, a sweep, failures, the governor, a roadmap.
std::string suite_text(const std::string& name, int state_checks) {
  std::string text = "suite: " + name + "\nseed: 1\nrepetitions: 3\nrepeat: random\nscenarios:\n";
  for (const char* scene : {"between", "left", "right", "near-goal", "even"}) {
    text += "  - {file: '" + std::string(VORONAUT_SOURCE_DIR) + "/benchmarks/scenarios/paper-" +
            scene + ".yaml'}\n";
  }
  for (const char* density : {"0.05", "0.10", "0.20"}) {
    text += "  - {name: forest-" + std::string(density) + ", group: forest-" + density +
            ", generator: {name: forest, side_m: 10, density_per_m2: " + density + "}}\n";
  }
  return text +
         "vehicles: [quadrotor]\nplanners:\n"
         "  - {name: ReactiveVoronoi, label: repaired, params: {preset: repaired}}\n"
         "  - VoronoiRoadmap\n  - RRTConnect\n  - PotentialField\n"
         "navigation: {yaw_policy: path, governor: true, look_around: true, recovery: true}\n"
         "budget: {state_checks: " +
         std::to_string(state_checks) + ", ptc_evaluations: 8000, stop: first}\ntraces: all\n";
}

TEST_F(RealRun, EveryPageShowsWhatTheDatabaseHolds) {
  ASSERT_NO_FATAL_FAILURE(fly("before", suite_text("before", 60)));
  const auto page = fly("now", suite_text("now", 2000), " --compare before");
  const auto results = database("now");

  open(page);
  const Row all =
      ask(results, "select count(*), sum(outcome = 'goal_reached') from trials").front();
  EXPECT_THAT(text("header"), HasSubstr("trials " + all[0]));
  EXPECT_THAT(text("header"), HasSubstr("reached the goal " + all[1]));
  const std::string overview = rows("overview");
  for (const Row& row :
       ask(results,
           "select scenario_group, planner, count(*), sum(outcome = 'goal_reached'), "
           "sum(outcome = 'collision'), min(clearance_smallest_m) from trials group by 1, 2")) {
    const auto begin = overview.find(row[1] + " | " + row[0] + " | " + row[2] + " | ");
    ASSERT_NE(begin, std::string::npos) << row[0] << ", " << row[1];
    const std::string shown = overview.substr(begin, overview.find('\n', begin) - begin);
    EXPECT_THAT(shown, HasSubstr(" | " + share(std::stod(row[3]), std::stod(row[2])) + " % " +
                                 row[3] + "/" + row[2] + ", 95 % ["));
    EXPECT_THAT(shown, HasSubstr(" % " + row[4] + "/" + row[2] + ", 95 % ["));
    EXPECT_THAT(shown, HasSubstr(" | " + fixed(std::stod(row[5]), 3)));
  }

  go_to("distributions");
  for (const Row& row : ask(results,
                            "select planner, avg(outcome = 'goal_reached'), "
                            "count(clearance_smallest_m) from trials group by 1")) {
    const std::string of = " [data-planner=\"" + row[0] + "\"]";
    EXPECT_NEAR(std::stod(dataset("#duration_s" + of, "plateau")), std::stod(row[1]), 1e-9);
    EXPECT_EQ(count("#clearance_smallest_m" + of + " circle"), row[2]) << row[0];
  }

  go_to("sweeps");
  for (const Row& row : ask(results,
                            "select planner, scenario_group, avg(outcome = 'goal_reached')"
                            " from trials where scenario_group like 'forest%' group by 1, 2")) {
    EXPECT_NEAR(
        std::stod(session_->evaluate(
            "[...document.querySelectorAll('#sweep-0-goal_reached_share [data-planner=\"" + row[0] +
            "\"] .point')].find(p => p.dataset.tip.includes('" + row[1] + "')).dataset.value")),
        std::stod(row[2]), 1e-9);
  }

  go_to("figure9");
  EXPECT_EQ(count("#page-figure9 tbody tr"),
            ask(results,
                "select count(*) from trials where scenario like 'paper%' and "
                "repetition = 0")
                .front()[0]);

  go_to("failures");
  const auto failed = ask(results,
                          "select trial_id, planner, reason, duration_s from trials "
                          "where outcome <> 'goal_reached'");
  ASSERT_FALSE(failed.empty());
  EXPECT_THAT(text("#page-failures"),
              HasSubstr(std::to_string(failed.size()) + " trials did not reach the goal"));
  for (const Row& row : failed) {
    const std::string link = "#page-failures a.thumbnail[href^=\"#replay=" + row[0] + "\"]";
    EXPECT_EQ(count(link), "1") << row[1];
    EXPECT_THAT(text("#page-failures"), HasSubstr(row[2]));
  }
  // One click from the replay, a little before it went wrong.
  const Row& bad = failed.front();
  session_->evaluate("document.querySelector('#page-failures a.thumbnail[href^=\"#replay=" +
                     bad[0] + "\"]').click()");
  ASSERT_TRUE(session_->wait_for("document.querySelector('.panels [data-trial=\"" + bad[0] +
                                 "\"]') !== null"));
  EXPECT_THAT(text("#replay-clock"),
              HasSubstr(decimal(std::max(0.0, std::stod(bad[3]) - 2), 2) + " of "));

  go_to("comparison");
  EXPECT_THAT(text("#page-comparison"), HasSubstr("There: before"));
  std::map<std::string, std::string> before;
  const std::string outcomes =
      "select planner || scenario || repetition, outcome from trials order by 1";
  for (const Row& row : ask(database("before"), outcomes)) before[row[0]] = row[1];
  int changed = 0;
  for (const Row& row : ask(results, outcomes)) changed += before.at(row[0]) != row[1] ? 1 : 0;
  EXPECT_THAT(text("#page-comparison"),
              HasSubstr(std::to_string(changed) + " trials end differently"));

  go_to("provenance");
  EXPECT_THAT(text("#page-provenance"), HasSubstr("voronaut run now.yaml"));
  EXPECT_THAT(text("#page-provenance"), HasSubstr("density_per_m2: 0.05"));
  expect_quiet();

  for (const auto& [suffix, view] :
       std::map<std::string, browser::View>{{"", {1280, 1400}},
                                            {"-dark", {1280, 1400, true}},
                                            {"-phone", {390, 1400}},
                                            {"-print", {1047, 718, false, true}}}) {
    open(page, "", view);
    for (const char* name : {"overview", "distributions", "sweeps", "scenes", "figure9", "replay",
                             "failures", "comparison", "mapping", "provenance"}) {
      go_to(name);
      if (std::string_view(name) == "replay") {
        session_->evaluate(
            "(() => { const s = document.querySelector('.clock input[type=range]');"
            " s.value = s.max / 2; s.dispatchEvent(new Event('input')); })()");
      }
      picture("real-" + std::string(name) + suffix + ".png");
    }
    expect_quiet();
  }
}

TEST_F(RealRun, TheReplayShowsTheStoredStateOfEachMoment) {
  const auto page = fly("replayed",
                        "suite: replayed\nseed: 2\nscenarios:\n"
                        "  - {name: rooms, generator: {name: rooms}}\nvehicles: [quadrotor]\n"
                        "planners: [VoronoiRoadmap, RRTConnect, PotentialField]\n"
                        "navigation: {yaw_policy: path, governor: true, look_around: true}\n"
                        "traces: all\n");
  const auto stored =
      ask(database("replayed"), "select trial_id, data from traces join trials using (trial_id)");
  ASSERT_EQ(stored.size(), 3U);
  std::string ids;
  std::vector<Trace> traces;
  for (const Row& row : stored) {
    ids += (ids.empty() ? "" : ",") + row[0];
    traces.push_back(decompress_trace(row[1]));
  }
  for (const double at_s : {0.0, 3.02, 8.5, 11.111}) {
    open(page, "#replay=" + ids + "&t=" + decimal(at_s, 2));
    ASSERT_TRUE(session_->wait_for("document.querySelectorAll('.panels figure').length === 3"));
    for (const Trace& trace : traces) {
      // The last moment that had been recorded by then.
      const TraceFrame* frame = &trace.frames.front();
      for (const TraceFrame& f : trace.frames) frame = f.t_s <= at_s + 1e-9 ? &f : frame;
      const std::string panel = text(".panels [data-trial=\"" + trace.trial_id + "\"]");
      EXPECT_THAT(panel, HasSubstr("position" + decimal(frame->x_m, 2) + ", " +
                                   decimal(frame->y_m, 2) + " m"));
      EXPECT_THAT(panel, HasSubstr("speed" + decimal(std::hypot(frame->vx_m_s, frame->vy_m_s), 2)));
      EXPECT_THAT(panel, HasSubstr("points known" + std::to_string(frame->known_points)));
      EXPECT_THAT(panel, HasSubstr("governor" + decimal(100 * frame->speed_scale, 0) + " %"));
    }
    expect_quiet();
  }
}

// Scenarios, groups and vehicles are named of letters and digits; a planner may be called anything.
TEST_F(RealRun, HostileNamesAreTextOnEveryPage) {
  const std::vector<std::string> labels{
      "</script><script>document.title='broken'</script>",
      "<img src=x onerror=alert(1)><!-- \"quotes\" & 'more' \\ {{data}} %s ${x}",
      "\u202e\u0645\u062e\u0637\u0637 RTL", std::string(200, 'w')};
  std::string text_of_suite =
      "suite: hostile\nseed: 1\nscenarios:\n"
      "  - {name: trap, generator: {name: u_trap}}\n"
      "vehicles: [ideal]\ntraces: all\nplanners:\n";
  for (const std::string& label : labels) {
    std::string quoted = label;
    for (std::size_t at = 0; (at = quoted.find('\'', at)) != std::string::npos; at += 2) {
      quoted.replace(at, 1, "''");
    }
    text_of_suite += "  - {name: PotentialField, label: '" + quoted + "'}\n";
  }
  open(fly("hostile", text_of_suite));
  EXPECT_EQ(ask(database("hostile"), "select planner from trials").size(), labels.size());
  for (const std::string& label : labels) EXPECT_THAT(text("#page-overview"), HasSubstr(label));
  for (const char* name :
       {"overview", "distributions", "scenes", "replay", "failures", "mapping", "provenance"}) {
    go_to(name);
    EXPECT_EQ(count("img, b > b, script:not([type]) + *"), "0") << name;
    picture("hostile-" + std::string(name) + ".png");
  }
  EXPECT_EQ(session_->evaluate("document.title"), "hostile");
  expect_quiet();
}

}  // namespace
}  // namespace voronaut
