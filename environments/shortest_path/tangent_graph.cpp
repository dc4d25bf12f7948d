#include "voronaut/environments/shortest_path/tangent_graph.h"

#include "voronaut/environments/shortest_path/arc_visibility.h"

namespace voronaut {

TangentGraph::TangentGraph(const World& world, const Vec2& start, const Vec2& goal, double radius_m,
                           double tolerance)
    : world_(world),
      start_point_(start),
      goal_point_(goal),
      tolerance_(tolerance),
      reach_m_(radius_m * (1 - tolerance)),
      boundary_(world, radius_m, tolerance),
      start_rim_(rim(boundary_.arcs_of(boundary_.add_point(start)).begin, 1)),
      goal_disc_(boundary_.add_point(goal)),
      goal_rim_(rim(boundary_.arcs_of(goal_disc_).begin, 1)) {}

bool TangentGraph::restrict_to(double limit_m) {
  limit_m_ = limit_m;
  admitted_.clear();
  // A path of length L stays within the ellipse of the points whose detour is at most L.
  std::uint32_t within = 0;
  const std::uint32_t obstacles = goal_disc_ - 1;  // start and goal come last
  for (std::uint32_t i = 0; i < obstacles; ++i) {
    const Disc& disc = boundary_.discs()[i];
    const double detour_m =
        (disc.center - start_point_).norm() + (disc.center - goal_point_).norm();
    if (detour_m - 2 * disc.radius_m > limit_m) continue;
    ++within;
    const InflatedBoundary::ArcRange arcs = boundary_.arcs_of(i);
    if (arcs.begin != arcs.end) admitted_.push_back(i);
  }
  admitted_.push_back(goal_disc_);
  ways_.assign(2 * boundary_.arc_count(), {});
  found_.assign(2 * boundary_.arc_count(), false);
  return within == obstacles;
}

std::vector<TangentGraph::Way>& TangentGraph::ways_from(Rim rim) {
  if (!found_[rim]) {
    found_[rim] = true;
    find_ways(rim);
  }
  return ways_[rim];
}

void TangentGraph::find_ways(Rim from) {
  const FreeArc& arc = boundary_.arc(from / 2);
  const Disc& here = disc(from);
  const ArcVisibility sight(world_.index(), here, arc, turn(from), reach_m_, limit_m_);
  for (const std::uint32_t target : admitted_) {
    const Disc& there = boundary_.discs()[target];
    if (target == arc.disc || !sight.may_reach(there)) continue;
    const auto find_way = [&](int target_turn) {
      Way way;
      if (!common_tangent(here, turn(from), there, target_turn, tolerance_, way.tangent)) return;
      const double depart = quarter_turns(way.tangent.depart);
      way.depart_position = arc.position(depart);
      if (way.depart_position < 0) return;
      if (!sight.may_reach(depart, there.center + there.radius_m * way.tangent.arrive)) return;
      add_ways(way, target, target_turn, ways_[from]);
    };
    find_way(1);
    if (target != goal_disc_) find_way(-1);
  }
}

void TangentGraph::add_ways(Way way, std::uint32_t target, int target_turn,
                            std::vector<Way>& ways) {
  const InflatedBoundary::ArcRange arcs = boundary_.arcs_of(target);
  const double arrive = quarter_turns(way.tangent.arrive);
  for (std::uint32_t i = arcs.begin; i < arcs.end; ++i) {
    way.arrive_position = boundary_.arc(i).position(arrive);
    if (way.arrive_position < 0) continue;
    way.to = rim(i, target_turn);
    ways.push_back(way);
  }
}

bool TangentGraph::is_clear(Rim from, Way& way) const {
  if (way.verdict == Way::Verdict::untested) {
    const Vec2 depart = disc(from).center + disc(from).radius_m * way.tangent.depart;
    const bool clear = world_.segment_is_clear(depart, arrival_point(way), reach_m_);
    way.verdict = clear ? Way::Verdict::clear : Way::Verdict::blocked;
  }
  return way.verdict == Way::Verdict::clear;
}

bool TangentGraph::leads_on(Rim rim, double from_position, double to_position) const {
  if (boundary_.arc(rim / 2).whole()) return true;
  return turn(rim) > 0 ? to_position >= from_position - kSameDirection
                       : to_position <= from_position + kSameDirection;
}

}  // namespace voronaut
