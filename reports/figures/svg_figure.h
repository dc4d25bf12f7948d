#pragma once

#include <string>
#include <vector>

#include "voronaut/reports/run_record.h"
#include "voronaut/reports/trace/trace.h"

// Stand-alone vector figures for papers and pages: no script, no style sheet, no font but the
// reader's sans-serif.
namespace voronaut {

struct FigureTrack {
  std::string label;  // the same label has the same colour and dash in every panel
  Outcome outcome = Outcome::goal_reached;
  Trace trace;
};

// One true world and the ways through it.
struct FigurePanel {
  std::string title;
  TraceWorld world;
  std::vector<FigureTrack> tracks;
  bool ends = true;  // start and goal are drawn
};

struct FigureConfig {
  int columns = 3;        // panels side by side, at most
  double panel_px = 360;  // longer side of a panel
  bool known = true;      // points and hulls known to the first track at its end
  double font_size_px = 13;

  template <class Visitor>
  void visit(Visitor& v) {
    v.count("columns", columns, 1, 20);
    v.number("panel_px", panel_px, 100.0, 4000.0);
    v.flag("known", known);
    v.number("font_size_px", font_size_px, 6.0, 60.0);
  }
};

// An SVG document on white: the true world in grey, known points as dots, hulls dashed, a line per
// track with a sign where it failed, start (circle) and goal (diamond), a scale, a legend under all
// panels. Told by dash and symbol too, not by colour alone.
std::string svg_figure(const std::vector<FigurePanel>& panels, const FigureConfig& config = {});

}  // namespace voronaut
