#include "voronaut/environments/shortest_path/narrowest_passage.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace voronaut {
namespace {

// A circle, or an edge of radius 0.
struct Grown {
  Segment core;
  double radius_m;
};

// Chains of obstacles: which are linked, and whether the way between two crosses the line from
// start to goal an odd number of times.
class ParityChains {
 public:
  explicit ParityChains(std::size_t n) : parent_(n), odd_(n, false) {
    std::iota(parent_.begin(), parent_.end(), 0U);
  }

  struct Root {
    std::uint32_t root;
    bool odd;  // the way to the root
  };
  Root find(std::uint32_t i) {
    bool odd = false;
    std::uint32_t root = i;
    for (; parent_[root] != root; root = parent_[root]) odd = odd != odd_[root];
    bool rest = odd;
    while (i != root) {  // straight to the root from now on
      const std::uint32_t next = std::exchange(parent_[i], root);
      const bool step = odd_[i];
      odd_[i] = rest;
      rest = rest != step;
      i = next;
    }
    return {root, odd};
  }

  // False if the link closes an odd chain.
  bool link(std::uint32_t i, std::uint32_t j, bool odd) {
    const Root a = find(i);
    const Root b = find(j);
    if (a.root == b.root) return (a.odd != b.odd) == odd;
    parent_[a.root] = b.root;
    odd_[a.root] = (a.odd != b.odd) != odd;
    return true;
  }

 private:
  std::vector<std::uint32_t> parent_;
  std::vector<bool> odd_;
};

// Where two segments come closest, on each of them.
std::pair<Vec2, Vec2> closest_points(const Segment& s, const Segment& t) {
  const Vec2 along_s = s.b - s.a;
  const Vec2 along_t = t.b - t.a;
  const double turn = cross(along_s, along_t);
  if (turn != 0) {
    const double at_s = cross(t.a - s.a, along_t) / turn;
    const double at_t = cross(t.a - s.a, along_s) / turn;
    if (at_s >= 0 && at_s <= 1 && at_t >= 0 && at_t <= 1) {
      const Vec2 crossing = s.a + at_s * along_s;
      return {crossing, crossing};
    }
  }
  std::pair<Vec2, Vec2> closest{s.a, closest_point(s.a, t)};
  for (const auto& candidate :
       {std::pair(s.b, closest_point(s.b, t)), std::pair(closest_point(t.a, s), t.a),
        std::pair(closest_point(t.b, s), t.b)})
    if ((candidate.first - candidate.second).squaredNorm() <
        (closest.first - closest.second).squaredNorm())
      closest = candidate;
  return closest;
}

class NarrowestPassage {
 public:
  NarrowestPassage(const World& world, const Vec2& start, const Vec2& goal)
      : world_(world), start_(start), goal_(goal), chains_(0) {
    for (const Circle& c : world.index().circles())
      obstacles_.push_back({{c.center, c.center}, c.radius_m});
    for (const Segment& edge : world.index().edges()) obstacles_.push_back({edge, 0});
    outside_ = static_cast<std::uint32_t>(obstacles_.size());
    chains_ = ParityChains(obstacles_.size() + 1);
  }

  // Looks at ever wider gaps: mostly a narrow one decides.
  double radius_m() {
    const double most_m = std::min(world_.clearance_m(start_), world_.clearance_m(goal_));
    if (most_m <= 0 || !world_.bounds().contains(start_) || !world_.bounds().contains(goal_))
      return 0;
    if (std::isinf(most_m)) return most_m;
    double from_m = -1;
    for (double to_m = most_m / 256; from_m < most_m; from_m = to_m, to_m *= 2) {
      for (const Link& link : links_between(from_m, std::min(to_m, most_m)))
        if (!chains_.link(link.i, link.j, link.odd)) return link.radius_m;
    }
    return most_m;
  }

 private:
  // Two obstacles that touch when they are grown by the radius.
  struct Link {
    double radius_m;
    std::uint32_t i, j;
    bool odd;
  };

  // Whether the line p-q crosses the one from start to goal. A point on the latter counts to its
  // right, whichever line it is the end of.
  bool crosses(const Vec2& p, const Vec2& q) const {
    const Vec2 along = goal_ - start_;
    if ((cross(along, p - start_) > 0) == (cross(along, q - start_) > 0)) return false;
    return (cross(q - p, start_ - p) > 0) != (cross(q - p, goal_ - p) > 0);
  }

  Link link(std::uint32_t i, std::uint32_t j) const {
    const Grown& a = obstacles_[i];
    const Grown& b = obstacles_[j];
    const auto [p, q] = closest_points(a.core, b.core);
    const double gap_m = std::max(0.0, (p - q).norm() - a.radius_m - b.radius_m);
    const bool odd = (crosses(a.core.a, p) != crosses(p, q)) != crosses(q, b.core.a);
    return {gap_m / 2, i, j, odd};
  }

  // To one of the four sides of the bounds, which themselves do not grow.
  Link link_outside(std::uint32_t i, int axis, bool upper) const {
    const Grown& a = obstacles_[i];
    const double side = upper ? world_.bounds().max[axis] : world_.bounds().min[axis];
    const bool second = upper ? a.core.b[axis] > a.core.a[axis] : a.core.b[axis] < a.core.a[axis];
    const Vec2 p = second ? a.core.b : a.core.a;
    const double inside_m = upper ? side - p[axis] : p[axis] - side;
    Vec2 q = p;
    if (inside_m > 0) q[axis] = side;
    return {std::max(0.0, inside_m - a.radius_m), i, outside_,
            crosses(a.core.a, p) != crosses(p, q)};
  }

  std::vector<Link> links_between(double from_m, double to_m) {
    std::vector<Link> links;
    const auto take = [&](const Link& link) {
      if (link.radius_m <= from_m || link.radius_m > to_m) return;
      const auto a = chains_.find(link.i);
      const auto b = chains_.find(link.j);
      if (a.root != b.root || (a.odd != b.odd) != link.odd) links.push_back(link);
    };
    const auto circles = static_cast<std::uint32_t>(world_.index().circles().size());
    for (std::uint32_t i = 0; i < outside_; ++i) {
      const Vec2 reach = Vec2::Constant(obstacles_[i].radius_m + 2 * to_m);
      const Segment& core = obstacles_[i].core;
      const auto with = [&](std::uint32_t j) {
        if (j > i) take(link(i, j));
      };
      world_.index().visit({core.a.cwiseMin(core.b) - reach, core.a.cwiseMax(core.b) + reach}, with,
                           [&](std::uint32_t edge) { with(circles + edge); });
      for (const int axis : {0, 1})
        for (const bool upper : {false, true}) take(link_outside(i, axis, upper));
    }
    std::sort(links.begin(), links.end(), [](const Link& a, const Link& b) {
      if (a.radius_m != b.radius_m) return a.radius_m < b.radius_m;
      return a.i != b.i ? a.i < b.i : a.j < b.j;
    });
    return links;
  }

  const World& world_;
  Vec2 start_, goal_;
  std::vector<Grown> obstacles_;
  std::uint32_t outside_ = 0;  // of the bounds, as one obstacle
  ParityChains chains_;
};

}  // namespace

double narrowest_passage_m(const World& world, const Vec2& start, const Vec2& goal) {
  return 2 * NarrowestPassage(world, start, goal).radius_m();
}

}  // namespace voronaut
