#include "voronaut/environments/shortest_path/shortest_path.h"

#include <cmath>
#include <cstdint>
#include <queue>
#include <stdexcept>
#include <vector>

#include "voronaut/environments/shortest_path/tangent_graph.h"

namespace voronaut {
namespace {

// A* whose states are arrivals on rims.
class TangentSearch {
 public:
  TangentSearch(const World& world, const Vec2& start, const Vec2& goal, double radius_m)
      : graph_(world, start, goal, radius_m, kShortestPathTolerance), goal_(goal) {
    limit_m_ = 1.1 * (goal - start).norm() + 4 * radius_m;
  }

  // Looks for ever longer paths: few obstacles matter to a path with a small detour.
  std::optional<ShortestPath> run() {
    for (;; limit_m_ *= 1.4) {
      const bool all = graph_.restrict_to(limit_m_);
      if (all) limit_m_ = std::numeric_limits<double>::infinity();
      std::optional<ShortestPath> path = search();
      if (path || all) return path;
    }
  }

 private:
  using Rim = TangentGraph::Rim;
  using Way = TangentGraph::Way;

  // Where the path touches down on a rim.
  struct Arrival {
    Rim rim;
    std::uint32_t previous;  // arrival
    std::uint32_t way;       // from the rim of the previous one
    Vec2 at;                 // unit, from the centre of the disc
    double position;         // on the arc
    double length_m;         // of the path so far
  };
  // What could be next: on along the rim of an arrival, then along a way.
  struct Step {
    double total_m;  // length of the path to the goal: a lower bound
    std::uint32_t arrival;
    std::uint32_t way;
    bool exact;  // the arc is measured, not bounded

    // The queue gives its largest element first.
    bool operator<(const Step& other) const {
      if (total_m != other.total_m) return total_m > other.total_m;
      if (arrival != other.arrival) return arrival > other.arrival;
      return way > other.way;
    }
  };

  std::optional<ShortestPath> search() {
    arrivals_.clear();
    on_rim_.assign(graph_.rim_count(), {});
    steps_ = {};
    arrivals_.push_back({graph_.start(), 0, 0, Vec2::UnitX(), 0, 0});
    push_steps(0);
    while (!steps_.empty()) {
      const Step step = steps_.top();
      steps_.pop();
      const Arrival from = arrivals_[step.arrival];
      Way& way = graph_.ways_from(from.rim)[step.way];
      const double length_m = from.length_m + arc_m(from, way) + way.tangent.length_m;
      if (!step.exact) {
        const double total_m = length_m + (goal_ - graph_.arrival_point(way)).norm();
        if (total_m <= limit_m_) steps_.push({total_m, step.arrival, step.way, true});
        continue;
      }
      if (is_dominated(way, length_m) || !graph_.is_clear(from.rim, way)) continue;
      const auto arrival = static_cast<std::uint32_t>(arrivals_.size());
      arrivals_.push_back(
          {way.to, step.arrival, step.way, way.tangent.arrive, way.arrive_position, length_m});
      if (way.to == graph_.goal()) return path_to(arrival);
      on_rim_[way.to].push_back(arrival);
      push_steps(arrival);
    }
    return std::nullopt;
  }

  void push_steps(std::uint32_t arrival) {
    const Arrival& from = arrivals_[arrival];
    const Disc& disc = graph_.disc(from.rim);
    const int turn = TangentGraph::turn(from.rim);
    const std::vector<Way>& ways = graph_.ways_from(from.rim);
    for (std::uint32_t i = 0; i < ways.size(); ++i) {
      const Way& way = ways[i];
      if (way.verdict == Way::Verdict::blocked ||
          !graph_.leads_on(from.rim, from.position, way.depart_position)) {
        continue;
      }
      const double arc_at_least_m =
          disc.radius_m * turned_at_least_rad(from.at, way.tangent.depart, turn);
      const double rest_m = (goal_ - graph_.arrival_point(way)).norm();
      const double total_m = from.length_m + arc_at_least_m + way.tangent.length_m + rest_m;
      if (total_m <= limit_m_) steps_.push({total_m, arrival, i, false});
    }
  }

  double arc_m(const Arrival& from, const Way& way) const {
    const Disc& disc = graph_.disc(from.rim);
    if (disc.radius_m == 0) return 0;
    return disc.radius_m * turned_rad(from.at, way.tangent.depart, TangentGraph::turn(from.rim));
  }

  // Whether an earlier arrival on the rim gets to this one, along the rim, at no greater length.
  bool is_dominated(const Way& way, double length_m) const {
    const double enough_m = length_m + 1e-12 * (1 + length_m);
    for (const std::uint32_t i : on_rim_[way.to]) {
      const Arrival& earlier = arrivals_[i];
      if (earlier.length_m > enough_m ||
          !graph_.leads_on(way.to, earlier.position, way.arrive_position)) {
        continue;
      }
      const double turn_rad =
          turned_rad(earlier.at, way.tangent.arrive, TangentGraph::turn(way.to));
      if (earlier.length_m + graph_.disc(way.to).radius_m * turn_rad <= enough_m) return true;
    }
    return false;
  }

  ShortestPath path_to(std::uint32_t arrival) {
    std::vector<PathSegment> segments;  // from the goal back
    const double length_m = arrivals_[arrival].length_m;
    while (arrival != 0) {
      const Arrival& from = arrivals_[arrivals_[arrival].previous];
      const Way& way = graph_.ways_from(from.rim)[arrivals_[arrival].way];
      const Disc& disc = graph_.disc(from.rim);
      const Vec2 touch = disc.center + disc.radius_m * from.at;
      const Vec2 leave = disc.center + disc.radius_m * way.tangent.depart;
      if (way.tangent.length_m > 0)
        segments.push_back({.start = leave, .end = graph_.arrival_point(way)});
      if (touch != leave)  // nor does a taut path wind around the whole of a rim
        segments.push_back({.kind = PathSegment::Kind::arc,
                            .start = touch,
                            .end = leave,
                            .center = disc.center,
                            .counter_clockwise = TangentGraph::turn(from.rim) > 0});
      arrival = arrivals_[arrival].previous;
    }
    ShortestPath shortest{length_m, {}};
    for (auto segment = segments.rbegin(); segment != segments.rend(); ++segment)
      shortest.path.append(*segment);
    return shortest;
  }

  TangentGraph graph_;
  Vec2 goal_;
  double limit_m_;  // longer paths are not looked for
  std::vector<Arrival> arrivals_;
  std::vector<std::vector<std::uint32_t>> on_rim_;  // arrivals by rim
  std::priority_queue<Step> steps_;
};

}  // namespace

std::optional<ShortestPath> shortest_path(const World& world, const Vec2& start, const Vec2& goal,
                                          double radius_m) {
  if (!(radius_m > 0) || !std::isfinite(radius_m)) {
    throw std::invalid_argument("radius_m is not positive and finite");
  }
  const double reach_m = radius_m * (1 - kShortestPathTolerance);
  for (const Vec2& p : {start, goal}) {
    if (!world.bounds().contains(p) || world.index().clearance_m(p, radius_m) < reach_m) {
      return std::nullopt;
    }
  }
  if (start == goal) return ShortestPath{};
  return TangentSearch(world, start, goal, radius_m).run();
}

}  // namespace voronaut
