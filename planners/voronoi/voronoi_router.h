#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "voronaut/environments/shapes/geometry.h"
#include "voronaut/planners/voronoi/channel_search.h"
#include "voronaut/planners/voronoi/delaunay.h"
#include "voronaut/planners/voronoi/graph_search.h"
#include "voronaut/planners/voronoi/retraction.h"
#include "voronaut/planners/voronoi/site_cells.h"
#include "voronaut/planners/voronoi/voronoi_graph.h"

namespace voronaut {

// How a route along the Voronoi graph is shortened.
enum class Shortening {
  none,      // stay on the graph: greatest clearance
  shortcut,  // bypass what straight pieces can bypass, without leaving the route's way
  channel,   // shortest channel of the dual triangulation, pulled taut; the shortcut where it fails
};

// What a route is asked for.
struct RouteQuery {
  Vec2 start = Vec2::Zero();
  Vec2 goal = Vec2::Zero();
  Shortening shortening = Shortening::channel;
  // Judges the ways from a start or to a goal that is too close to a site already; without it they
  // are blocked.
  MotionCheck motion_is_clear;
};

struct Route {
  enum class Verdict {
    found,
    start_closed,   // proved: no way leads from the start to the rest of the graph
    goal_closed,    // proved: the same for the goal
    not_connected,  // proved: start and goal lie in different parts of the free space
    unproven,       // no way was found, but the start or the goal is too close to a site
  };

  Verdict verdict = Verdict::unproven;
  std::vector<Vec2> points;  // from start to goal, empty unless found
  double length_m = 0;

  bool proved_no_path() const {
    return verdict == Verdict::start_closed || verdict == Verdict::goal_closed ||
           verdict == Verdict::not_connected;
  }
};

std::string_view reason(Route::Verdict verdict);

// Routes for a disc's centre among points, inside bounds, on one snapshot after another.
//
// Complete at its clearance, up to rounding: points are rounded to a lattice (delaunay.h), and the
// radius used is clearance_min_m + kMargin_m, so that no route is ever closer than clearance_min_m
// to a point as given, while passages narrower than 2 (clearance_min_m + 2 kMargin_m) may count as
// closed. What is known or asked for farther apart than 6 km takes a coarser lattice and twice that
// margin, four times from 13 km on; 26 km is the limit.
class VoronoiRouter {
 public:
  static constexpr double kMargin_m = 1e-5;

  // The points known from now on, an area that the centre must not leave (any size, infinite too),
  // and places that will be asked for. If the points continue those of the latest call, with the
  // same bounds and clearance, only the new ones are worked in: O(new points); else the diagram is
  // built anew: O(n log n) expected for points in random order, near O(n) for points in the order
  // of a scan. Points too far outside the bounds to matter are left out.
  void observe(std::span<const Vec2> points, const Bounds& bounds, double clearance_min_m,
               std::span<const Vec2> places);
  void clear();

  // The start and the goal must be among the places and within the bounds.
  Route route(const RouteQuery& query);
  // The same, but any place within tolerance_m of the goal will do if the goal itself cannot be
  // reached: the closest one. "No path" then speaks of all of them.
  Route route_near(const RouteQuery& query, double tolerance_m);

  // Brought up to date by route() unless the straight line was free; by this in any case.
  const VoronoiGraph& graph();
  const DelaunayTriangulation& delaunay() const { return delaunay_; }
  const SiteCells& cells() const { return cells_; }

  std::size_t rebuilds() const { return rebuilds_; }

 private:
  struct Approach {
    Retraction retraction;
    std::vector<Lead> leads;
    bool relaxed = false;
  };

  double margin_m(const Bounds& domain) const;
  Bounds domain_for(std::span<const Vec2> points, std::span<const Vec2> places) const;
  void rebuild(std::span<const Vec2> points);
  void add(const Vec2& p);
  Approach approach(const Vec2& p, const MotionCheck& motion_is_clear) const;
  bool shares_piece(const Approach& a, const Approach& b) const;
  bool along_graph(const RouteQuery& query, const Approach& from, const Approach& to,
                   std::vector<Vec2>& points);
  void shorten(const RouteQuery& query, const Approach& from, const Approach& to,
               std::vector<Vec2>& points);
  std::vector<Vec2> shortened(Shortening how, const std::vector<Vec2>& path);
  Route::Verdict verdict_of_failure(const Approach& from, const Approach& to, const Vec2& start,
                                    const Vec2& goal);
  // Of an end without leads: `verdict`, unless the relaxed other end is so close that it may hide
  // one.
  Route::Verdict unless_hidden(Route::Verdict verdict, const Approach& closed,
                               const Approach& other, const Vec2& other_end) const;
  bool leads_to_reached(const Approach& a) const;
  bool may_touch(const Vec2& p) const;
  bool is_close(SiteId s, const Vec2& p) const;

  Bounds bounds_{Vec2::Zero(), Vec2::Zero()};
  Bounds domain_{Vec2::Zero(), Vec2::Zero()};
  double clearance_min_m_ = 0;
  double radius_m_ = 0;
  std::vector<Vec2> points_;
  DelaunayTriangulation delaunay_;
  SiteCells cells_;
  VoronoiGraph graph_;
  bool graph_is_current_ = false;
  GraphSearch search_;
  GraphSearch::Result found_;
  ChannelSearch channels_;
  std::size_t rebuilds_ = 0;
};

}  // namespace voronaut
