#include "browser.h"

#include <cstdio>
#include <filesystem>
#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "synthetic_run.h"
#include "voronaut/reports/html_report.h"
#include "voronaut/reports/trace_json.h"

namespace voronaut {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

// Rendered reports and their pictures stay in the build folder, to be looked at.
std::filesystem::path folder() {
  const auto path = std::filesystem::path(VORONAUT_BINARY_DIR) / "report-pages";
  std::filesystem::create_directories(path);
  return path;
}

ReportInput input_of(const synthetic::Run& run, const std::string& title) {
  ReportInput input;
  input.title = title;
  input.manifest_json =
      R"({"version":"0.1.0","git_commit":"0123abcd","compiler":"GNU 12.2.0","seed":1,)"
      R"("machine":{"cpu":"made up"},"command":"voronaut run synthetic.yaml --seed 1",)"
      R"("suite_file":"scenarios:\n  - paper\n  - forest\n"})";
  input.records = run.records;
  input.summary = summarise(run.records);
  input.worlds = run.worlds;
  for (const Trace& trace : run.traces) {
    input.trace_blobs[trace.trial_id] = compress_trace(trace);
  }
  return input;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++n;
  }
  return n;
}

// Each traced trial is drawn in its scene, a failed one once more in the list of failures.
std::size_t tracks_of(const synthetic::Run& run) {
  std::size_t n = 0;
  for (const Trace& trace : run.traces) {
    for (const RunRecord& record : run.records) {
      if (record.trial_id == trace.trial_id) {
        n += record.outcome == Outcome::goal_reached ? 1 : 2;
      }
    }
  }
  return n;
}

class Browser : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!browser::find_chromium()) {
      GTEST_SKIP() << "chromium is not installed: the report was not opened in a browser";
    }
  }
};

TEST_F(Browser, ShowsTheNumbersOfTheRecords) {
  synthetic::RunConfig config;
  config.repetitions = 20;
  const auto run = synthetic::make_run(config);
  const auto file = folder() / "synthetic.html";
  const ReportInput input = input_of(run, "A synthetic suite");
  write_html_report(input, file);
  const auto page = browser::load(file, "", 4000);
  EXPECT_EQ(page.console, "");
  EXPECT_THAT(page.dom, HasSubstr("data-ready=\"yes\""));
  EXPECT_THAT(page.dom,
              HasSubstr("trials <b><bdi>" + std::to_string(run.records.size()) + "</bdi>"));
  for (const PlannerSummary& s : input.summary.groups) {
    EXPECT_THAT(page.dom, HasSubstr(">" + std::to_string(s.success.successes) + "/" +
                                    std::to_string(s.success.n) + ", 95 %"));
    char median[32];
    std::snprintf(median, sizeof median, "<span>%.3f<small>", s.path_ratio_median.value);
    EXPECT_THAT(page.dom, HasSubstr(median));
  }
  EXPECT_EQ(count(page.dom, "<figure data-scene="), run.worlds.size());
  EXPECT_EQ(count(page.dom, "class=\"track\""), tracks_of(run));
  EXPECT_EQ(count(page.dom, "data-plateau="), 2 * config.planners.size());
  EXPECT_THAT(page.dom, HasSubstr("0123abcd"));
}

TEST_F(Browser, SurvivesHostileNames) {
  synthetic::RunConfig config;
  config.planners = {"</script><script>document.title='broken'</script>",
                     "\"quotes\" & 'more' \\ {{data}}", "\u202Eمخطط\u202C", std::string(200, 'w')};
  config.groups = {"<img src=x onerror=alert(1)>"};
  config.scenarios_per_group = 1;
  const auto run = synthetic::make_run(config);
  const auto file = folder() / "hostile.html";
  write_html_report(input_of(run, "</title><b>"), file);
  const auto page = browser::load(file, "", 4000);
  EXPECT_EQ(page.console, "");
  EXPECT_THAT(page.dom, HasSubstr("data-ready=\"yes\""));
  EXPECT_THAT(page.dom, HasSubstr("<title>&lt;/title&gt;&lt;b&gt;</title>"));
  EXPECT_THAT(page.dom, Not(HasSubstr("<img")));
  EXPECT_THAT(page.dom, HasSubstr("&lt;img src=x onerror=alert(1)&gt;"));
  EXPECT_THAT(page.dom, HasSubstr("\"quotes\" &amp; 'more' \\ {{data}}"));
  EXPECT_EQ(count(page.dom, "class=\"track\""), tracks_of(run));
}

TEST_F(Browser, AnEmptyRunIsAReportToo) {
  const auto file = folder() / "empty.html";
  write_html_report(input_of({}, "Nothing ran"), file);
  const auto page = browser::load(file, "", 2000);
  EXPECT_EQ(page.console, "");
  EXPECT_THAT(page.dom, HasSubstr("data-ready=\"yes\""));
}

TEST_F(Browser, TheReplayShowsTheStoredStateOfTheMomentInTheAddress) {
  const auto run = synthetic::make_run();
  const auto file = folder() / "replay.html";
  write_html_report(input_of(run, "A replay"), file);
  const std::string scenario = run.records.back().scenario;
  std::string ids;
  std::vector<const Trace*> traces;
  for (const RunRecord& record : run.records) {
    if (record.scenario == scenario && record.repetition == 0) {
      ids += (ids.empty() ? "" : ",") + record.trial_id;
      for (const Trace& trace : run.traces) {
        if (trace.trial_id == record.trial_id) {
          traces.push_back(&trace);
        }
      }
    }
  }
  ASSERT_EQ(traces.size(), 3U);
  const auto page = browser::load(file, "#replay=" + ids + "&t=2.32", 4000);
  EXPECT_EQ(page.console, "");
  for (const Trace* trace : traces) {
    const TraceFrame& frame = trace->frames.at(46);  // 2.30 s, the last scan by then
    const auto at = page.dom.find("data-trial=\"" + trace->trial_id + "\" data-frame=\"46\"");
    ASSERT_NE(at, std::string::npos) << trace->trial_id;
    const std::string panel = page.dom.substr(at, page.dom.find("</figure>", at) - at);
    char position[64];
    std::snprintf(position, sizeof position, "<bdi>%.2f, %.2f m</bdi>", frame.x_m, frame.y_m);
    EXPECT_THAT(panel, HasSubstr(position));
    EXPECT_THAT(panel, HasSubstr("points known</dt><dd title=\"" +
                                 std::to_string(frame.known_points) + "\">"));
    EXPECT_THAT(panel, HasSubstr("<bdi>" + trace->modes.at(frame.mode) + "</bdi>"));
  }
  EXPECT_THAT(page.dom, HasSubstr("2.32 of "));
}

TEST_F(Browser, LeavesPicturesOfThePages) {
  synthetic::RunConfig config;
  config.repetitions = 20;
  const auto file = folder() / "synthetic.html";
  write_html_report(input_of(synthetic::make_run(config), "A synthetic suite"), file);
  for (const bool dark : {false, true}) {
    const auto png = folder() / (dark ? "report-dark.png" : "report-light.png");
    browser::screenshot(file, "", png, 1280, 6600, dark, 4000);
    EXPECT_GT(std::filesystem::file_size(png), 100'000U);
  }
  browser::screenshot(file, "", folder() / "report-phone.png", 390, 3000, false, 4000);
}

}  // namespace
}  // namespace voronaut
