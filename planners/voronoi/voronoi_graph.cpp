#include "voronaut/planners/voronoi/voronoi_graph.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "voronaut/planners/voronoi/clipping.h"

namespace voronaut {
namespace {

struct Cut {
  Vec2 p;
  Vec2 q;
  bool p_cut = false;
  bool q_cut = false;
};

// The part of p-q inside the box. An end that was cut lies on the border exactly.
std::optional<Cut> cut_to(const Bounds& box, const Vec2& p, const Vec2& q) {
  const Vec2 along = q - p;
  double enter = 0, leave = 1;
  int enter_axis = -1, leave_axis = -1;
  for (int axis = 0; axis < 2; ++axis) {
    const auto inside = clipped(p[axis], along[axis], box.min[axis], box.max[axis]);
    if (!inside) return std::nullopt;
    if (inside->first > enter) enter = inside->first, enter_axis = axis;
    if (inside->second < leave) leave = inside->second, leave_axis = axis;
  }
  if (enter > leave) return std::nullopt;
  const auto at = [&](double t, int axis, bool entering) {
    Vec2 x = p + t * along;
    x = x.cwiseMax(box.min).cwiseMin(box.max);
    x[axis] = (along[axis] > 0) == entering ? box.min[axis] : box.max[axis];
    return x;
  };
  Cut cut{p, q, enter_axis >= 0, leave_axis >= 0};
  if (cut.p_cut) cut.p = at(enter, enter_axis, true);
  if (cut.q_cut) cut.q = at(leave, leave_axis, false);
  return cut;
}

}  // namespace

void VoronoiGraph::build(const DelaunayTriangulation& delaunay, const Bounds& domain,
                         double radius_m) {
  if (delaunay_ != &delaunay || domain_.min != domain.min || domain_.max != domain.max ||
      radius_m_ != radius_m)
    seen_.clear();
  delaunay_ = &delaunay;
  domain_ = domain;
  radius_m_ = radius_m;
  vertices_.clear();
  edges_.clear();
  border_vertices_.clear();
  vertex_of_triangle_.assign(delaunay.triangle_count(), -1);
  dual_.assign(3 * delaunay.triangle_count(), {-1, -1});
  seen_.resize(3 * delaunay.triangle_count());
  const auto half_edges = static_cast<HalfEdgeId>(3 * delaunay.triangle_count());
  for (HalfEdgeId h = 0; h < half_edges; ++h)
    if (const HalfEdgeId g = delaunay.twin(h); g < h && !(g >= 0 && add_seen(g)))
      add_dual(g < 0 ? h : g);
  add_border();
  index_neighbours();
}

// An edge that has not changed since the latest build; false if it has.
bool VoronoiGraph::add_seen(HalfEdgeId h) {
  const TriangleId t = DelaunayTriangulation::triangle(h);
  const TriangleId twin = DelaunayTriangulation::triangle(delaunay_->twin(h));
  const Seen& seen = seen_[h];
  if (seen.state != delaunay_->state(t) || seen.twin_state != delaunay_->state(twin)) return false;
  const VertexId u = vertex_in(t);
  const VertexId v = vertex_in(twin);
  dual_[h] = {u, v};
  if (seen.passable) add_edge(u, v);
  return true;
}

void VoronoiGraph::add_dual(HalfEdgeId h) {
  const DelaunayTriangulation& d = *delaunay_;
  const HalfEdgeId g = d.twin(h);
  const TriangleId t = DelaunayTriangulation::triangle(h);
  const Vec2 p = d.circumcenter(t);
  const Vec2& a = d.site(d.origin(h));
  const Vec2& b = d.site(d.target(h));
  // Beyond the hull of the frame an edge goes on for ever: far enough to leave the domain.
  const Vec2 q =
      g >= 0 ? d.circumcenter(DelaunayTriangulation::triangle(g)) : Vec2(p - 4 * left_of(b - a));
  const bool p_inside = domain_.contains(p);
  const bool q_inside = domain_.contains(q);
  VertexId u = -1, v = -1;
  if (p_inside && q_inside) {
    u = vertex_in(t);
    v = vertex_in(DelaunayTriangulation::triangle(g));
  } else {
    const auto cut = cut_to(domain_, p, q);
    if (!cut) return;
    const std::array<SiteId, 2> sites{d.origin(h), d.target(h)};
    u = p_inside ? vertex_in(t) : add_border_vertex(cut->p, sites);
    v = q_inside ? vertex_in(DelaunayTriangulation::triangle(g)) : add_border_vertex(cut->q, sites);
  }
  dual_[h] = {u, v};
  const bool passable = is_clear(vertices_[u], vertices_[v], d.origin(h)) &&
                        is_clear(vertices_[u], vertices_[v], d.target(h));
  if (p_inside && q_inside)
    seen_[h] = {d.state(t), d.state(DelaunayTriangulation::triangle(g)), passable};
  if (passable) add_edge(u, v);
}

VertexId VoronoiGraph::vertex_in(TriangleId t) {
  VertexId& v = vertex_of_triangle_[t];
  if (v < 0) {
    v = static_cast<VertexId>(vertices_.size());
    vertices_.push_back(delaunay_->circumcenter(t));
  }
  return v;
}

VertexId VoronoiGraph::add_border_vertex(const Vec2& p, std::array<SiteId, 2> sites) {
  const auto v = static_cast<VertexId>(vertices_.size());
  vertices_.push_back(p);
  border_vertices_.push_back({station_m(p), v, sites});
  return v;
}

double VoronoiGraph::station_m(const Vec2& on_border) const {
  const Vec2 size = domain_.max - domain_.min;
  const Vec2 from_min = on_border - domain_.min;
  const Vec2 to_max = domain_.max - on_border;
  if (from_min.y() <= 0) return from_min.x();
  if (to_max.x() <= 0) return size.x() + from_min.y();
  if (to_max.y() <= 0) return size.x() + size.y() + to_max.x();
  return 2 * size.x() + size.y() + to_max.y();
}

void VoronoiGraph::add_border() {
  const Vec2 &lo = domain_.min, &hi = domain_.max;
  for (const Vec2& corner : {lo, Vec2(hi.x(), lo.y()), hi, Vec2(lo.x(), hi.y())})
    add_border_vertex(corner, {-1, -1});
  std::sort(border_vertices_.begin(), border_vertices_.end(),
            [](const BorderVertex& a, const BorderVertex& b) {
              return std::pair(a.station_m, a.vertex) < std::pair(b.station_m, b.vertex);
            });
  // A cell's site is named by the edges that end at the border; follow it around the corners,
  // beginning at such an edge if there is one.
  const std::size_t n = border_vertices_.size();
  std::size_t begin = 0;
  while (begin < n && border_vertices_[begin].sites[0] < 0) ++begin;
  SiteId site = begin == n ? delaunay_->nearest_site(lo) : -1;
  border_.resize(n);
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t i = (begin + k) % n;
    site = site_along(i, site);
    const VertexId u = border_vertices_[i].vertex;
    const VertexId v = border_vertices_[(i + 1) % n].vertex;
    const bool clear = is_clear(vertices_[u], vertices_[v], site);
    border_[i] = {border_vertices_[i].station_m, u, v, site, clear};
    if (clear) add_edge(u, v);
  }
}

// Site whose cell the border bounds from border vertex i to the next.
SiteId VoronoiGraph::site_along(std::size_t i, SiteId previous) const {
  const BorderVertex& from = border_vertices_[i];
  const BorderVertex& to = border_vertices_[(i + 1) % border_vertices_.size()];
  const Vec2 middle = 0.5 * (vertices_[from.vertex] + vertices_[to.vertex]);
  SiteId best = previous;
  double best_sq = 0;
  bool found = false;
  for (const SiteId s : {from.sites[0], from.sites[1], to.sites[0], to.sites[1]}) {
    if (s < 0) continue;
    const double sq = (delaunay_->site(s) - middle).squaredNorm();
    if (!found || sq < best_sq) best = s, best_sq = sq;
    found = true;
  }
  return best;
}

const VoronoiGraph::BorderPiece& VoronoiGraph::border_piece(const Vec2& on_border) const {
  const double station = station_m(on_border);
  const auto after = std::upper_bound(
      border_.begin(), border_.end(), station,
      [](double value, const BorderPiece& piece) { return value < piece.station_m; });
  return after == border_.begin() ? border_.back() : *(after - 1);
}

bool VoronoiGraph::is_clear(const Vec2& p, const Vec2& q, SiteId s) const {
  const Vec2& c = delaunay_->site(s);
  return (c - closest_point(c, Segment{p, q})).squaredNorm() >= radius_m_ * radius_m_;
}

void VoronoiGraph::add_edge(VertexId u, VertexId v) {
  if (u != v) edges_.push_back({u, v, (vertices_[u] - vertices_[v]).norm()});
}

void VoronoiGraph::index_neighbours() {
  first_.assign(vertices_.size() + 2, 0);
  for (const Edge& e : edges_) ++first_[e.u + 2], ++first_[e.v + 2];
  for (std::size_t v = 2; v < first_.size(); ++v) first_[v] += first_[v - 1];
  neighbours_.resize(2 * edges_.size());
  for (const Edge& e : edges_) {
    neighbours_[first_[e.u + 1]++] = {e.v, e.length_m};
    neighbours_[first_[e.v + 1]++] = {e.u, e.length_m};
  }
}

}  // namespace voronaut
