#include "voronaut/tests/reports/page/browser.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "voronaut/reports/page/html_report.h"
#include "voronaut/reports/page/trace_json.h"
#include "voronaut/tests/reports/synthetic_run.h"

namespace voronaut {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

constexpr const char* kDrawn = "document.documentElement.dataset.ready === 'yes'";
// Drawings far below the window wait until they are scrolled to.
constexpr browser::View kTall{1280, 9000, false};

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
      R"({"program":{"version":"0.1.0","commit":"0123abcd","compiler":"GNU 12.2.0"},)"
      R"("machine":{"cpu":"made up"},"command":["voronaut","run","a b.yaml","--seed","1"],)"
      R"("configuration":{"seed":1,"planners":[{"label":"repaired"}]},)"
      R"("suite_text":"scenarios:\n  - paper\n  - forest\n"})";
  input.records = run.records;
  input.summary = summarise(run.records);
  input.worlds = run.worlds;
  for (const Trace& trace : run.traces) {
    input.trace_blobs[trace.trial_id] = compress_trace(trace);
  }
  return input;
}

std::filesystem::path write_report(const std::string& name, const ReportInput& input) {
  const auto file = folder() / name;
  write_html_report(input, file);
  return file;
}

std::string text_of(double value, int decimals) {
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, "%.*f", decimals, value);
  return buffer;
}

class Browser : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!browser::find_chromium()) {
      GTEST_SKIP() << "chromium is not installed: the report was not opened in a browser";
    }
    session_.emplace();
  }

  void open(const std::filesystem::path& file, const std::string& fragment = {},
            const browser::View& view = kTall) {
    session_->open(file, fragment, view);
    ASSERT_TRUE(session_->wait_for(kDrawn));
    ASSERT_TRUE(session_->wait_for("document.querySelectorAll('.waiting').length === 0"));
    expect_quiet();
  }

  void expect_quiet() {
    EXPECT_THAT(session_->complaints(), IsEmpty());
    EXPECT_THAT(session_->requests(), IsEmpty());
  }

  void go_to(const std::string& page) {
    session_->evaluate("location.hash = '#" + page + "'");
    ASSERT_TRUE(session_->wait_for("!document.querySelector('#page-" + page + "').hidden"));
    // What is in the window is drawn; the rest waits until it is scrolled to.
    ASSERT_TRUE(session_->wait_for(
        "[...document.querySelectorAll('section:not([hidden]) .waiting')].every(e => "
        "e.getBoundingClientRect().top > window.innerHeight)"));
  }

  std::string text(const std::string& selector) {
    return session_->evaluate("document.querySelector(" + selector + ").textContent");
  }
  std::string count(const std::string& selector) {
    return session_->evaluate("document.querySelectorAll(" + selector + ").length");
  }

  std::optional<browser::Session> session_;
};

TEST_F(Browser, ShowsTheNumbersOfTheRecords) {
  synthetic::RunConfig config;
  config.repetitions = 20;
  const auto run = synthetic::make_run(config);
  const ReportInput input = input_of(run, "A synthetic suite");
  open(write_report("synthetic.html", input));
  EXPECT_EQ(text("'h1'"), "A synthetic suite");
  EXPECT_THAT(text("'header'"), HasSubstr("trials " + std::to_string(run.records.size())));
  EXPECT_THAT(text("'header'"), HasSubstr("commit 0123abcd"));
  const std::string rows = session_->evaluate(
      "[...document.querySelectorAll('#page-overview tr')].map(r => "
      "[...r.cells].map(c => c.textContent.trim()).join(' | ')).join('\\n')");
  for (const PlannerSummary& s : input.summary.groups) {
    EXPECT_THAT(rows,
                HasSubstr(s.group.scenario_group + " | " + s.planner + " | " + std::to_string(s.n) +
                          " | " + text_of(std::round(100 * s.success.value), 0) + " % " +
                          std::to_string(s.success.successes) + "/" + std::to_string(s.n) +
                          ", 95 % [" + text_of(std::round(100 * s.success.interval.low), 0) + ", " +
                          text_of(std::round(100 * s.success.interval.high), 0) + "] | " +
                          std::to_string(s.collisions.successes)));
    EXPECT_THAT(rows, HasSubstr(" | " + text_of(s.path_ratio_median.value, 3) + "["));
  }
}

TEST_F(Browser, FailuresAreAPlateauOfTheCurvesNotAGapInThem) {
  synthetic::RunConfig config;
  config.repetitions = 20;
  const auto run = synthetic::make_run(config);
  const ReportInput input = input_of(run, "Plateaus");
  open(write_report("plateaus.html", input), "#distributions");
  for (const PlannerSummary& s : input.summary.totals) {
    const std::string plateau =
        session_->evaluate("document.querySelector('#path-ratio [data-planner=\"" + s.planner +
                           "\"]').dataset.plateau");
    EXPECT_NEAR(std::stod(plateau), s.success.value, 1e-9) << s.planner;
  }
}

TEST_F(Browser, DrawsEveryTracedTrialAndEveryTracedFailureOnceMore) {
  const auto run = synthetic::make_run();
  const auto file = write_report("scenes.html", input_of(run, "Scenes"));
  open(file, "#scenes");
  EXPECT_EQ(count("'#page-scenes figure'"), std::to_string(run.worlds.size()));
  EXPECT_EQ(count("'#page-scenes .track'"), std::to_string(run.traces.size()));
  std::size_t failed_traces = 0;
  for (const Trace& trace : run.traces) {
    for (const RunRecord& record : run.records) {
      failed_traces +=
          record.trial_id == trace.trial_id && record.outcome != Outcome::goal_reached ? 1U : 0U;
    }
  }
  const std::size_t circles = run.worlds.front().circles.size();
  EXPECT_EQ(session_->evaluate("document.querySelector('figure[data-scene=\"" +
                               run.records.front().scenario +
                               "\"]').querySelectorAll('circle.obstacle').length"),
            std::to_string(circles));
  open(file, "#failures");
  EXPECT_TRUE(session_->wait_for("document.querySelectorAll('#page-failures .track').length === " +
                                 std::to_string(failed_traces)));
}

TEST_F(Browser, AFilterKeepsItsGroupOnlyOnEveryPage) {
  const auto run = synthetic::make_run();
  open(write_report("filter.html", input_of(run, "Filter")), "#scenes");
  session_->evaluate(
      "(() => { const s = document.querySelector('.filters select'); s.value = 'paper';"
      " s.dispatchEvent(new Event('change')); })()");
  EXPECT_EQ(count("'#page-scenes figure'"), "2");
  for (const char* page : {"overview", "failures"}) {
    go_to(page);
    EXPECT_THAT(text("'#page-" + std::string(page) + "'"), Not(HasSubstr("forest"))) << page;
  }
  expect_quiet();
}

TEST_F(Browser, APlannerThatIsSwitchedOffIsNowhere) {
  const auto run = synthetic::make_run();
  open(write_report("chips.html", input_of(run, "Chips")));
  session_->evaluate(
      "[...document.querySelectorAll('.chip')].find(c => "
      "c.textContent.includes('RRTConnect')).click()");
  for (const char* page : {"overview", "distributions", "scenes", "failures"}) {
    go_to(page);
    EXPECT_THAT(text("'#page-" + std::string(page) + "'"), Not(HasSubstr("RRTConnect"))) << page;
  }
}

TEST_F(Browser, AHeadingSortsItsColumn) {
  const auto run = synthetic::make_run();
  open(write_report("sort.html", input_of(run, "Sort")));
  const std::string after =
      "document.querySelectorAll('#page-overview table')[1].querySelectorAll('tbody tr')";
  const std::string press =
      "document.querySelectorAll('#page-overview table')[1].querySelectorAll('th "
      "button')[6].click()";
  const std::string values =
      "[..." + after + "].map(r => parseFloat(r.cells[6].textContent)).join(',')";
  session_->evaluate(press);
  const std::string sorted =
      session_->evaluate("(() => { const v = " + values +
                         ".split(',').map(Number);"
                         " return v.every((x, i) => i === 0 || isNaN(x) || v[i - 1] <= x); })()");
  EXPECT_EQ(sorted, "true") << session_->evaluate(values);
}

TEST_F(Browser, SurvivesHostileNames) {
  synthetic::RunConfig config;
  config.planners = {"</script><script>document.title='broken'</script>",
                     "\"quotes\" & 'more' \\ {{data}}", "\u202Eمخطط\u202C", std::string(200, 'w')};
  config.groups = {"<img src=x onerror=alert(1)>"};
  config.scenarios_per_group = 1;
  const auto run = synthetic::make_run(config);
  open(write_report("hostile.html", input_of(run, "</title><b>")));
  EXPECT_EQ(session_->evaluate("document.title"), "</title><b>");
  EXPECT_EQ(count("'img, b > b, script:not([type]) + *'"), "0");
  for (const std::string& planner : config.planners) {
    EXPECT_THAT(text("'#page-overview'"), HasSubstr(planner));
  }
  for (const char* page : {"distributions", "failures", "provenance", "scenes"}) {
    go_to(page);
  }
  EXPECT_EQ(count("'#page-scenes .track'"), std::to_string(config.planners.size()));
  EXPECT_EQ(count("'img, b > b, script:not([type]) + *'"), "0");
  expect_quiet();
  EXPECT_EQ(session_->evaluate("document.documentElement.scrollWidth <= window.innerWidth"),
            "true");
}

TEST_F(Browser, AnEmptyRunIsAReportToo) {
  open(write_report("empty.html", input_of({}, "Nothing ran")), "#failures");
  EXPECT_THAT(text("'#page-failures'"), HasSubstr("Every trial reached the goal"));
}

TEST_F(Browser, ASweepShowsTheIntervalsOfTheSummary) {
  synthetic::RunConfig config;
  config.groups = {"forest-0.05", "forest-0.10", "forest-0.20"};
  config.repetitions = 12;
  const auto run = synthetic::make_run(config);
  const ReportInput input = input_of(run, "A sweep");
  open(write_report("sweep.html", input), "#sweeps");
  for (const PlannerSummary& s : input.summary.groups) {
    const std::string point = "[...document.querySelectorAll('#sweep-0-success [data-planner=\"" +
                              s.planner + "\"] .point')].find(p => p.dataset.tip.includes('" +
                              s.group.scenario_group + "'))";
    EXPECT_NEAR(std::stod(session_->evaluate(point + ".dataset.value")), s.success.value, 1e-9);
    EXPECT_THAT(session_->evaluate(point + ".dataset.tip"),
                HasSubstr("[" + text_of(s.success.interval.low, 3) + ", " +
                          text_of(s.success.interval.high, 3) + "]\nn = " + std::to_string(s.n)));
  }
}

TEST_F(Browser, AComparisonSaysWhatChangedAndWhichTrialsEndOtherwise) {
  const auto run = synthetic::make_run();
  ReportInput input = input_of(run, "Now");
  std::vector<RunRecord> before = run.records;
  RunRecord& turned = before.front();
  turned.outcome =
      turned.outcome == Outcome::goal_reached ? Outcome::timeout : Outcome::goal_reached;
  input.comparison = compare_runs(run.records, before);
  input.comparison->title = "the run <before>";
  open(write_report("comparison.html", input), "#comparison");
  const std::string shown = text("'#page-comparison'");
  EXPECT_THAT(shown, HasSubstr("the run <before>"));
  EXPECT_THAT(shown, HasSubstr("1 trials end differently"));
  EXPECT_EQ(count("'#page-comparison table:last-of-type'"), "2");
}

TEST_F(Browser, TheFigureOfThePaperHasItsFiveScenesInItsOrder) {
  synthetic::RunConfig config;
  config.groups = {"paper-between", "paper-left", "paper-right", "paper-near-goal", "paper-even"};
  config.scenarios_per_group = 1;
  auto run = synthetic::make_run(config);
  for (RunRecord& record : run.records) {
    record.scenario = record.scenario_group;
    record.scenario_group = "paper";
  }
  open(write_report("figure9.html", input_of(run, "Figure 9")), "#figure9");
  EXPECT_EQ(session_->evaluate("[...document.querySelectorAll('[data-figure9]')].map(f => "
                               "f.dataset.figure9).join(' ')"),
            "paper-between paper-left paper-right paper-near-goal paper-even");
  EXPECT_EQ(count("'#page-figure9 tbody tr'"), "15");
  session_->screenshot(folder() / "page-figure9.png");
}

TEST_F(Browser, APlotIsTakenAwayWithItsTitleAndLegend) {
  const auto run = synthetic::make_run();
  open(write_report("take-away.html", input_of(run, "Take away")), "#distributions");
  session_->evaluate(
      "(() => { URL.createObjectURL = b => { window.saved = b; return 'blob:none'; };"
      " HTMLAnchorElement.prototype.click = () => {}; })()");
  session_->evaluate("document.querySelector('#path-ratio button').click()");
  const std::string svg = session_->evaluate("window.saved.text()");
  for (const char* part :
       {"How long are the paths?", "RRTConnect", "of n = ", "share of all trials"}) {
    EXPECT_THAT(svg, HasSubstr(part));
  }
  EXPECT_EQ(session_->evaluate("window.saved.text().then(t => new DOMParser().parseFromString(t, "
                               "'image/svg+xml').querySelector('parsererror') === null)"),
            "true");
}

// The issue's own size: 10 000 trials, 200 replays.
TEST_F(Browser, TenThousandTrialsAreSmallAndOpenFast) {
  synthetic::RunConfig config;
  config.planners = {"a", "b", "c", "d", "e"};
  config.groups = {"easy", "hard"};
  config.scenarios_per_group = 20;
  config.repetitions = 50;
  const auto run = synthetic::make_run(config);
  ASSERT_EQ(run.records.size(), 10'000U);
  ASSERT_EQ(run.traces.size(), 200U);
  const auto file = write_report("large.html", input_of(run, "Large"));
  const auto size_mb = static_cast<double>(std::filesystem::file_size(file)) / 1e6;
  EXPECT_LE(size_mb, 15.0);
  open(file, "", {1280, 900, false});
  const double drawn_s =
      std::stod(session_->evaluate("document.documentElement.dataset.drawnMs")) / 1e3;
  RecordProperty("size_mb", text_of(size_mb, 2));
  RecordProperty("drawn_s", text_of(drawn_s, 2));
  // Two seconds on an idle machine; tests share theirs with others.
  EXPECT_LE(drawn_s, 6.0) << size_mb << " MB";
  for (const char* page : {"distributions", "scenes", "failures", "provenance"}) {
    go_to(page);
  }
  expect_quiet();
}

class ReplayPage : public Browser {
 protected:
  // Trials of the first repetition in the last scenario, in the order of the records.
  void open_replay(const std::string& at) {
    run_ = synthetic::make_run();
    const std::string scenario = run_.records.back().scenario;
    std::string ids;
    for (const RunRecord& record : run_.records) {
      if (record.scenario == scenario && record.repetition == 0) {
        ids += (ids.empty() ? "" : ",") + record.trial_id;
        for (const Trace& trace : run_.traces) {
          if (trace.trial_id == record.trial_id) {
            traces_.push_back(&trace);
          }
        }
      }
    }
    file_ = write_report("replay.html", input_of(run_, "A replay"));
    open(file_, "#replay=" + ids + at);
    ASSERT_TRUE(session_->wait_for("document.querySelectorAll('.panels figure').length === 3"));
  }

  std::string panel(const Trace& trace) {
    return "document.querySelector('.panels [data-trial=\"" + trace.trial_id + "\"]')";
  }
  std::string frame(const Trace& trace) {
    return session_->evaluate(panel(trace) + ".dataset.frame");
  }

  synthetic::Run run_;
  std::vector<const Trace*> traces_;
  std::filesystem::path file_;
};

TEST_F(ReplayPage, ShowsTheStoredStateOfTheMomentInTheAddress) {
  open_replay("&t=2.32");
  ASSERT_EQ(traces_.size(), 3U);
  for (const Trace* trace : traces_) {
    const TraceFrame& stored = trace->frames.at(46);  // 2.30 s, the last scan by then
    EXPECT_EQ(frame(*trace), "46");
    const std::string shown = session_->evaluate(panel(*trace) + ".textContent");
    EXPECT_THAT(shown, HasSubstr("position" + text_of(stored.x_m, 2) + ", " +
                                 text_of(stored.y_m, 2) + " m"));
    EXPECT_THAT(shown, HasSubstr("points known" + std::to_string(stored.known_points)));
    EXPECT_THAT(shown, HasSubstr("mode" + trace->modes.at(static_cast<std::size_t>(stored.mode))));
  }
  EXPECT_THAT(text("'#replay-clock'"), HasSubstr("2.32 of "));
  expect_quiet();
}

// Edges, hulls and labels are told again in plain words: what the page must draw of a frame.
std::size_t edges_of_search(const Trace& trace, int search) {
  return static_cast<std::size_t>(
      std::count_if(trace.edges.begin(), trace.edges.end(), [&](const TraceEdge& edge) {
        return edge.first_search <= search && search <= edge.last_search;
      }));
}

TEST_F(ReplayPage, TellsWhatGovernorAndSearchDidAtTheMomentShown) {
  for (const char* at : {"&t=0.50", "&t=2.32", "&t=4.10"}) {
    traces_.clear();
    open_replay(at);
    for (const Trace* trace : traces_) {
      const std::size_t k = static_cast<std::size_t>(std::stoi(frame(*trace)));
      const TraceFrame& stored = trace->frames.at(k);
      const std::string shown = session_->evaluate(panel(*trace) + ".textContent");
      EXPECT_THAT(
          shown,
          HasSubstr("search" + std::to_string(edges_of_search(*trace, stored.search)) + " edges, " +
                    std::to_string(stored.search + 1) + " of " + std::to_string(trace->searches)));
      double stop_m = 0;
      for (std::size_t i = 1; i < stored.tube.size(); ++i) {
        stop_m += std::hypot(stored.tube[i].x_m - stored.tube[i - 1].x_m,
                             stored.tube[i].y_m - stored.tube[i - 1].y_m);
      }
      const std::string share = shown.substr(shown.find("governor") + 8);
      EXPECT_NEAR(std::stod(share), 100 * stored.governed_share, 0.51);
      const std::string told = shown.substr(shown.find("stop in ") + 8);
      EXPECT_NEAR(std::stod(told), stop_m, 0.02);
    }
    expect_quiet();
  }
}

TEST_F(ReplayPage, EachLayerCanBeSwitchedOffAndDrawsNothingThen) {
  open_replay("&t=3.00");
  const std::string picture = "document.querySelector('.panels canvas').toDataURL()";
  const std::string whole = session_->evaluate(picture);
  for (const char* layer : {"truth", "rays", "known", "hulls", "search", "plan", "tube", "trail"}) {
    const std::string press =
        "document.querySelector('[data-layer=" + std::string(layer) + "] input').click()";
    session_->evaluate(press);
    EXPECT_NE(session_->evaluate(picture), whole) << layer;
    session_->evaluate(press);
    EXPECT_EQ(session_->evaluate(picture), whole) << layer;
  }
  expect_quiet();
}

TEST_F(ReplayPage, ClustersAreGroupedAsTheMapGroupedThemThen) {
  open_replay("&t=0");
  const Trace* trace = traces_.front();
  ASSERT_FALSE(trace->merges.empty());
  // Just before and after the first merge: points as many as known, one outline less.
  const std::uint32_t merge = trace->merges.front().frame;
  const auto outlines = [&](std::uint32_t k) {
    std::set<std::uint32_t> labels;
    for (std::size_t i = 0; i < trace->frames.at(k).known_points; ++i) {
      std::uint32_t label = trace->cluster_of[i];
      for (const TraceMerge& m : trace->merges) {
        if (m.frame <= k && m.from == label) label = m.into;
      }
      labels.insert(label);
    }
    return labels.size();
  };
  for (const std::uint32_t k : {merge - 1, merge, merge + 40}) {
    session_->evaluate(
        "(() => { const s = document.querySelector('.clock input[type=range]');"
        " s.value = " +
        text_of(trace->frames.at(k).t_s, 3) + "; s.dispatchEvent(new Event('input')); })()");
    ASSERT_EQ(frame(*trace), std::to_string(k));
    EXPECT_THAT(session_->evaluate(panel(*trace) + ".textContent"),
                HasSubstr("clusters" + std::to_string(outlines(k))))
        << k;
  }
}

TEST_F(ReplayPage, KeysStepJumpAndPlay) {
  open_replay("&t=1.00");
  const Trace& trace = *traces_.front();
  EXPECT_EQ(frame(trace), "20");
  session_->press("ArrowRight");
  EXPECT_EQ(frame(trace), "21");
  session_->press("ArrowLeft");
  session_->press("ArrowLeft");
  EXPECT_EQ(frame(trace), "19");
  session_->press(" ");
  EXPECT_TRUE(session_->wait_for(panel(trace) + ".dataset.frame > 22"));
  session_->press(" ");
  const std::string stopped = text("'#replay-clock'");
  EXPECT_EQ(session_->evaluate("new Promise(r => setTimeout(() => "
                               "r(document.querySelector('#replay-clock').textContent), 200))"),
            stopped);
  expect_quiet();
}

TEST_F(ReplayPage, TheSliderMovesAllPanelsAndTheMapGrowsWithIt) {
  open_replay("&t=0");
  const std::string ink =
      "(() => { const c = document.querySelector('.panels canvas');"
      " const d = c.getContext('2d').getImageData(0, 0, c.width, c.height).data; let n = 0;"
      " for (let i = 0; i < d.length; i += 4) if (d[i] + d[i+1] + d[i+2] < 300) ++n;"
      " return n; })()";
  for (const char* layer : {"true world", "rays", "clusters", "plan", "way"}) {
    session_->evaluate(
        "[...document.querySelectorAll('#page-replay .check')].find(c => "
        "c.textContent.trim().startsWith('" +
        std::string(layer) + "')).firstChild.click()");
  }
  // The outlines of start and goal are dark too: known points must add to them.
  const int before = std::stoi(session_->evaluate(ink));
  session_->evaluate(
      "(() => { const s = document.querySelector('.clock input[type=range]');"
      " s.value = s.max; s.dispatchEvent(new Event('input')); })()");
  for (const Trace* trace : traces_) {
    EXPECT_EQ(frame(*trace), std::to_string(trace->frames.size() - 1));
  }
  EXPECT_GT(std::stoi(session_->evaluate(ink)), before + 60);
}

TEST_F(ReplayPage, APlannerCanBeTakenAwayAndTheMomentStays) {
  open_replay("&t=1.50");
  session_->evaluate(
      "document.querySelector('#page-replay .controls input[type=checkbox]').click()");
  EXPECT_TRUE(session_->wait_for("document.querySelectorAll('.panels figure').length === 2"));
  EXPECT_THAT(text("'#replay-clock'"), HasSubstr("1.50 of "));
  session_->evaluate("[...document.querySelectorAll('.clock button')].pop().click()");
  EXPECT_THAT(session_->evaluate("location.hash"), HasSubstr("&t=1.50"));
  expect_quiet();
}

TEST_F(ReplayPage, AnAddressThatNamesNothingOpensTheFirstScene) {
  run_ = synthetic::make_run();
  file_ = write_report("replay.html", input_of(run_, "A replay"));
  for (const char* fragment : {"#replay=nobody&t=3", "#replay=%E0%A4%A", "#replay="}) {
    open(file_, fragment);
    EXPECT_TRUE(session_->wait_for("document.querySelectorAll('.panels figure').length === 3"));
  }
}

TEST_F(Browser, LeavesAPictureOfEachPage) {
  synthetic::RunConfig config;
  config.groups = {"forest-1", "forest-2", "forest-3"};
  config.repetitions = 20;
  const auto run = synthetic::make_run(config);
  ReportInput input = input_of(run, "A synthetic suite");
  input.comparison = compare_runs(run.records, run.records);
  const auto file = write_report("synthetic.html", input);
  struct Picture {
    std::string suffix;
    browser::View view;
  };
  for (const auto& [suffix, view] :
       {Picture{"", {1280, 1800, false}}, Picture{"-dark", {1280, 1800, true}},
        Picture{"-phone", {390, 1800, false}}}) {
    open(file, "", view);
    for (const char* page : {"overview", "distributions", "sweeps", "scenes", "replay", "failures",
                             "comparison", "provenance"}) {
      go_to(page);
      if (std::string_view(page) == "replay") {
        ASSERT_TRUE(session_->wait_for("document.querySelector('.panels figure') !== null"));
      }
      const auto png = folder() / ("page-" + std::string(page) + suffix + ".png");
      session_->screenshot(png);
      EXPECT_GT(std::filesystem::file_size(png), 20'000U) << png;
      EXPECT_EQ(session_->evaluate("document.documentElement.scrollWidth <= window.innerWidth"),
                "true")
          << png;
    }
    expect_quiet();
  }
}

}  // namespace
}  // namespace voronaut
