#include "voronaut/reports/figures/svg_figure.h"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "voronaut/reports/store/atomic_file.h"
#include "voronaut/tests/reports/page/browser.h"
#include "voronaut/tests/reports/synthetic_run.h"

namespace voronaut {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

FigurePanel panel_of(const std::string& title, std::uint64_t seed) {
  FigurePanel panel{title, synthetic::make_world("w", seed, 7), {}};
  panel.tracks.push_back(
      {"repaired", Outcome::goal_reached,
       synthetic::make_trace("a", panel.world, seed, Outcome::goal_reached, 61)});
  panel.tracks.push_back(
      {"RRT<Connect>", Outcome::collision,
       synthetic::make_trace("b", panel.world, seed + 1, Outcome::collision, 61)});
  return panel;
}

TEST(SvgFigure, DrawsOneElementPerThing) {
  FigurePanel panel{"one", {}, {}};
  panel.world.bounds_min = {0, 0};
  panel.world.bounds_max = {10, 5};
  panel.world.circles = {{2.0, 1.0, 0.5}};
  panel.world.segments = {{TracePoint{0, 0}, TracePoint{10, 5}}};
  panel.world.start = {1, 1};
  panel.world.goal = {9, 4};
  FigureTrack track{"a", Outcome::timeout, {}};
  track.trace.frames.resize(2);
  track.trace.frames[1].x_m = 5.0;
  track.trace.frames[1].y_m = 2.5;
  track.trace.body_radius_m = 0.25;
  panel.tracks = {track};
  const std::string svg = svg_figure({panel}, {.columns = 1, .panel_px = 1000});
  // 100 px per metre; the panel starts at (18, 18 + 1.7 * 13).
  EXPECT_THAT(svg, HasSubstr("<circle cx=\"218\" cy=\"440.1\" r=\"50\"/>"));
  EXPECT_THAT(svg, HasSubstr("d=\"M18 540.1L1018 40.1\""));
  EXPECT_THAT(svg, HasSubstr("d=\"M18 540.1L518 290.1\""));
  EXPECT_THAT(svg, HasSubstr(">T</text>"));
  EXPECT_THAT(svg, HasSubstr(">a; T timeout</text>"));
  EXPECT_THAT(svg, HasSubstr("2 m</text>"));
}

TEST(SvgFigure, DrawsAPolygonAsItIsTurned) {
  FigurePanel panel{"one", {}, {}};
  panel.world.bounds_min = {0, 0};
  panel.world.bounds_max = {10, 5};
  panel.world.start = {1, 1};
  panel.world.goal = {9, 4};
  FigureTrack track{"a", Outcome::timeout, {}};
  track.trace.frames.resize(1);
  track.trace.frames[0].x_m = 5;
  track.trace.frames[0].y_m = 2;
  track.trace.frames[0].heading_x = 0;
  track.trace.frames[0].heading_y = 1;
  track.trace.body_radius_m = 0.5;
  track.trace.footprint = {{0.4, 0.1}, {-0.2, 0.1}, {-0.2, -0.1}, {0.4, -0.1}};
  panel.tracks = {track};
  const std::string svg = svg_figure({panel}, {.columns = 1, .panel_px = 1000});
  EXPECT_THAT(svg, HasSubstr("<path d=\"M508 300.1L508 360.1L528 360.1L528 300.1Z\" fill=\"#"));
}

TEST(SvgFigure, EscapesNamesAndNeedsNothingElse) {
  const std::string svg = svg_figure({panel_of("a & <b>", 3)});
  EXPECT_THAT(svg, HasSubstr("a &amp; &lt;b&gt;"));
  EXPECT_THAT(svg, HasSubstr("RRT&lt;Connect&gt;; \xe2\x9c\x95 collision"));
  EXPECT_THAT(svg, Not(HasSubstr("href")));
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
}

TEST(SvgFigure, OfAWorldWithoutTracksIsAPictureToo) {
  const FigurePanel panel{"world", synthetic::make_world("w", 9, 5), {}};
  EXPECT_THAT(svg_figure({panel}), HasSubstr("</svg>"));
  EXPECT_THAT(svg_figure({}), HasSubstr("</svg>"));
}

TEST(SvgFigure, LeavesAPicture) {
  if (!browser::find_chromium()) {
    GTEST_SKIP() << "chromium is not installed: the figure was not drawn";
  }
  const auto folder = std::filesystem::path(VORONAUT_BINARY_DIR) / "report-pages";
  std::filesystem::create_directories(folder);
  write_file_atomically(folder / "figure.svg",
                        svg_figure({panel_of("first", 3), panel_of("second", 5),
                                    panel_of("third", 8), panel_of("fourth", 12)}));
  browser::Session session;
  session.open(folder / "figure.svg", "", {1180, 920, false});
  session.screenshot(folder / "figure.png");
  EXPECT_GT(std::filesystem::file_size(folder / "figure.png"), 20'000U);
}

}  // namespace
}  // namespace voronaut
