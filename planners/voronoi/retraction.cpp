#include "voronaut/planners/voronoi/retraction.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace voronaut {
namespace {

// How far p can go along a direction until it leaves the box.
double way_out_m(const Bounds& box, const Vec2& p, const Vec2& direction) {
  double way_m = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 2; ++axis) {
    if (direction[axis] > 0)
      way_m = std::min(way_m, (box.max[axis] - p[axis]) / direction[axis]);
    else if (direction[axis] < 0)
      way_m = std::min(way_m, (box.min[axis] - p[axis]) / direction[axis]);
  }
  return way_m;
}

// The point of the box's border that is closest to p, for a p that lies on it but for rounding.
Vec2 onto_border(const Bounds& box, Vec2 p) {
  p = p.cwiseMax(box.min).cwiseMin(box.max);
  int best_axis = 0;
  double best = std::numeric_limits<double>::infinity(), value = 0;
  for (int axis = 0; axis < 2; ++axis)
    for (const double side : {box.min[axis], box.max[axis]})
      if (std::fabs(p[axis] - side) < best) {
        best = std::fabs(p[axis] - side);
        best_axis = axis;
        value = side;
      }
  p[best_axis] = value;
  return p;
}

}  // namespace

Retraction retract(const DelaunayTriangulation& delaunay, const VoronoiGraph& graph,
                   const Vec2& p) {
  Retraction r;
  r.site = delaunay.nearest_site(p);
  const Vec2& a = delaunay.site(r.site);
  const Vec2 from_site = p - a;
  r.clearance_m = from_site.norm();
  const Vec2 away = r.clearance_m > 0 ? Vec2(from_site / r.clearance_m) : Vec2(Vec2::UnitX());
  // The ray p + t away meets the bisector of a and b where (p + t away - a).(b - a) = |b - a|^2/2.
  double way_m = std::numeric_limits<double>::infinity();
  HalfEdgeId crossed = -1;
  delaunay.for_each_leaving(r.site, [&](HalfEdgeId h) {
    for (const HalfEdgeId edge : {h, DelaunayTriangulation::previous(h)}) {
      const SiteId other =
          delaunay.origin(edge) == r.site ? delaunay.target(edge) : delaunay.origin(edge);
      const Vec2 to_other = delaunay.site(other) - a;
      const double speed = away.dot(to_other);
      if (speed <= 0) continue;
      const double t =
          std::max(0.0, (0.5 * to_other.squaredNorm() - from_site.dot(to_other)) / speed);
      if (t < way_m) {
        way_m = t;
        crossed = edge;
      }
    }
  });
  const double to_border_m = way_out_m(graph.domain(), p, away);
  if (crossed >= 0 && way_m < to_border_m && graph.dual(crossed)[0] >= 0) {
    r.landing = p + way_m * away;
    r.ends = graph.dual(crossed);
    r.sites = {delaunay.origin(crossed), delaunay.target(crossed)};
    return r;
  }
  r.landing = onto_border(graph.domain(), p + to_border_m * away);
  const VoronoiGraph::BorderPiece& piece = graph.border_piece(r.landing);
  r.ends = {piece.from, piece.to};
  r.sites = {piece.site, piece.site};
  return r;
}

std::vector<Lead> leads(const VoronoiGraph& graph, const Retraction& r, const Vec2& p) {
  std::vector<Lead> found;
  for (const VertexId v : r.ends) {
    const Vec2& end = graph.vertices()[v];
    if (!graph.is_clear(r.landing, end, r.sites[0]) || !graph.is_clear(r.landing, end, r.sites[1]))
      continue;
    found.push_back({{p, r.landing, end}, v, (r.landing - p).norm() + (end - r.landing).norm()});
  }
  return found;
}

namespace {

using Neighbours = std::map<VertexId, std::vector<VertexId>>;

// The cut diagram near p, as far as motion_is_clear admits it.
Neighbours admitted_near(const Vec2& p, const DelaunayTriangulation& delaunay,
                         const VoronoiGraph& graph, const MotionCheck& motion_is_clear) {
  const double reach_m = 2 * graph.radius_m();
  Neighbours admitted;
  const auto admit = [&](VertexId u, VertexId v) {
    const Vec2 &a = graph.vertices()[u], &b = graph.vertices()[v];
    if (u == v || distance(p, Segment{a, b}) > reach_m || !motion_is_clear(a, b)) return;
    admitted[u].push_back(v);
    admitted[v].push_back(u);
  };
  const auto half_edges = static_cast<HalfEdgeId>(3 * delaunay.triangle_count());
  for (HalfEdgeId h = 0; h < half_edges; ++h)
    if (delaunay.twin(h) < h && graph.dual(h)[0] >= 0) admit(graph.dual(h)[0], graph.dual(h)[1]);
  for (const VoronoiGraph::BorderPiece& piece : graph.border()) admit(piece.from, piece.to);
  return admitted;
}

}  // namespace

std::vector<Lead> relaxed_leads(const DelaunayTriangulation& delaunay, const VoronoiGraph& graph,
                                const Retraction& r, const Vec2& p,
                                const MotionCheck& motion_is_clear) {
  if (!motion_is_clear(p, r.landing)) return {};
  Neighbours admitted = admitted_near(p, delaunay, graph, motion_is_clear);
  std::vector<Lead> found;
  for (const VertexId v : r.ends)
    if (motion_is_clear(r.landing, graph.vertices()[v]))
      found.push_back({{p, r.landing, graph.vertices()[v]}, v, 0});
  for (std::size_t i = 0; i < found.size(); ++i) {
    for (const VertexId v : admitted[found[i].vertex]) {
      const auto same = [&](const Lead& lead) { return lead.vertex == v; };
      if (std::any_of(found.begin(), found.end(), same)) continue;
      Lead longer = found[i];
      longer.points.push_back(graph.vertices()[v]);
      longer.vertex = v;
      found.push_back(std::move(longer));
    }
  }
  for (Lead& lead : found)
    for (std::size_t i = 1; i < lead.points.size(); ++i)
      lead.length_m += (lead.points[i] - lead.points[i - 1]).norm();
  return found;
}

}  // namespace voronaut
