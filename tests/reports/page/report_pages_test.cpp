#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>

#include <gmock/gmock.h>

#include "voronaut/reports/axis_columns.h"
#include "voronaut/tests/reports/page/report_in_browser.h"

namespace voronaut {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

class ReportPages : public ReportInBrowser {};

TEST_F(ReportPages, ShowsTheNumbersOfTheRecords) {
  synthetic::RunConfig config;
  config.repetitions = 20;
  const auto run = synthetic::make_run(config);
  const ReportInput input = report_input_of(run, "A synthetic suite");
  open(write_page("synthetic.html", input));
  EXPECT_EQ(text("h1"), "A synthetic suite");
  EXPECT_THAT(text("header"), HasSubstr("trials " + std::to_string(run.records.size())));
  EXPECT_THAT(text("header"), HasSubstr("commit 0123abcd"));
  const std::string shown = rows("overview");
  for (const PlannerSummary& s : input.summary.groups) {
    const Estimate& reached = s.of("goal_reached_share");
    EXPECT_THAT(shown,
                HasSubstr(s.planner + " | " + s.group.scenario_group + " | " + std::to_string(s.n) +
                          " | " + std::to_string(s.rank) + " | " + fixed(100 * reached.value, 1) +
                          " % " + std::to_string(reached.successes) + "/" + std::to_string(s.n) +
                          ", 95 % [" + fixed(100 * reached.interval.low, 1) + ", " +
                          fixed(100 * reached.interval.high, 1) + "] | "));
    for (const Statistic* one : statistics_shown(kPage))
      if (one->estimator != Estimator::rate && s.of(one->name).n > 0) {
        EXPECT_THAT(shown, HasSubstr(" | " + fixed(s.of(one->name).value, one->digits)));
      }
  }
}

TEST_F(ReportPages, FailuresAreAPlateauOfTheCurvesNotAGapInThem) {
  synthetic::RunConfig config;
  config.repetitions = 20;
  const auto run = synthetic::make_run(config);
  const ReportInput input = report_input_of(run, "Plateaus");
  open(write_page("plateaus.html", input), "#distributions");
  for (const PlannerSummary& s : input.summary.totals) {
    const std::string plateau =
        session_->evaluate("document.querySelector('#path_ratio [data-planner=\"" + s.planner +
                           "\"]').dataset.plateau");
    EXPECT_NEAR(std::stod(plateau), s.of("goal_reached_share").value, 1e-9) << s.planner;
  }
}

TEST_F(ReportPages, DrawsEveryTracedTrialAndEveryTracedFailureOnceMore) {
  const auto run = synthetic::make_run();
  const auto file = write_page("scenes.html", report_input_of(run, "Scenes"));
  open(file, "#scenes");
  EXPECT_EQ(count("#page-scenes figure"), std::to_string(run.worlds.size()));
  EXPECT_EQ(count("#page-scenes .track"), std::to_string(run.traces.size()));
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

TEST_F(ReportPages, ASceneDrawsSolidsAsOneAndSaysHowHardItsWorldIs) {
  auto run = synthetic::make_run();
  TraceWorld& world = run.worlds.front();
  world.polygons = {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{1, 0}, {2, 0}, {2, 1}, {1, 1}}};
  for (RunRecord& record : run.records) {
    record.free_share = 0.824;
    record.narrowest_passage_m = 0.615;
  }
  open(write_page("union.html", report_input_of(run, "Union")), "#scenes");
  const std::string figure =
      "document.querySelector('figure[data-scene=\"" + run.records.front().scenario + "\"]')";
  ASSERT_TRUE(session_->wait_for("!!" + figure + ".querySelector('path.obstacle')"));
  // Outlines below, and one path over them that covers those inside.
  EXPECT_EQ(session_->evaluate("[...(" + figure +
                               ").querySelectorAll('path.outline, path.obstacle')].map(p => "
                               "p.getAttribute('class') + p.getAttribute('d').split('Z').length)"
                               ".join(' ')"),
            "outline3 obstacle3");
  EXPECT_THAT(session_->evaluate("(" + figure + ").querySelector('.note').textContent"),
              HasSubstr("82 % free, narrowest passage 0.6"));
}

TEST_F(ReportPages, AFilterKeepsItsGroupOnlyOnEveryPage) {
  const auto run = synthetic::make_run();
  open(write_page("filter.html", report_input_of(run, "Filter")), "#scenes");
  session_->evaluate(
      "(() => { const s = document.querySelector('.filters select'); s.value = 'paper';"
      " s.dispatchEvent(new Event('change')); })()");
  EXPECT_EQ(count("#page-scenes figure"), "2");
  for (const char* page : {"overview", "failures"}) {
    go_to(page);
    EXPECT_THAT(text("#page-" + std::string(page) + ""), Not(HasSubstr("forest"))) << page;
  }
  expect_quiet();
}

TEST_F(ReportPages, APlannerThatIsSwitchedOffIsNowhere) {
  const auto run = synthetic::make_run();
  open(write_page("chips.html", report_input_of(run, "Chips")));
  session_->evaluate(
      "[...document.querySelectorAll('.chip')].find(c => "
      "c.textContent.includes('RRTConnect')).click()");
  for (const char* page : {"overview", "distributions", "scenes", "failures"}) {
    go_to(page);
    EXPECT_THAT(text("#page-" + std::string(page) + ""), Not(HasSubstr("RRTConnect"))) << page;
  }
}

TEST_F(ReportPages, OfStaticPlanningASpentBudgetIsNoTimeoutAndNothingIsSaidOfFlying) {
  auto run = synthetic::make_run();
  for (RunRecord& record : run.records) {
    if (entry_of(record.outcome).failure) record.outcome = Outcome::timeout;
    record.duration_s = record.speed_mean_m_s = record.speed_max_m_s = kAbsent;
    record.step_time_us_mean = kAbsent;
  }
  for (Trace& trace : run.traces) trace.static_planning = true;
  open(write_page("static.html", report_input_of(run, "Static")));
  for (const char* page : {"overview", "distributions", "scenes", "failures", "replay"}) {
    go_to(page);
    const std::string shown = text("#page-" + std::string(page));
    for (const char* not_said : {"timeout", "per scan", "governor", "rays", "speed", "\u2013 s"})
      EXPECT_THAT(shown, Not(HasSubstr(not_said))) << page;
  }
  EXPECT_THAT(text("#page-failures"), HasSubstr("budget spent"));
  EXPECT_THAT(text("#page-overview"), HasSubstr("planning time"));
  expect_quiet();
}

TEST_F(ReportPages, SaysHowManyFlightsAreKeptAndThatTheyAreTheFailures) {
  auto run = synthetic::make_run({.repetitions = 4, .traced_repetitions = 4});
  open(write_page("all-kept.html", report_input_of(run, "All kept")), "#scenes");
  EXPECT_THAT(text("#page-scenes"), Not(HasSubstr("are kept")));
  std::set<std::string> failures;
  for (const RunRecord& record : run.records)
    if (entry_of(record.outcome).failure) failures.insert(record.trial_id);
  std::erase_if(run.traces, [&](const Trace& trace) { return !failures.contains(trace.trial_id); });
  const std::string said = std::to_string(run.traces.size()) + " of " +
                           std::to_string(run.records.size()) + " flights are kept, failures only";
  open(write_page("failures-kept.html", report_input_of(run, "Failures kept")), "#scenes");
  EXPECT_THAT(text("#page-scenes"), HasSubstr(said));
  const RunRecord& one = *std::find_if(run.records.begin(), run.records.end(), [&](const auto& r) {
    return failures.contains(r.trial_id);
  });
  const auto like = [&](const RunRecord& r) {
    return r.scenario == one.scenario && r.planner == one.planner;
  };
  const auto arrived = std::count_if(run.records.begin(), run.records.end(), [&](const auto& r) {
    return like(r) && r.outcome == Outcome::goal_reached;
  });
  EXPECT_THAT(text("figure[data-scene=\"" + one.scenario + "\"]"),
              HasSubstr("arrived " + std::to_string(arrived) + " of 4"));
  go_to("replay");
  EXPECT_THAT(text("#page-replay"), HasSubstr(said));
}

TEST_F(ReportPages, WhatIsChosenIsInTheAddressAndOutlivesAReload) {
  const auto run = synthetic::make_run();
  open(write_page("chosen.html", report_input_of(run, "Chosen")));
  session_->evaluate(
      "(() => { const s = document.querySelector('.filters select'); s.value = 'paper';"
      " s.dispatchEvent(new Event('change'));"
      " [...document.querySelectorAll('.chip')].find(c => c.textContent.includes('RRTConnect'))"
      ".click();"
      " document.querySelector('nav button').click(); })()");
  const std::string press =
      "[...document.querySelectorAll('#page-overview table')].pop().querySelectorAll('th button')";
  session_->evaluate("(() => { " + press + "[0].click(); " + press + "[0].click(); })()");
  go_to("scenes");
  go_to("overview");
  const std::string theme = session_->evaluate("document.documentElement.dataset.theme");
  const std::string sorted =
      "[...document.querySelectorAll('#page-overview th[aria-sort]')].map(h => h.textContent + "
      "h.getAttribute('aria-sort')).join()";
  const std::string before = session_->evaluate(sorted);
  EXPECT_THAT(before, HasSubstr("descending"));
  EXPECT_EQ(theme, "dark");
  const std::string address = session_->evaluate("location.hash");
  EXPECT_THAT(address, HasSubstr("group=paper"));
  open(pages_folder() / "chosen.html", address);
  EXPECT_EQ(session_->evaluate("document.documentElement.dataset.theme"), theme);
  EXPECT_EQ(session_->evaluate(sorted), before);
  EXPECT_EQ(session_->evaluate("document.querySelector('.filters select').value"), "paper");
  EXPECT_THAT(text("#page-overview"), Not(HasSubstr("RRTConnect")));
  EXPECT_THAT(text("#page-overview"), Not(HasSubstr("forest")));
}

TEST_F(ReportPages, AnAddressWithNamesThatAreNotThereShowsEverything) {
  const auto run = synthetic::make_run();
  open(write_page("unknown.html", report_input_of(run, "Unknown")),
       "#overview?group=nowhere&without=nobody&theme=plaid&sort.everything-in-numbers=none");
  EXPECT_THAT(text("#page-overview"), HasSubstr("forest"));
  EXPECT_THAT(text("#page-overview"), HasSubstr("RRTConnect"));
  EXPECT_EQ(session_->evaluate("document.documentElement.dataset.theme"), "light");
}

TEST_F(ReportPages, AHeadingSortsItsColumn) {
  const auto run = synthetic::make_run();
  open(write_page("sort.html", report_input_of(run, "Sort")));
  const std::string after =
      "document.querySelectorAll('#page-overview table')[1].querySelectorAll('tbody tr')";
  const std::string press =
      "document.querySelectorAll('#page-overview table')[1].querySelectorAll('th')[7]."
      "querySelector('button').click()";
  const std::string values =
      "[..." + after + "].map(r => parseFloat(r.cells[7].textContent)).join(',')";
  session_->evaluate(press);
  const std::string sorted =
      session_->evaluate("(() => { const v = " + values +
                         ".split(',').map(Number);"
                         " return v.every((x, i) => i === 0 || isNaN(x) || v[i - 1] <= x); })()");
  EXPECT_EQ(sorted, "true") << session_->evaluate(values);
}

TEST_F(ReportPages, AnOutcomeHasTheSignTheWordsAndTheColourOfTheTable) {
  const auto run = synthetic::make_run();
  std::set<Outcome> failures;
  for (const RunRecord& record : run.records)
    if (entry_of(record.outcome).failure) failures.insert(record.outcome);
  ASSERT_GE(failures.size(), 2U);
  open(write_page("outcomes.html", report_input_of(run, "Outcomes")), "#failures");
  for (const Outcome outcome : failures) {
    const OutcomeEntry& entry = entry_of(outcome);
    const std::string shown = std::string(entry.sign) + " " + std::string(entry.words);
    EXPECT_EQ(
        session_->evaluate("[...document.querySelectorAll('#page-failures td .outcome')].find("
                           "e => e.textContent === '" +
                           shown + "').style.getPropertyValue('--on-light')"),
        entry.colour)
        << entry.name;
  }
}

TEST_F(ReportPages, SurvivesHostileNames) {
  synthetic::RunConfig config;
  config.planners = {"</script><script>document.title='broken'</script>",
                     "\"quotes\" & 'more' \\ {{data}}", "\u202Eمخطط\u202C", std::string(200, 'w')};
  config.groups = {"<img src=x onerror=alert(1)>"};
  config.scenarios_per_group = 1;
  const auto run = synthetic::make_run(config);
  open(write_page("hostile.html", report_input_of(run, "</title><b>")));
  EXPECT_EQ(session_->evaluate("document.title"), "</title><b>");
  EXPECT_EQ(count("img, b > b, script:not([type]) + *"), "0");
  for (const std::string& planner : config.planners) {
    EXPECT_THAT(text("#page-overview"), HasSubstr(planner));
  }
  for (const char* page : {"distributions", "failures", "provenance", "scenes"}) {
    go_to(page);
  }
  EXPECT_EQ(count("#page-scenes .track"), std::to_string(config.planners.size()));
  EXPECT_EQ(count("img, b > b, script:not([type]) + *"), "0");
  expect_quiet();
  EXPECT_EQ(session_->evaluate("document.documentElement.scrollWidth <= window.innerWidth"),
            "true");
}

TEST_F(ReportPages, AnEmptyRunIsAReportToo) {
  open(write_page("empty.html", report_input_of({}, "Nothing ran")), "#failures");
  EXPECT_THAT(text("#page-failures"), HasSubstr("Every trial reached the goal"));
}

TEST_F(ReportPages, ASweepShowsTheIntervalsOfTheSummary) {
  synthetic::RunConfig config;
  config.groups = {"forest-0.05", "forest-0.10", "forest-0.20"};
  config.repetitions = 12;
  const auto run = synthetic::make_run(config);
  const ReportInput input = report_input_of(run, "A sweep");
  open(write_page("sweep.html", input), "#sweeps");
  for (const PlannerSummary& s : input.summary.groups) {
    const std::string point =
        "[...document.querySelectorAll('#sweep-0-goal_reached_share [data-planner=\"" + s.planner +
        "\"] .point')].find(p => p.dataset.tip.includes('" + s.group.scenario_group + "'))";
    EXPECT_NEAR(std::stod(session_->evaluate(point + ".dataset.value")),
                s.of("goal_reached_share").value, 1e-9);
    EXPECT_THAT(session_->evaluate(point + ".dataset.tip"),
                HasSubstr("[" + fixed(100 * s.of("goal_reached_share").interval.low, 1) + " %, " +
                          fixed(100 * s.of("goal_reached_share").interval.high, 1) +
                          " %]\nn = " + std::to_string(s.n)));
  }
}

// Two axes of what flies and one of a planner, as a suite says them.
TEST_F(ReportPages, DrawsEachAxisOfTheSuiteAndSaysWhatItHolds) {
  synthetic::RunConfig config;
  config.groups = {"forest"};
  config.repetitions = 6;
  synthetic::Run run;
  const std::vector<std::string> speeds = {"1", "2"};
  const std::vector<std::string> ranges = {"0.5", "2.5"};
  AxisColumn speed{"vehicle.max_speed_m_s", "vehicle", false, {}, {}, {}};
  AxisColumn range{"range_finder.max_range_m", "vehicle", false, {}, {}, {}};
  for (const std::string& v : speeds) {
    for (const std::string& r : ranges) {
      const std::string label = "quadrotor max_speed_m_s=" + v + " max_range_m=" + r;
      speed.values[label] = v;
      range.values[label] = r;
      speed.bases[label] = range.bases[label] = "quadrotor";
      for (RunRecord record : synthetic::make_run(config).records) {
        record.trial_id += label;
        record.vehicle = label;
        if (r == "0.5" && v == "2") record.outcome = Outcome::collision;
        run.records.push_back(record);
      }
    }
  }
  const AxisColumn policy{"planner.policy", "planner", false, {{"RRTConnect", "a"}}, {}, {}};
  ReportInput input = report_input_of(run, "Axes");
  input.manifest_json =
      R"({"configuration": {"sweep": )" + axis_columns_json({speed, range, policy}) + "}}";
  open(write_page("axes.html", input), "#sweeps");
  // By speed at each range, then by range at each speed.
  EXPECT_EQ(count("#page-sweeps h3.vehicle"), "4");
  EXPECT_THAT(text("#sweep-0-goal_reached_share"),
              HasSubstr("Held: range_finder.max_range_m = 0.5"));
  EXPECT_THAT(text("#sweep-3-goal_reached_share"), HasSubstr("Held: vehicle.max_speed_m_s = 2"));
  EXPECT_THAT(text("#page-sweeps"), HasSubstr("without a line: planner.policy"));
  for (const PlannerSummary& s : input.summary.groups) {
    const bool slow = s.group.vehicle.find("max_speed_m_s=1") != std::string::npos;
    const std::string label = s.planner + (s.planner == "RRTConnect" ? ", planner.policy = a" : "");
    const std::string point =
        "document.querySelectorAll('#sweep-" + std::string(slow ? "2" : "3") +
        "-goal_reached_share [data-planner=\"" + label + "\"] .point')[" +
        (s.group.vehicle.find("max_range_m=0.5") != std::string::npos ? "0" : "1") + "]";
    EXPECT_NEAR(std::stod(session_->evaluate(point + ".dataset.value")),
                s.of("goal_reached_share").value, 1e-9)
        << s.group.vehicle;
  }
  expect_quiet();
}

TEST_F(ReportPages, ASweepHasItsTicksWhereItsValuesAre) {
  synthetic::RunConfig config;
  config.groups = {"forest-0.05", "forest-0.13", "forest-0.20"};
  config.repetitions = 2;
  const auto run = synthetic::make_run(config);
  open(write_page("ticks.html", report_input_of(run, "Ticks")), "#sweeps");
  EXPECT_EQ(session_->evaluate("[...document.querySelectorAll('#sweep-0-goal_reached_share "
                               ".axis')][0].textContent"),
            "0.050.130.2");
  // Four values of each point, or as many as arrived: they are drawn, and nothing is called 95 %.
  EXPECT_GT(std::stoi(count("#sweep-0-path_ratio_median .few")), 0);
  EXPECT_EQ(count("#sweep-0-path_ratio_median .band"), "0");
  EXPECT_THAT(session_->evaluate("[...document.querySelectorAll('#sweep-0-path_ratio_median "
                                 ".point')].map(p => p.dataset.tip).join()"),
              Not(HasSubstr("95 %")));
}

TEST_F(ReportPages, TablesScrollBesideTheirFirstColumnAndFifteenNamesDoNotOverlap) {
  synthetic::RunConfig config;
  config.planners.clear();
  for (int i = 0; i < 15; ++i) config.planners.push_back("Planner" + std::to_string(i));
  config.repetitions = 7;
  config.traced_repetitions = 0;
  const auto file = write_page("fifteen.html", report_input_of(synthetic::make_run(config), "15"));
  for (const int width_px : {360, 1280}) {
    open(file, {}, {width_px, 900});
    EXPECT_EQ(session_->evaluate("document.documentElement.scrollWidth <= window.innerWidth"),
              "true")
        << width_px;
    EXPECT_EQ(session_->evaluate("[...document.querySelectorAll('#page-overview .scroll')].every("
                                 "s => { s.scrollLeft = 1e6; return Math.abs("
                                 "s.querySelector('td').getBoundingClientRect().left - "
                                 "s.getBoundingClientRect().left) < 2; })"),
              "true")
        << width_px;
    session_->screenshot(pages_folder() / ("fifteen-" + std::to_string(width_px) + ".png"));
  }
  open(file, "#distributions");
  EXPECT_EQ(session_->evaluate(
                "[...document.querySelectorAll('#page-distributions figure > svg')].every(p => {"
                " const b = [...p.querySelectorAll('text.faint')].map(t => "
                "t.getBoundingClientRect()).sort((a, b) => a.top - b.top);"
                " return b.every((r, i) => i === 0 || b[i - 1].bottom <= r.top + 1); })"),
            "true");
  session_->screenshot(pages_folder() / "fifteen-distributions.png");
}

TEST_F(ReportPages, AComparisonSaysWhatChangedAndWhichTrialsEndOtherwise) {
  const auto run = synthetic::make_run();
  ReportInput input = report_input_of(run, "Now");
  std::vector<RunRecord> before = run.records;
  RunRecord& turned = before.front();
  turned.outcome =
      turned.outcome == Outcome::goal_reached ? Outcome::timeout : Outcome::goal_reached;
  input.comparison = compare_runs(run.records, before);
  input.comparison->title = "the run <before>";
  open(write_page("comparison.html", input), "#comparison");
  const std::string shown = text("#page-comparison");
  EXPECT_THAT(shown, HasSubstr("the run <before>"));
  EXPECT_THAT(shown, HasSubstr("1 trials end differently"));
  EXPECT_EQ(count("#page-comparison table:last-of-type"), "2");
}

TEST_F(ReportPages, WhatOthersPublishedStandsBesideTheRun) {
  auto run = synthetic::make_run();
  for (RunRecord& record : run.records) record.barn_score = 0.4;
  ReportInput input = report_input_of(run, "Beside others");
  open(write_page("alone.html", input));
  EXPECT_EQ(count("nav a[href=\"#published\"]"), "0");
  std::vector<PublishedWorld> worlds;
  for (const RunRecord& record : run.records)
    worlds.push_back({record.scenario, 10, 9, 1, 0.1, 30});
  input.published = beside_published(run.records, {{"slow <method>", worlds}});
  open(write_page("published.html", input), "#published");
  const std::string shown = text("#page-published");
  EXPECT_THAT(shown, HasSubstr("slow <method>"));
  EXPECT_THAT(shown, HasSubstr("0.300"));  // ours less theirs
  const std::size_t ours = input.published->differences.size();
  EXPECT_EQ(count("#page-published tbody tr"), std::to_string(ours + 1 + ours));
  expect_quiet();
}

TEST_F(ReportPages, TheFigureOfThePaperHasItsFiveScenesInItsOrder) {
  synthetic::RunConfig config;
  config.groups = {"paper-between", "paper-left", "paper-right", "paper-near-goal", "paper-even"};
  config.scenarios_per_group = 1;
  auto run = synthetic::make_run(config);
  for (RunRecord& record : run.records) {
    record.scenario = record.scenario_group;
    record.scenario_group = "paper";
  }
  open(write_page("figure9.html", report_input_of(run, "Figure 9")), "#figure9");
  EXPECT_EQ(session_->evaluate("[...document.querySelectorAll('[data-figure9]')].map(f => "
                               "f.dataset.figure9).join(' ')"),
            "paper-between paper-left paper-right paper-near-goal paper-even");
  EXPECT_EQ(count("#page-figure9 tbody tr"), "15");
  session_->screenshot(pages_folder() / "page-figure9.png");
}

TEST_F(ReportPages, TheMappingPageIsThereWhereMicrobenchmarksAre) {
  const auto run = synthetic::make_run();
  ReportInput input = report_input_of(run, "With microbenchmarks");
  open(write_page("no-mapping.html", input));
  EXPECT_EQ(count("nav a[href=\"#mapping\"]"), "0");
  input.mapping_json =
      R"({"logs":[],"micro":{"context":{"num_cpus":2},"benchmarks":[)"
      R"({"name":"mapping/forest/voronaut/rays:181","cpu_time":2500,"time_unit":"ns"},)"
      R"({"name":"mapping/forest/octomap<b>/rays:181","cpu_time":10,"time_unit":"us"},)"
      R"({"name":"mapping/growth/voronaut/known:100","cpu_time":2,"time_unit":"us"},)"
      R"({"name":"mapping/growth/voronaut/known:1000","cpu_time":4,"time_unit":"us"}]}})";
  open(write_page("mapping.html", input), "#mapping");
  EXPECT_EQ(count("#page-mapping figure"), "2");
  EXPECT_EQ(count("#page-mapping figcaption button"), "4");  // SVG and CSV of each
  EXPECT_THAT(text("#page-mapping table"), HasSubstr("octomap<b>10.004.0 \u00d7"));
  EXPECT_THAT(text("#growth .note"), HasSubstr("voronaut 0.30"));  // log10 of 2
  EXPECT_EQ(session_->evaluate("document.querySelector('#growth .point').dataset.tip"),
            "voronaut at 100 scans of other ground known before\n2.00 \u00b5s, median of n = 1");
}

TEST_F(ReportPages, APlotIsTakenAwayWithItsTitleAndLegend) {
  const auto run = synthetic::make_run();
  open(write_page("take-away.html", report_input_of(run, "Take away")), "#distributions");
  session_->evaluate(
      "(() => { URL.createObjectURL = b => { window.saved = b; return 'blob:none'; };"
      " HTMLAnchorElement.prototype.click = () => {}; })()");
  session_->evaluate("document.querySelector('#path_ratio button').click()");
  const std::string svg = session_->evaluate("window.saved.text()");
  for (const char* part :
       {"How long are the paths?", "RRTConnect", "of n = ", "share of all trials"}) {
    EXPECT_THAT(svg, HasSubstr(part));
  }
  EXPECT_EQ(session_->evaluate("window.saved.text().then(t => new DOMParser().parseFromString(t, "
                               "'image/svg+xml').querySelector('parsererror') === null)"),
            "true");

  // The ways of a scene, as they are stored.
  go_to("scenes");
  session_->evaluate("delete window.saved");
  session_->evaluate("document.querySelectorAll('#page-scenes figure button')[1].click()");
  ASSERT_TRUE(session_->wait_for("window.saved !== undefined"));
  const std::string csv = session_->evaluate("window.saved.text()");
  EXPECT_THAT(csv, HasSubstr("trial_id,planner,outcome,time_s,x_m,y_m\r\n"));
  std::size_t lines = 0;
  std::size_t ways = 0;
  for (const Trace& trace : run.traces) {
    if (csv.find("\n" + trace.trial_id + ",") == std::string::npos) continue;
    lines += trace.frames.size();
    ++ways;
  }
  EXPECT_EQ(ways, 3U);  // one of each planner
  EXPECT_EQ(static_cast<std::size_t>(std::count(csv.begin(), csv.end(), '\n')), lines + 1);
}

// Threads that want a core now, besides this one (proc(5), loadavg).
int others_running() {
  double load = 0;
  int running = 1;
  std::ifstream("/proc/loadavg") >> load >> load >> load >> running;
  return running - 1;
}

// 10 000 trials, 200 replays.
TEST_F(ReportPages, TenThousandTrialsAreSmallAndOpenFast) {
  synthetic::RunConfig config;
  config.planners = {"a", "b", "c", "d", "e"};
  config.groups = {"easy", "hard"};
  config.scenarios_per_group = 20;
  config.repetitions = 50;
  const auto run = synthetic::make_run(config);
  ASSERT_EQ(run.records.size(), 10'000U);
  ASSERT_EQ(run.traces.size(), 200U);
  const auto file = write_page("large.html", report_input_of(run, "Large"));
  const auto size_mb = static_cast<double>(std::filesystem::file_size(file)) / 1e6;
  EXPECT_LE(size_mb, 15.0);
  // Two seconds on an idle machine. Of three openings the best counts, for the browser itself warms
  // up; and where others want the cores at that moment the limit is three times as much.
  double drawn_s = 1e9;
  double limit_s = 6;
  for (int i = 0; i < 3; ++i) {
    if (others_running() == 0) limit_s = 2;
    open(file, "", {1280, 900});
    drawn_s = std::min(
        drawn_s, std::stod(session_->evaluate("document.documentElement.dataset.drawnMs")) / 1e3);
  }
  RecordProperty("size_mb", decimal(size_mb, 2));
  RecordProperty("drawn_s", decimal(drawn_s, 2));
  RecordProperty("limit_s", decimal(limit_s, 0));
  EXPECT_LE(drawn_s, limit_s) << size_mb << " MB";
  for (const char* page : {"distributions", "scenes", "failures", "provenance"}) {
    go_to(page);
  }
  expect_quiet();
}

}  // namespace
}  // namespace voronaut
