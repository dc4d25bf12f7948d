#include "voronaut/planners/voronoi/delaunay.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include "voronaut/planners/voronoi/lattice_predicates.h"

namespace voronaut {

void DelaunayTriangulation::reset(const Bounds& frame) {
  const Vec2 half = 0.5 * (frame.max - frame.min);
  if (!(half.x() > kQuantum_m && half.y() > kQuantum_m && half.maxCoeff() <= kMaxHalfExtent_m))
    throw std::invalid_argument("the area of a Voronoi diagram measures " +
                                std::to_string(2 * half.x()) + " m x " +
                                std::to_string(2 * half.y()) + " m; allowed: more than 0, up to " +
                                std::to_string(2 * kMaxHalfExtent_m) + " m each way");
  origin_world_ = 0.5 * (frame.min + frame.max);
  quantum_m_ = quantum_m(half.maxCoeff());
  lattice_.clear();
  site_.clear();
  leaving_.clear();
  origin_.clear();
  twin_.clear();
  center_.clear();
  center_known_.clear();
  state_.clear();
  latest_ = 0;

  const Lattice lo = to_lattice(frame.min);
  const Lattice hi = to_lattice(frame.max);
  add_site(lo);
  add_site({hi.x, lo.y});
  add_site(hi);
  add_site({lo.x, hi.y});
  frame_ = {site_[0], site_[2]};
  const TriangleId below = add_triangle(0, 1, 2);
  const TriangleId above = add_triangle(0, 2, 3);
  link(3 * below + 2, 3 * above);
}

SiteId DelaunayTriangulation::insert(const Vec2& p) {
  const Lattice q = to_lattice(p);
  if (!(q.x > lattice_[0].x && q.x < lattice_[2].x && q.y > lattice_[0].y && q.y < lattice_[2].y)) {
    std::fprintf(stderr, "DelaunayTriangulation::insert: (%g, %g) is not inside the frame\n", p.x(),
                 p.y());
    std::abort();
  }
  const HalfEdgeId ab = locate(q, latest_);
  const TriangleId t = triangle(ab);
  const SiteId a = origin(ab), b = target(ab), c = apex(ab);
  for (const SiteId s : {a, b, c})
    if (lattice_[s] == q) return s;

  // Split t into (a, b, new), (b, c, new), (c, a, new). If the point lies on an edge one of them is
  // flat, and the first flip below replaces it.
  const SiteId s = add_site(q);
  const HalfEdgeId ab_twin = twin_[ab], bc_twin = twin_[next(ab)], ca_twin = twin_[previous(ab)];
  const HalfEdgeId first = 3 * t;
  origin_[first] = a;
  origin_[first + 1] = b;
  origin_[first + 2] = s;
  touch(t);
  const HalfEdgeId second = 3 * add_triangle(b, c, s);
  const HalfEdgeId third = 3 * add_triangle(c, a, s);
  leaving_[a] = first;
  leaving_[s] = first + 2;
  link(first, ab_twin);
  link(second, bc_twin);
  link(third, ca_twin);
  link(first + 1, second + 2);
  link(second + 1, third + 2);
  link(third + 1, first + 2);

  stack_.assign({first, second, third});
  while (!stack_.empty()) {
    const HalfEdgeId h = stack_.back();
    stack_.pop_back();
    legalise(h);
  }
  latest_ = triangle(leaving_[s]);
  return s;
}

Vec2 DelaunayTriangulation::rounded(const Vec2& p) const {
  const Lattice q = to_lattice(p);
  return origin_world_ + quantum_m_ * Vec2(q.x, q.y);
}

TriangleId DelaunayTriangulation::locate(const Vec2& p) const {
  return triangle(locate(to_lattice(p), latest_));
}

SiteId DelaunayTriangulation::nearest_site(const Vec2& p) const {
  const Vec2 q = rounded(p);
  SiteId best = origin_[locate(to_lattice(p), latest_)];
  double best_sq = (site_[best] - q).squaredNorm();
  // In a Delaunay triangulation every site that is not the closest has a closer neighbour.
  for (SiteId from = -1; from != best;) {
    from = best;
    for_each_leaving(from, [&](HalfEdgeId h) {
      for (const SiteId s : {target(h), apex(h)}) {
        const double sq = (site_[s] - q).squaredNorm();
        if (sq < best_sq) {
          best = s;
          best_sq = sq;
        }
      }
    });
  }
  return best;
}

const Vec2& DelaunayTriangulation::circumcenter(TriangleId t) const {
  if (!center_known_[t]) {
    center_[t] = compute_circumcenter(t);
    center_known_[t] = 1;
  }
  return center_[t];
}

DelaunayTriangulation::Lattice DelaunayTriangulation::to_lattice(const Vec2& p) const {
  const Vec2 scaled = (p - origin_world_) / quantum_m_;
  return {static_cast<std::int32_t>(std::nearbyint(scaled.x())),
          static_cast<std::int32_t>(std::nearbyint(scaled.y()))};
}

SiteId DelaunayTriangulation::add_site(const Lattice& q) {
  lattice_.push_back(q);
  site_.push_back(origin_world_ + quantum_m_ * Vec2(q.x, q.y));
  leaving_.push_back(-1);
  return static_cast<SiteId>(site_.size()) - 1;
}

TriangleId DelaunayTriangulation::add_triangle(SiteId a, SiteId b, SiteId c) {
  const auto h = static_cast<HalfEdgeId>(origin_.size());
  for (const SiteId s : {a, b, c}) {
    leaving_[s] = static_cast<HalfEdgeId>(origin_.size());
    origin_.push_back(s);
    twin_.push_back(-1);
  }
  center_.push_back(Vec2::Zero());
  center_known_.push_back(0);
  state_.push_back(++states_);
  return triangle(h);
}

void DelaunayTriangulation::link(HalfEdgeId a, HalfEdgeId b) {
  twin_[a] = b;
  if (b >= 0) twin_[b] = a;
}

HalfEdgeId DelaunayTriangulation::locate(const Lattice& q, TriangleId from) const {
  // Walk across any edge that has the point on its far side; ends for Delaunay triangulations
  // (Devillers, Pion and Teillaud, https://doi.org/10.1142/S0129054102001047).
  HalfEdgeId h = 3 * from;
  for (int clear = 0; clear < 3;) {
    if (lattice::doubled_area(lattice_[origin(h)], lattice_[target(h)], q) < 0) {
      h = next(twin_[h]);
      clear = 1;  // the point lies on the near side of the edge just crossed
    } else {
      h = next(h);
      ++clear;
    }
  }
  return h;
}

bool DelaunayTriangulation::must_flip(HalfEdgeId h) const {
  const HalfEdgeId g = twin_[h];
  if (g < 0) return false;
  const Lattice& a = lattice_[origin(h)];
  const Lattice& b = lattice_[target(h)];
  const Lattice& p = lattice_[apex(h)];
  if (lattice::doubled_area(a, b, p) == 0) return true;
  return lattice::in_circle(a, b, p, lattice_[apex(g)]);
}

void DelaunayTriangulation::legalise(HalfEdgeId h) {
  if (!must_flip(h)) return;
  const HalfEdgeId across = previous(twin_[h]);
  flip(h);
  stack_.push_back(h);
  stack_.push_back(across);
}

// The edge a-b between the triangles (a, b, p) and (b, a, d) becomes p-d. Afterwards `h` is a-d and
// the half-edge before the old twin is d-b, both opposite to p.
void DelaunayTriangulation::flip(HalfEdgeId h) {
  const HalfEdgeId g = twin_[h];
  const HalfEdgeId h_next = next(h), h_previous = previous(h);
  const HalfEdgeId g_next = next(g), g_previous = previous(g);
  const SiteId a = origin_[h], b = origin_[g], p = origin_[h_previous], d = origin_[g_previous];
  const HalfEdgeId beyond_ad = twin_[g_next], beyond_bp = twin_[h_next];
  origin_[h_next] = d;
  origin_[g] = b;
  origin_[g_next] = p;
  link(h, beyond_ad);
  link(g, beyond_bp);
  link(h_next, g_next);
  leaving_[a] = h;
  leaving_[b] = g;
  leaving_[p] = h_previous;
  leaving_[d] = g_previous;
  touch(triangle(h));
  touch(triangle(g));
}

Vec2 DelaunayTriangulation::compute_circumcenter(TriangleId t) const {
  const auto [i, j, k] = std::array{origin(3 * t), origin(3 * t + 1), origin(3 * t + 2)};
  const Lattice& a = lattice_[i];
  const Lattice& b = lattice_[j];
  const Lattice& c = lattice_[k];
  const std::int64_t bx = std::int64_t{b.x} - a.x, by = std::int64_t{b.y} - a.y;
  const std::int64_t cx = std::int64_t{c.x} - a.x, cy = std::int64_t{c.y} - a.y;
  const lattice::Int128 b_sq = bx * bx + by * by;
  const lattice::Int128 c_sq = cx * cx + cy * cy;
  const auto x = static_cast<double>(cy * b_sq - by * c_sq);
  const auto y = static_cast<double>(bx * c_sq - cx * b_sq);
  const auto divisor = 2 * static_cast<double>(bx * cy - by * cx);
  return site_[i] + quantum_m_ * Vec2(x / divisor, y / divisor);
}

}  // namespace voronaut
