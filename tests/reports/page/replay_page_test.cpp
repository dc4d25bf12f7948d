#include <algorithm>
#include <cmath>
#include <set>

#include <gmock/gmock.h>

#include "voronaut/tests/reports/page/report_in_browser.h"

namespace voronaut {
namespace {

using ::testing::HasSubstr;

class ReplayPage : public ReportInBrowser {
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
    file_ = write_page("replay.html", report_input_of(run_, "A replay"));
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
    EXPECT_THAT(shown, HasSubstr("position" + decimal(stored.x_m, 2) + ", " +
                                 decimal(stored.y_m, 2) + " m"));
    EXPECT_THAT(shown, HasSubstr("points known" + std::to_string(stored.known_points)));
    EXPECT_THAT(shown, HasSubstr("mode" + trace->modes.at(static_cast<std::size_t>(stored.mode))));
  }
  EXPECT_THAT(text("#replay-clock"), HasSubstr("2.32 of "));
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
      EXPECT_NEAR(std::stod(share), 100 * stored.speed_scale, 0.51);
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
        decimal(trace->frames.at(k).t_s, 3) + "; s.dispatchEvent(new Event('input')); })()");
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
  const std::string stopped = text("#replay-clock");
  EXPECT_EQ(session_->evaluate("new Promise(r => setTimeout(() => "
                               "r(document.querySelector('#replay-clock').textContent), 200))"),
            stopped);
  // Where the focus is on what brought the reader here, too.
  for (const char* focus : {"document.activeElement.blur()",
                            "document.querySelector('nav a[href=\"#replay\"]').focus()"}) {
    session_->evaluate(focus);
    session_->press("End");
    EXPECT_EQ(frame(trace), std::to_string(trace.frames.size() - 1)) << focus;
    session_->press("Home");
    EXPECT_EQ(frame(trace), "0") << focus;
    session_->press(" ");
    EXPECT_TRUE(session_->wait_for(panel(trace) + ".dataset.frame > 2")) << focus;
    session_->press(" ");
  }
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
  EXPECT_THAT(text("#replay-clock"), HasSubstr("1.50 of "));
  session_->evaluate("[...document.querySelectorAll('.clock button')].pop().click()");
  EXPECT_THAT(session_->evaluate("location.hash"), HasSubstr("&t=1.50"));
  expect_quiet();
}

TEST_F(ReplayPage, AnAddressThatNamesNothingOpensTheFirstScene) {
  run_ = synthetic::make_run();
  file_ = write_page("replay.html", report_input_of(run_, "A replay"));
  for (const char* fragment : {"#replay=nobody&t=3", "#replay=%E0%A4%A", "#replay="}) {
    open(file_, fragment);
    EXPECT_TRUE(session_->wait_for("document.querySelectorAll('.panels figure').length === 3"));
  }
}

}  // namespace
}  // namespace voronaut
