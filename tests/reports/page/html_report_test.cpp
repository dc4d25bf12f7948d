#include "voronaut/reports/page/html_report.h"

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "voronaut/reports/page/report_data.h"
#include "voronaut/reports/page/web_assets.h"
#include "voronaut/reports/store/atomic_file.h"
#include "voronaut/tests/reports/synthetic_run.h"

namespace voronaut {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++n;
  }
  return n;
}

std::string between(const std::string& text, const std::string& open, const std::string& close) {
  const auto start = text.find(open) + open.size();
  return text.substr(start, text.find(close, start) - start);
}

TEST(ReportData, MatchesTheGoldenText) {
  RunRecord record = synthetic::make_record("t1");
  record.planning_time_us_mean = kAbsent;  // measured: masked
  ReportInput input{.title = "golden",
                    .manifest_json = R"({"version":"0.1.0"})",
                    .records = {record},
                    .stored_trials = 1,
                    .summary = {},
                    .worlds = {},
                    .trace_blobs = {{"t1", "\xff\xfe"}},
                    .stored_traces = 3};
  auto data = nlohmann::json::parse(report_data_json(input));
  // The tables that the page reads, one entry for each line of ours.
  EXPECT_EQ(data["outcomes"].size(), kOutcomes.size());
  EXPECT_EQ(data["columns"].size(), record_columns().size());
  EXPECT_EQ(data["summary"]["statistics"].size(), statistics().size());
  EXPECT_EQ(data["outcomes"][1]["name"], "collision");
  EXPECT_EQ(data["columns"]["speed_mean_m_s"]["unit"], "m/s");
  data.erase("outcomes");
  data.erase("columns");
  data["summary"].erase("statistics");
  EXPECT_EQ(
      data.dump(),
      R"({"comparison":null,"folder":"DIR","manifest":{"version":"0.1.0"},"mapping":null,"published":null,"stored_traces":3,"stored_trials":1,)"
      R"("summary":{"groups":[],"pairings":[],"totals":[]},"title":"golden","traces":{"t1":"//4="},)"
      R"("trials":{"barn_pace":[null],"barn_score":[null],"barn_time_s":[null],"body_clearance_smallest_m":[null],"budget_stops":{"index":[0],"texts":["0"]},"clearance_mean_m":[null],)"
      R"("clearance_smallest_m":[0.51],"cpu_time_s":[null],"duration_s":[0.3],"end_x_m":[null],)"
      R"("end_y_m":[null],"energy_j":[null],"free_share":[null],"map_obstacles":{"index":[0],"texts":["0"]},"map_points":{"index":[0],)"
      R"("texts":["0"]},"mapping_time_us_mean":[null],"mapping_time_us_p99":[null],)"
      R"("memory_max_mb":[null],"modes":{"index":[0],"texts":["none left"]},"narrowest_passage_m":[null],"outcome":{"index":[0],)"
      R"("texts":["goal_reached"]},"overshoot_m":[null],"path_length_m":[15.25],"path_ratio":[1.073944],)"
      R"("planner":{"index":[0],"texts":["repaired"]},"planning_time_us_mean":[null],)"
      R"("planning_time_us_p99":[null],"reason":{"index":[0],"texts":["at rest 0.1 m from the goal"]},)"
      R"("regulator":{"index":[0],"texts":["pd_rate"]},"repetition":{"index":[0],"texts":["2"]},)"
      R"("replans":{"index":[0],"texts":["17"]},"scenario":{"index":[0],"texts":["between"]},)"
      R"("scenario_group":{"index":[0],"texts":["paper"]},"seed":{"index":[0],)"
      R"("texts":["-9000000000000000001"]},"settling_s":[null],"shortest_at_clearance_m":[null],)"
      R"("shortest_length_m":[14.2],"speed_max_m_s":[null],"speed_mean_m_s":[null],"spl":[0.9311475],)"
      R"("state_checks":{"index":[0],"texts":["0"]},"step_time_us_mean":[null],)"
      R"("step_time_us_p99":[null],"stopping_distance_m":[null],"stops_first_solution":{"index":[0],"texts":["0"]},)"
      R"("stops_iterations":{"index":[0],"texts":["0"]},)"
      R"("stops_ptc_evaluations":{"index":[0],"texts":["0"]},)"
      R"("stops_state_checks":{"index":[0],"texts":["0"]},)"
      R"("stops_wall_clock":{"index":[0],"texts":["0"]},"suite":{"index":[0],"texts":["synthetic"]},"tracking_error_max_m":[null],"tracking_error_rms_m":[null],"trial_id":{"index":[0],)"
      R"("texts":["t1"]},"vehicle":{"index":[0],"texts":["quadrotor"]},"world_id":{"index":[0],)"
      R"("texts":["w0"]}},"worlds":[]})");
}

TEST(ReportData, AManifestThatIsNoJsonIsShownAsText) {
  ReportInput input;
  input.manifest_json = "not { json";
  EXPECT_EQ(nlohmann::json::parse(report_data_json(input))["manifest"], "not { json");
}

TEST(ReportData, NothingInADataElementCanEndIt) {
  EXPECT_EQ(escaped_for_script("a</script><!--\xe2\x80\xa8\xe2\x80\xa9"),
            "a\\u003c/script>\\u003c!--\\u2028\\u2029");
  EXPECT_EQ(escaped_for_html("<a href=\"x\">&'"), "&lt;a href=&quot;x&quot;&gt;&amp;&#39;");
}

TEST(HtmlReport, IsOneDocumentWithThreeScriptsAndStyleAtMost) {
  const auto run = synthetic::make_run();
  ReportInput input;
  input.title = "</title><script>alert(1)</script>";
  input.records = run.records;
  input.records[0].planner = "</script><script>alert(2)</script>";
  input.summary = summarise(input.records);
  input.worlds = run.worlds;
  const std::string html = html_report(input);
  EXPECT_EQ(count(html, "<script"), 2U);
  EXPECT_EQ(count(html, "</script>"), 2U);
  EXPECT_EQ(count(html, "<style>"), 1U);
  EXPECT_THAT(html, HasSubstr("<title>&lt;/title&gt;&lt;script&gt;alert(1)"));
  EXPECT_THAT(html, Not(HasSubstr("{{")));
  EXPECT_THAT(html, Not(HasSubstr("src=")));
  const std::string data =
      between(html, R"(<script type="application/json" id="report-data">)", "</script>");
  EXPECT_THAT(data, Not(HasSubstr("<")));
  EXPECT_EQ(nlohmann::json::parse(data)["title"], input.title);
}

TEST(HtmlReport, ItsPolicyAllowsItsOwnScriptAndStyleOnly) {
  const std::string html = html_report({});
  const std::string policy = between(html, "Content-Security-Policy\" content=\"", "\"");
  EXPECT_EQ(policy, "default-src 'none'; script-src '" + std::string(web_assets().script_hash) +
                        "'; style-src '" + std::string(web_assets().style_hash) +
                        "'; base-uri 'none'; form-action 'none'");
  EXPECT_THAT(policy, Not(HasSubstr("unsafe")));
  EXPECT_EQ(web_assets().script_hash.size(), std::string("sha256-").size() + 44);
}

TEST(HtmlReport, ReplaysStartWithOneWorldPerScenarioAndAllItsPlanners) {
  synthetic::RunConfig config;
  config.traced_repetitions = 0;
  const auto run = synthetic::make_run(config);
  const auto order = order_of_replays(run.records);
  ASSERT_EQ(order.size(), run.records.size());
  std::map<std::string, const RunRecord*> by_id;
  for (const RunRecord& r : run.records) {
    by_id[r.trial_id] = &r;
  }
  std::set<std::pair<std::string, std::string>> first;
  const std::size_t scenes = 4 * config.planners.size();
  for (std::size_t i = 0; i < scenes; ++i) {
    EXPECT_EQ(by_id[order[i]]->repetition, 0);
    first.emplace(by_id[order[i]]->scenario, by_id[order[i]]->planner);
  }
  EXPECT_EQ(first.size(), scenes);
  EXPECT_EQ(std::set(order.begin(), order.end()).size(), order.size());
}

TEST(HtmlReport, ReplaysOfARunTooLargeAreBestMedianWorstAndEveryWayOfFailing) {
  std::vector<RunRecord> records;
  for (int i = 0; i < 100; ++i) {
    RunRecord& r = records.emplace_back(synthetic::make_record("t" + std::to_string(100 + i)));
    r.repetition = i;
    r.world_id = "w" + std::to_string(i);
    r.path_ratio = 1.0 + ((37 * i) % 100) / 100.0;  // each value once
    if (i == 50 || i == 60 || i == 70) {
      r.outcome = i == 60 ? Outcome::timeout : Outcome::collision;
    }
  }
  std::vector<double> reached;
  for (const RunRecord& r : records) {
    if (r.outcome == Outcome::goal_reached) reached.push_back(r.path_ratio);
  }
  std::sort(reached.begin(), reached.end());
  const auto order = order_of_replays(records);
  ASSERT_EQ(order.size(), records.size());
  EXPECT_EQ(order[0], "t100");  // the first world
  std::vector<double> ratios;
  std::vector<Outcome> failures;
  for (std::size_t i = 1; i < 5; ++i) {
    for (const RunRecord& r : records) {
      if (r.trial_id == order[i] && r.outcome == Outcome::goal_reached)
        ratios.push_back(r.path_ratio);
      if (r.trial_id == order[i] && r.outcome != Outcome::goal_reached)
        failures.push_back(r.outcome);
    }
  }
  // t100 has ratio 1.0, the best: two successes are left, and one trial of each way of failing.
  EXPECT_THAT(ratios, ::testing::IsSupersetOf({reached[reached.size() / 2], reached.back()}));
  EXPECT_THAT(failures, ::testing::UnorderedElementsAre(Outcome::collision, Outcome::timeout));
}

class ReportFile : public ::testing::Test {
 protected:
  ReportFile()
      : folder_(std::filesystem::temp_directory_path() /
                ("voronaut-report-" + std::to_string(getpid()))) {
    std::filesystem::create_directories(folder_);
  }
  ~ReportFile() override { std::filesystem::remove_all(folder_); }
  std::filesystem::path folder_;
};

TEST_F(ReportFile, KeepsReplaysWithinTheirBudgetAndSaysHowManyThereWere) {
  const auto run = synthetic::make_run();
  ResultStore store = ResultStore::create(folder_ / "results.db");
  for (const TraceWorld& world : run.worlds) {
    store.insert_world(world);
  }
  std::size_t next = 0;
  for (const RunRecord& record : run.records) {
    const bool traced = next < run.traces.size() && run.traces[next].trial_id == record.trial_id;
    store.insert(record, traced ? std::optional(run.traces[next++]) : std::nullopt);
  }
  const ReportInput all = read_report_input(store, "all", "{}");
  EXPECT_EQ(all.trace_blobs.size(), run.traces.size());
  EXPECT_EQ(all.records.size(), run.records.size());
  EXPECT_EQ(all.worlds.size(), run.worlds.size());
  const ReportInput some = read_report_input(store, "some", "{}", 40'000);
  EXPECT_EQ(some.stored_traces, run.traces.size());
  EXPECT_GT(some.trace_blobs.size(), 0U);
  EXPECT_LT(some.trace_blobs.size(), run.traces.size());
  std::size_t bytes = 0;
  for (const auto& [id, blob] : some.trace_blobs) {
    bytes += (blob.size() + 2) / 3 * 4;
  }
  EXPECT_LE(bytes, 40'000U);
}

TEST_F(ReportFile, ReplacesAnOlderOneAndLeavesNoTemporaryBehind) {
  ReportInput input;
  for (const char* title : {"one", "two"}) {
    input.title = title;
    write_html_report(input, folder_ / "report.html");
  }
  std::ifstream in(folder_ / "report.html");
  const std::string text(std::istreambuf_iterator<char>(in), {});
  EXPECT_THAT(text, HasSubstr("<title>two</title>"));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 1);
}

TEST_F(ReportFile, SaysWhichFileCannotBeWritten) {
  try {
    write_file_atomically(folder_ / "missing" / "report.html", "x");
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(error.what(), (folder_ / "missing" / "report.html").string() +
                                ": cannot write: No such file or directory");
  }
}

}  // namespace
}  // namespace voronaut
