#include "voronaut/planners/voronoi/channel_search.h"

#include <algorithm>
#include <limits>

#include "voronaut/planners/voronoi/clipping.h"

namespace voronaut {
namespace {

constexpr std::size_t kMaxNodes = 200'000;
constexpr double kTie_m = 1e-9;
// Cones are wider than they are by this: a corner exactly on the border of two cones (walls on a
// grid have many) belongs to both, or rounding would give it to neither.
constexpr double kSlack_m = 1e-9;

// Where the ray from `root` through `through` meets the gate, as a fraction from its left to its
// right end; `left` and `right` are the cross products of the ray with the way to the ends.
double fraction(double left, double right) { return left / (left - right); }

// What a cone leaves of a gate: the part [from, to] inside it, as fractions from the gate's left
// end to its right, and whether there is something beside it.
struct VisiblePart {
  double from;
  double to;
  bool beside_left;
  bool beside_right;
  bool in_cone;
};

// All as seen from the cone's root.
VisiblePart visible_part(const Vec2& left_ray, const Vec2& right_ray, const Vec2& gate_left,
                         const Vec2& gate_right) {
  const double l0 = cross(left_ray, gate_left);
  const double l1 = cross(left_ray, gate_right);
  const double r0 = cross(right_ray, gate_left);
  const double r1 = cross(right_ray, gate_right);
  const double l_slack = kSlack_m * left_ray.lpNorm<1>();
  const double r_slack = kSlack_m * right_ray.lpNorm<1>();
  VisiblePart part{};
  part.from = l0 <= l_slack ? 0 : l1 >= 0 ? 1 : fraction(l0, l1);
  part.to = r1 >= -r_slack ? 1 : r0 <= 0 ? 0 : fraction(r0, r1);
  part.beside_left = l0 > l_slack;
  part.beside_right = r1 < -r_slack;
  const bool all_left = part.beside_left && l1 > l_slack;
  const bool all_right = part.beside_right && r0 < -r_slack;
  part.in_cone = !all_left && !all_right && part.from <= part.to;
  return part;
}

}  // namespace

std::optional<Channel> ChannelSearch::find(const DelaunayTriangulation& delaunay,
                                           const Bounds& domain, double radius_m, const Vec2& start,
                                           const Vec2& goal, double bound_m) {
  delaunay_ = &delaunay;
  domain_ = domain;
  radius_m_ = radius_m;
  bound_m_ = bound_m;
  start_ = delaunay.rounded(start);
  goal_ = delaunay.rounded(goal);
  goal_triangle_ = delaunay.locate(goal);
  nodes_.clear();
  heap_.clear();
  corner_.assign(3 * delaunay.triangle_count(), {kInfinity, -1});
  start_from(delaunay.locate(start));
  while (!heap_.empty() && nodes_.size() < kMaxNodes) {
    const std::int32_t top = heap_.front().node;
    std::pop_heap(heap_.begin(), heap_.end());
    heap_.pop_back();
    const Node& node = nodes_[top];
    if (node.at_goal) return trace(top);
    if (node.root_corner >= 0 && node.cost_m > corner_[node.root_corner].cost_m + kTie_m) continue;
    expand(top);
  }
  return std::nullopt;
}

ChannelSearch::Gate ChannelSearch::gate(HalfEdgeId h) const {
  const DelaunayTriangulation& d = *delaunay_;
  const SiteId a = d.target(h), b = d.origin(h);  // left and right, seen from the triangle
  Gate g{Vec2::Zero(), Vec2::Zero(), false, false, false};
  if (d.twin(h) < 0) return g;
  const Vec2& left = d.site(a);
  const Vec2 across = d.site(b) - left;
  const double length_m = across.norm();
  double from = d.is_frame(a) ? 0 : radius_m_ / length_m;
  double to = d.is_frame(b) ? 1 : 1 - radius_m_ / length_m;
  g.left_corner = !d.is_frame(a);
  g.right_corner = !d.is_frame(b);
  for (int axis = 0; axis < 2; ++axis) {
    const auto inside = clipped(left[axis], across[axis], domain_.min[axis], domain_.max[axis]);
    if (!inside) return g;
    if (inside->first > from) from = inside->first, g.left_corner = false;
    if (inside->second < to) to = inside->second, g.right_corner = false;
  }
  g.open = from <= to;
  g.left = left + from * across;
  g.right = left + to * across;
  return g;
}

void ChannelSearch::start_from(TriangleId t) {
  if (t == goal_triangle_) {
    Node node{goal_, goal_, goal_, (goal_ - start_).norm(), -1, -1, -1, Bend::none,
              false, false, true};
    push(node);
    return;
  }
  for (HalfEdgeId h = 3 * t; h < 3 * t + 3; ++h) {
    const Gate g = gate(h);
    if (!g.open) continue;
    push({start_, g.left, g.right, 0, h, -1, -1, Bend::none, g.left_corner, g.right_corner, false});
  }
}

void ChannelSearch::expand(std::int32_t index) {
  const HalfEdgeId entry = delaunay_->twin(nodes_[index].gate);
  if (DelaunayTriangulation::triangle(entry) == goal_triangle_) {
    finish(index);
    return;
  }
  cross(index, DelaunayTriangulation::previous(entry));
  cross(index, DelaunayTriangulation::next(entry));
}

// Successors of a node on one of the other edges of the triangle that it enters: the part of that
// gate within the cone, and the parts beside it, for which the path bends at an end of the
// interval.
void ChannelSearch::cross(std::int32_t index, HalfEdgeId exit) {
  const Gate g = gate(exit);
  if (!g.open) return;
  const Node node = nodes_[index];
  const auto [from, to, beside_left, beside_right, in_cone] = visible_part(
      node.left - node.root, node.right - node.root, g.left - node.root, g.right - node.root);
  if (in_cone) {
    Node child = node;
    child.gate = exit;
    child.parent = index;
    child.bend = Bend::none;
    child.left = g.at(from);
    child.right = g.at(to);
    child.left_corner = from <= 0 && g.left_corner;
    child.right_corner = to >= 1 && g.right_corner;
    push(child);
  }
  if (beside_left && node.left_corner) {
    Node child = node;
    child.gate = exit;
    child.left = g.left;
    child.right = g.at(from);
    child.left_corner = g.left_corner;
    child.right_corner = from >= 1 && g.right_corner;
    if (turn(child, index, Bend::left)) push(child);
  }
  if (beside_right && node.right_corner) {
    Node child = node;
    child.gate = exit;
    child.left = g.at(to);
    child.right = g.right;
    child.left_corner = to <= 0 && g.left_corner;
    child.right_corner = g.right_corner;
    if (turn(child, index, Bend::right)) push(child);
  }
}

// Makes an end of the parent's interval the root of a child; false if a cheaper way there is known.
bool ChannelSearch::turn(Node& child, std::int32_t index, Bend bend) {
  const Node& parent = nodes_[index];
  const Vec2& corner = bend == Bend::left ? parent.left : parent.right;
  child.root_corner = bend == Bend::left ? parent.gate : delaunay_->twin(parent.gate);
  child.cost_m = parent.cost_m + (corner - parent.root).norm();
  child.root = corner;
  child.parent = index;
  child.bend = bend;
  // Of equal ways the first one stays (walls on a grid have many), with both of its successors:
  // what the others would see beyond this corner, the first one sees too, or sees without bending.
  CornerRecord& record = corner_[child.root_corner];
  if (child.cost_m > record.cost_m - kTie_m) return record.parent == index;
  record = {child.cost_m, index};
  return true;
}

void ChannelSearch::finish(std::int32_t index) {
  const Node node = nodes_[index];
  Node last = node;
  last.at_goal = true;
  last.parent = index;
  last.bend = Bend::none;
  const Vec2 to_goal = goal_ - node.root;
  const Vec2 left_ray = node.left - node.root, right_ray = node.right - node.root;
  if (voronaut::cross(left_ray, to_goal) > kSlack_m * left_ray.lpNorm<1>()) {
    if (!node.left_corner || !turn(last, index, Bend::left)) return;
  } else if (voronaut::cross(right_ray, to_goal) < -kSlack_m * right_ray.lpNorm<1>()) {
    if (!node.right_corner || !turn(last, index, Bend::right)) return;
  }
  last.cost_m += (goal_ - last.root).norm();
  last.root = last.left = last.right = goal_;
  push(last);
}

void ChannelSearch::push(const Node& node) {
  const double estimate = node.at_goal ? node.cost_m : estimate_m(node);
  if (estimate > bound_m_) return;
  heap_.push_back({estimate, static_cast<std::int32_t>(nodes_.size())});
  std::push_heap(heap_.begin(), heap_.end());
  nodes_.push_back(node);
}

// Length of the shortest way from the start through the interval to the goal, as if nothing else
// were there.
double ChannelSearch::estimate_m(const Node& node) const {
  Vec2 goal = goal_;
  const Vec2& on_edge = delaunay_->site(delaunay_->origin(node.gate));
  const Vec2 along = delaunay_->site(delaunay_->target(node.gate)) - on_edge;
  const double goal_side = voronaut::cross(along, goal - on_edge);
  if (goal_side > 0) {  // on the side that is left: the way back is as long as to its mirror image
    const Vec2 normal = left_of(along);
    goal -= (2 * goal_side / along.squaredNorm()) * normal;
  }
  const Vec2 to_goal = goal - node.root;
  const Vec2* by = nullptr;
  if (voronaut::cross(node.left - node.root, to_goal) > 0)
    by = &node.left;
  else if (voronaut::cross(node.right - node.root, to_goal) < 0)
    by = &node.right;
  if (!by) return node.cost_m + to_goal.norm();
  return node.cost_m + (*by - node.root).norm() + (goal - *by).norm();
}

Channel ChannelSearch::trace(std::int32_t index) const {
  Channel channel;
  channel.length_m = nodes_[index].cost_m;
  std::vector<std::int32_t> chain;
  for (std::int32_t i = nodes_[index].at_goal ? nodes_[index].parent : index; i >= 0;
       i = nodes_[i].parent)
    chain.push_back(i);
  std::reverse(chain.begin(), chain.end());
  chain.push_back(index);
  for (std::size_t k = 0; k < chain.size(); ++k) {
    const Node& node = nodes_[chain[k]];
    if (node.bend != Bend::none) {
      const HalfEdgeId h = channel.gates.back();
      const bool left = node.bend == Bend::left;
      channel.turns.push_back(
          {left ? delaunay_->target(h) : delaunay_->origin(h), left, channel.gates.size() - 1});
    }
    if (!node.at_goal) channel.gates.push_back(node.gate);
  }
  return channel;
}

}  // namespace voronaut
