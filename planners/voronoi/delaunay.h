#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "voronaut/environments/shapes/geometry.h"

// Delaunay triangulation of points that become known one after another: insertion and Lawson's edge
// flips (Guibas and Stolfi, ACM TOG 4(2), 1985, https://doi.org/10.1145/282918.282923). Its dual is
// the Voronoi diagram. A snapshot that grew by a few points costs a few insertions, not a rebuild.
//
// Exact: points are rounded to a lattice relative to a local origin, so every predicate has integer
// arguments; a floating-point filter answers most, 128-bit integers the rest. Points that round to
// the same place are one site. The lattice's step is kQuantum_m for frames up to 10 km wide, and
// twice or four times that for those up to 20 and 40 km.
namespace voronaut {

using SiteId = std::int32_t;
using HalfEdgeId = std::int32_t;  // 3 t + k: the k-th edge of triangle t, which lies to its left
using TriangleId = std::int32_t;

class DelaunayTriangulation {
 public:
  static constexpr double kQuantum_m = 1e-5;
  // In quanta: how far rounding moves a point at most.
  static constexpr double kRounding = 0.5001 * 1.41421356237309515;
  // Half the side of the largest frame of the finest lattice, in quanta: products of three
  // differences must fit 128 bits.
  static constexpr double kMaxHalfExtent = 5e8;
  static constexpr double kMaxHalfExtent_m = 4 * kMaxHalfExtent * kQuantum_m;
  static constexpr SiteId kFrameSites = 4;

  // An empty frame: two triangles between its corners, which are the sites 0 to 3. The lattice's
  // origin is the centre of the frame. Throws std::invalid_argument if the frame is too large.
  void reset(const Bounds& frame);

  // The step of the lattice for a frame of this half side.
  static double quantum_m(double half_extent_m) {
    double quantum_m = kQuantum_m;
    while (half_extent_m > kMaxHalfExtent * quantum_m && quantum_m < 4 * kQuantum_m) quantum_m *= 2;
    return quantum_m;
  }
  double quantum_m() const { return quantum_m_; }

  // Site of a point strictly inside the frame; an old one if they coincide after rounding. Expected
  // O(1) flips, and a walk from the place of the latest insertion.
  SiteId insert(const Vec2& p);

  // Where a point lies after rounding to the lattice.
  Vec2 rounded(const Vec2& p) const;
  // A triangle that contains the rounded point (on an edge: either).
  TriangleId locate(const Vec2& p) const;
  // Closest site to the rounded point, frame corners included.
  SiteId nearest_site(const Vec2& p) const;

  const Bounds& frame() const { return frame_; }
  bool is_frame(SiteId s) const { return s < kFrameSites; }
  std::size_t site_count() const { return site_.size(); }
  const Vec2& site(SiteId s) const { return site_[s]; }
  std::span<const Vec2> sites() const { return site_; }

  std::size_t triangle_count() const { return origin_.size() / 3; }
  SiteId origin(HalfEdgeId h) const { return origin_[h]; }
  SiteId target(HalfEdgeId h) const { return origin_[next(h)]; }
  SiteId apex(HalfEdgeId h) const { return origin_[previous(h)]; }
  HalfEdgeId twin(HalfEdgeId h) const { return twin_[h]; }    // -1 on the hull of the frame
  HalfEdgeId leaving(SiteId s) const { return leaving_[s]; }  // one half-edge that starts there
  static HalfEdgeId next(HalfEdgeId h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static HalfEdgeId previous(HalfEdgeId h) { return h % 3 == 0 ? h + 2 : h - 1; }
  static TriangleId triangle(HalfEdgeId h) { return h / 3; }

  // Centre of the circle through the corners of a triangle: the Voronoi vertex it stands for.
  // Relative error of the order of 1e-16 (exact numerators); far away for flat triangles.
  // Remembered until the triangle changes.
  const Vec2& circumcenter(TriangleId t) const;

  // Differs from that of every other triangle, and from what it was before the corners or their
  // order changed.
  std::uint64_t state(TriangleId t) const { return state_[t]; }

  // Calls f(half-edge leaving s) around a site, counter-clockwise; all of them for a site that is
  // no frame corner.
  template <class F>
  void for_each_leaving(SiteId s, F&& f) const {
    const HalfEdgeId first = leaving_[s];
    HalfEdgeId h = first;
    do {
      f(h);
      h = twin_[previous(h)];
    } while (h >= 0 && h != first);
    if (h >= 0) return;
    for (h = twin_[first]; h >= 0; h = twin_[h]) {
      h = next(h);
      f(h);
    }
  }

 private:
  struct Lattice {
    std::int32_t x;
    std::int32_t y;
    bool operator==(const Lattice&) const = default;
  };

  Lattice to_lattice(const Vec2& p) const;
  SiteId add_site(const Lattice& q);
  TriangleId add_triangle(SiteId a, SiteId b, SiteId c);
  void link(HalfEdgeId a, HalfEdgeId b);
  HalfEdgeId locate(const Lattice& q, TriangleId from) const;
  void legalise(HalfEdgeId h);
  void flip(HalfEdgeId h);
  bool must_flip(HalfEdgeId h) const;
  void touch(TriangleId t) {
    center_known_[t] = 0;
    state_[t] = ++states_;
  }
  Vec2 compute_circumcenter(TriangleId t) const;

  Bounds frame_{Vec2::Zero(), Vec2::Zero()};
  Vec2 origin_world_ = Vec2::Zero();
  double quantum_m_ = kQuantum_m;
  std::vector<Lattice> lattice_;
  std::vector<Vec2> site_;
  std::vector<HalfEdgeId> leaving_;
  std::vector<SiteId> origin_;
  std::vector<HalfEdgeId> twin_;
  mutable std::vector<Vec2> center_;
  mutable std::vector<char> center_known_;
  std::vector<std::uint64_t> state_;
  std::uint64_t states_ = 0;  // given out, before a reset() too
  std::vector<HalfEdgeId> stack_;
  TriangleId latest_ = 0;
};

}  // namespace voronaut
