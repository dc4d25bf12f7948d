#pragma once

#include <string>

namespace voronaut {

// The papers' planner and its repairs. Every choice has the published value first; each repair can
// be switched alone, so that what it is worth can be measured.
struct ReactiveVoronoiConfig {
  // Which way the increment of an extreme point goes.
  enum class Offset {
    axis,           // (x + g, y - g) or (x - g, y + g), as printed: across the way only at 45 deg
    line_of_sight,  // across the line of sight to the point, at least as long
  };
  // What the first and the last point of an obstacle are.
  enum class Extremes {
    stored_order,   // as the base stores them: merging and flying on move them inwards
    bearing_order,  // as seen from where the vehicle is now
  };
  // Which obstacles switch the mode.
  enum class Relevance {
    in_sight,       // any that the latest scan shows
    goal_corridor,  // those with a point in the corridor from the vehicle to the goal
  };
  // Which points of an obstacle count.
  enum class Source {
    scan,  // those of the latest scan
    map,   // all that are known
  };
  // What becomes of points beside and behind the vehicle.
  enum class Passed {
    counted,  // in view is in view; that they leave the field of view is what ends a mode
    dropped,  // only points ahead, as seen along the line to the goal
  };
  // Between which two obstacles the vehicle goes, when there are several.
  enum class Pairing {
    closest,     // the two closest ones, wherever they are
    across_way,  // the closest on either side of the line to the goal; those on one side of it are
                 // passed together, as if they were one
  };
  // What an extreme point at the edge of the field of view is worth.
  enum class CutEdges {
    trusted,  // it is the end of the obstacle
    avoided,  // the end is unseen: the other side is taken if it is not cut too
  };

  double safety_margin_m = 0.5;
  double corridor_half_width_m = 0.75;
  Offset offset = Offset::axis;
  Extremes extremes = Extremes::stored_order;
  Relevance relevance = Relevance::in_sight;
  Source source = Source::scan;
  Passed passed = Passed::counted;
  Pairing pairing = Pairing::closest;
  CutEdges cut_edges = CutEdges::trusted;
  bool side_hysteresis = false;

  static ReactiveVoronoiConfig as_published() { return {}; }
  static ReactiveVoronoiConfig repaired() {
    ReactiveVoronoiConfig config;
    config.offset = Offset::line_of_sight;
    config.extremes = Extremes::bearing_order;
    config.relevance = Relevance::goal_corridor;
    config.passed = Passed::dropped;
    config.pairing = Pairing::across_way;
    config.cut_edges = CutEdges::avoided;
    config.side_hysteresis = true;
    return config;
  }

  template <class Visitor>
  void visit(Visitor& v) {
    v.number("safety_margin_m", safety_margin_m, 0.01, 10,
             "The papers' gamma: how far from an obstacle's edge a subgoal lies");
    v.number("corridor_half_width_m", corridor_half_width_m, 0.01, 100,
             "Half width of the corridor of relevance and pairing");
    v.choice("offset", offset, {{"axis", Offset::axis}, {"line_of_sight", Offset::line_of_sight}},
             "Which way the increment of an extreme point goes: as printed, or across the line of "
             "sight");
    v.choice(
        "extremes", extremes,
        {{"stored_order", Extremes::stored_order}, {"bearing_order", Extremes::bearing_order}},
        "What the first and last point of an obstacle are: as stored, or by bearing from here");
    v.choice("relevance", relevance,
             {{"in_sight", Relevance::in_sight}, {"goal_corridor", Relevance::goal_corridor}},
             "Which obstacles switch the mode: any in sight, or those in the corridor to the goal");
    v.choice("source", source, {{"scan", Source::scan}, {"map", Source::map}},
             "Which points of an obstacle count: those of the latest scan, or all known ones");
    v.choice("passed", passed, {{"counted", Passed::counted}, {"dropped", Passed::dropped}},
             "What becomes of points beside and behind the vehicle");
    v.choice("pairing", pairing,
             {{"closest", Pairing::closest}, {"across_way", Pairing::across_way}},
             "Between which two of several obstacles it goes: the closest, or one on either side "
             "of the way");
    v.choice("cut_edges", cut_edges,
             {{"trusted", CutEdges::trusted}, {"avoided", CutEdges::avoided}},
             "What an extreme point at the edge of the field of view is worth");
    v.flag("side_hysteresis", side_hysteresis,
           "Keep to the side once chosen, as long as the obstacle matters");
  }
};

}  // namespace voronaut
