#include "voronaut/planners/voronoi/voronoi_router.h"

#include <algorithm>
#include <cmath>

#include "voronaut/planners/voronoi/free_places.h"
#include "voronaut/planners/voronoi/string_pulling.h"

namespace voronaut {
namespace {

// Pieces of a shortened route touch circles of the radius used; they are checked against one that
// is smaller by this, and still larger than the clearance plus the rounding of a point.
constexpr double kCheckMargin_m = 1e-6;
static_assert(VoronoiRouter::kMargin_m - kCheckMargin_m >
              DelaunayTriangulation::kRounding * DelaunayTriangulation::kQuantum_m + 1e-6);

// Places on the circle about a point are pushed off it by this, not to be within it by rounding.
constexpr double kPlaceMargin_m = 1e-6;

// Bounds up to this half extent are the domain as they are; larger ones are cut to what is known.
constexpr double kLargeHalfExtent_m = 1000;

Bounds common(const Bounds& a, const Bounds& b) {
  return {a.min.cwiseMax(b.min), a.max.cwiseMin(b.max)};
}

std::vector<Terminal> terminals(const std::vector<Lead>& leads) {
  std::vector<Terminal> all;
  all.reserve(leads.size());
  for (const Lead& lead : leads) all.push_back({lead.vertex, lead.length_m});
  return all;
}

}  // namespace

std::string_view reason(Route::Verdict verdict) {
  switch (verdict) {
    case Route::Verdict::found:
      return "a path was found";
    case Route::Verdict::start_closed:
      return "the start is enclosed by known obstacles at the clearance asked for";
    case Route::Verdict::goal_closed:
      return "the goal is enclosed by known obstacles at the clearance asked for";
    case Route::Verdict::not_connected:
      return "known obstacles separate start and goal at the clearance asked for";
    case Route::Verdict::unproven:
      break;
  }
  return "no path was found; the start or the goal is closer to an obstacle than the clearance";
}

void VoronoiRouter::clear() {
  points_.clear();
  planning_clearance_m_ = 0;
  graph_is_current_ = false;
}

void VoronoiRouter::observe(std::span<const Vec2> points, const Bounds& bounds,
                            double planning_clearance_m, std::span<const Vec2> places) {
  const bool continues = planning_clearance_m == planning_clearance_m_ &&
                         bounds.min == bounds_.min && bounds.max == bounds_.max &&
                         points.size() >= points_.size() &&
                         std::equal(points_.begin(), points_.end(), points.begin());
  bounds_ = bounds;
  planning_clearance_m_ = planning_clearance_m;
  const Bounds domain = domain_for(points, places);
  radius_m_ = planning_clearance_m + margin_m(domain);
  if (!continues || domain.min != domain_.min || domain.max != domain_.max) {
    domain_ = domain;
    rebuild(points);
    return;
  }
  if (points.size() == points_.size()) return;
  for (const Vec2& p : points.subspan(points_.size())) add(p);
  points_.assign(points.begin(), points.end());
  graph_is_current_ = false;
}

// The area that decides: the bounds, or what is known of very large ones and a ring around it.
// Whoever leaves that ring may as well follow it. Depends on its arguments only, and seldom changes
// when little is added: its sides lie on a grid of its own size.
Bounds VoronoiRouter::domain_for(std::span<const Vec2> points, std::span<const Vec2> places) const {
  if ((0.5 * (bounds_.max - bounds_.min)).maxCoeff() <= kLargeHalfExtent_m) return bounds_;
  const double reach_m = planning_clearance_m_ + kMargin_m;
  const Bounds matters = grown(bounds_, reach_m);
  Bounds box{places.front(), places.front()};
  const auto include = [&](const Vec2& p) { box = {box.min.cwiseMin(p), box.max.cwiseMax(p)}; };
  for (const Vec2& p : places) include(p);
  for (const Vec2& p : points)
    if (matters.contains(p)) include(p);
  box = grown(box, 4 * reach_m);
  int exponent = 0;
  std::frexp((box.max - box.min).maxCoeff(), &exponent);
  const double cell_m = std::ldexp(1.0, exponent);
  return common(bounds_, {Vec2((box.min / cell_m).array().floor() * cell_m),
                          Vec2((box.max / cell_m).array().ceil() * cell_m)});
}

// As many times kMargin_m as the lattice of such a domain is coarser than the finest.
double VoronoiRouter::margin_m(const Bounds& domain) const {
  const double half_frame_m =
      0.75 * (domain.max - domain.min).maxCoeff() + 4 * (planning_clearance_m_ + 4 * kMargin_m);
  return kMargin_m *
         (DelaunayTriangulation::quantum_m(half_frame_m) / DelaunayTriangulation::kQuantum_m);
}

void VoronoiRouter::rebuild(std::span<const Vec2> points) {
  ++rebuilds_;
  const Vec2 size = domain_.max - domain_.min;
  // Corners far enough to bind nothing, and to leave room for points just outside the domain.
  delaunay_.reset(grown(domain_, 0.25 * size.maxCoeff() + 4 * radius_m_));
  cells_.reset(grown(domain_, radius_m_), radius_m_);
  for (const Vec2& p : points) add(p);
  points_.assign(points.begin(), points.end());
  graph_is_current_ = false;
}

void VoronoiRouter::add(const Vec2& p) {
  if (!grown(domain_, radius_m_).contains(p)) return;
  const std::size_t before = delaunay_.site_count();
  const SiteId s = delaunay_.insert(p);
  if (delaunay_.site_count() > before) cells_.add(delaunay_.site(s));
}

const VoronoiGraph& VoronoiRouter::graph() {
  if (!graph_is_current_) graph_.build(delaunay_, domain_, radius_m_);
  graph_is_current_ = true;
  return graph_;
}

Route VoronoiRouter::route(const RouteQuery& query) {
  Route route;
  if (cells_.swept_disc_is_clear(query.start, query.goal, radius_m_) ||
      (query.motion_is_clear && query.motion_is_clear(query.start, query.goal))) {
    route.points = {query.start, query.goal};
  } else {
    graph();
    const Approach from = approach(query.start, query.motion_is_clear);
    const Approach to = approach(query.goal, query.motion_is_clear);
    if (!along_graph(query, from, to, route.points)) {
      route.verdict = verdict_of_failure(from, to, query.start, query.goal);
      return route;
    }
    shorten(query, from, to, route.points);
  }
  route.verdict = Route::Verdict::found;
  route.length_m = length_m(route.points);
  return route;
}

Route VoronoiRouter::route_near(const RouteQuery& query, double tolerance_m) {
  Route at_goal = route(query);
  if (at_goal.verdict == Route::Verdict::found || tolerance_m <= 0) return at_goal;
  const auto sites = delaunay_.sites().subspan(DelaunayTriangulation::kFrameSites);
  const std::vector<Vec2> places =
      closest_free_places(sites, domain_, query.goal, tolerance_m, radius_m_, kPlaceMargin_m);
  const Approach from = approach(query.start, query.motion_is_clear);
  std::vector<Approach> ways;
  ways.reserve(places.size());
  for (const Vec2& place : places) ways.push_back(approach(place, {}));

  // One flood from the start tells which of them can be reached.
  search_.run(graph_, terminals(from.leads), {}, query.goal, found_);
  const auto reachable = std::find_if(ways.begin(), ways.end(), [&](const Approach& to) {
    return shares_piece(from, to) || leads_to_reached(to);
  });
  if (reachable != ways.end()) {
    RouteQuery closer = query;
    closer.goal = places[reachable - ways.begin()];
    return route(closer);
  }
  at_goal.verdict = Route::Verdict::goal_closed;
  for (std::size_t i = 0; i < ways.size(); ++i) {
    at_goal.verdict = verdict_of_failure(from, ways[i], query.start, places[i]);
    if (at_goal.verdict == Route::Verdict::unproven) break;
  }
  return at_goal;
}

VoronoiRouter::Approach VoronoiRouter::approach(const Vec2& p,
                                                const MotionCheck& motion_is_clear) const {
  Approach a;
  a.retraction = retract(delaunay_, graph_, p);
  a.relaxed = a.retraction.clearance_m < radius_m_;
  if (!a.relaxed)
    a.leads = leads(graph_, a.retraction, p);
  else if (motion_is_clear)
    a.leads = relaxed_leads(delaunay_, graph_, a.retraction, p, motion_is_clear);
  return a;
}

// Whether both land on the same edge with nothing between them.
bool VoronoiRouter::shares_piece(const Approach& a, const Approach& b) const {
  const Retraction &s = a.retraction, &g = b.retraction;
  return !a.relaxed && !b.relaxed && s.ends == g.ends &&
         graph_.is_clear(s.landing, g.landing, s.sites[0]) &&
         graph_.is_clear(s.landing, g.landing, s.sites[1]);
}

bool VoronoiRouter::along_graph(const RouteQuery& query, const Approach& from, const Approach& to,
                                std::vector<Vec2>& points) {
  const Retraction &s = from.retraction, &g = to.retraction;
  if (shares_piece(from, to)) {
    points = {query.start, s.landing, g.landing, query.goal};
    return true;
  }
  if (from.leads.empty() || to.leads.empty()) return false;
  if (!search_.run(graph_, terminals(from.leads), terminals(to.leads), query.goal, found_))
    return false;
  points = from.leads[found_.start].points;
  for (std::size_t i = 1; i < found_.vertices.size(); ++i)
    points.push_back(graph_.vertices()[found_.vertices[i]]);
  const std::vector<Vec2>& tail = to.leads[found_.goal].points;
  points.insert(points.end(), tail.rbegin() + 1, tail.rend());
  return true;
}

// The ways out of and into places that are too close to a site stay as they are; what lies between
// them is shortened, and the ways are then bypassed as far as their own rules allow.
void VoronoiRouter::shorten(const RouteQuery& query, const Approach& from, const Approach& to,
                            std::vector<Vec2>& points) {
  if (query.shortening == Shortening::none) return;
  const std::size_t lead = from.relaxed ? from.leads[found_.start].points.size() - 1 : 0;
  const std::size_t tail = to.relaxed ? to.leads[found_.goal].points.size() - 1 : 0;
  if (lead + tail >= points.size()) return;
  const auto body_end = points.end() - static_cast<std::ptrdiff_t>(tail);
  std::vector<Vec2> body(points.begin() + static_cast<std::ptrdiff_t>(lead), body_end);
  body = shortened(query.shortening, body);
  std::vector<Vec2> whole(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(lead));
  whole.insert(whole.end(), body.begin(), body.end());
  whole.insert(whole.end(), body_end, points.end());
  if (from.relaxed) {
    std::size_t next = whole.size() - 1;
    while (next > 1 && !query.motion_is_clear(whole.front(), whole[next])) --next;
    whole.erase(whole.begin() + 1, whole.begin() + static_cast<std::ptrdiff_t>(next));
  }
  if (to.relaxed) {
    std::size_t last = 0;
    while (last + 2 < whole.size() && !query.motion_is_clear(whole[last], whole.back())) ++last;
    whole.erase(whole.begin() + static_cast<std::ptrdiff_t>(last) + 1, whole.end() - 1);
  }
  points.swap(whole);
}

std::vector<Vec2> VoronoiRouter::shortened(Shortening how, const std::vector<Vec2>& path) {
  const StringObstacles around{delaunay_, cells_, domain_, radius_m_, radius_m_ - kCheckMargin_m};
  std::vector<Vec2> best = shorten_by_shortcuts(around, path);
  if (how == Shortening::shortcut) return best;
  const auto channel = channels_.find(delaunay_, domain_, radius_m_, path.front(), path.back(),
                                      length_m(best) + kMargin_m);
  if (!channel) return best;
  auto taut = pull_string(around, *channel, path.front(), path.back());
  return taut && length_m(*taut) < length_m(best) ? std::move(*taut) : best;
}

Route::Verdict VoronoiRouter::verdict_of_failure(const Approach& from, const Approach& to,
                                                 const Vec2& start, const Vec2& goal) {
  if (!from.relaxed && from.leads.empty())
    return unless_hidden(Route::Verdict::start_closed, from, to, goal);
  if (!to.relaxed && to.leads.empty())
    return unless_hidden(Route::Verdict::goal_closed, to, from, start);
  if (!from.relaxed && !to.relaxed) return Route::Verdict::not_connected;
  if (from.relaxed && to.relaxed) return Route::Verdict::unproven;
  // One end has the full clearance: whatever is connected with it stays away from the other end's
  // surroundings, or nothing is proved.
  const Approach& sound = from.relaxed ? to : from;
  const Vec2& relaxed = from.relaxed ? start : goal;
  search_.run(graph_, terminals(sound.leads), {}, relaxed, found_);
  return may_touch(relaxed) ? Route::Verdict::unproven : Route::Verdict::not_connected;
}

Route::Verdict VoronoiRouter::unless_hidden(Route::Verdict verdict, const Approach& closed,
                                            const Approach& other, const Vec2& other_end) const {
  const auto& sites = closed.retraction.sites;
  const bool close =
      other.relaxed && (is_close(sites[0], other_end) || is_close(sites[1], other_end));
  return close ? Route::Verdict::unproven : verdict;
}

// Points of the disc of one clearance around p retract onto edges of cells that intersect it; the
// sites of such cells are no farther from p than three radii.
bool VoronoiRouter::is_close(SiteId s, const Vec2& p) const {
  return (delaunay_.site(s) - p).norm() <= 3 * radius_m_;
}

bool VoronoiRouter::leads_to_reached(const Approach& a) const {
  return std::any_of(a.leads.begin(), a.leads.end(),
                     [this](const Lead& lead) { return search_.reached(lead.vertex); });
}

bool VoronoiRouter::may_touch(const Vec2& p) const {
  const auto half_edges = static_cast<HalfEdgeId>(3 * delaunay_.triangle_count());
  for (HalfEdgeId h = 0; h < half_edges; ++h) {
    if (!is_close(delaunay_.origin(h), p)) continue;
    for (const VertexId v : graph_.dual(h))
      if (v >= 0 && search_.reached(v)) return true;
  }
  const auto border = graph_.border();
  return std::any_of(border.begin(), border.end(), [&](const VoronoiGraph::BorderPiece& piece) {
    return is_close(piece.site, p) && (search_.reached(piece.from) || search_.reached(piece.to));
  });
}

}  // namespace voronaut
