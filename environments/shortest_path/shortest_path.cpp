#include "voronaut/environments/shortest_path/shortest_path.h"

#include <cmath>
#include <cstdint>
#include <queue>
#include <stdexcept>

#include <sleef.h>

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
    ShortestPath path;
    path.length_m = arrivals_[arrival].length_m;
    while (arrival != 0) {
      const Arrival& from = arrivals_[arrivals_[arrival].previous];
      const Way& way = graph_.ways_from(from.rim)[arrivals_[arrival].way];
      const Disc& disc = graph_.disc(from.rim);
      const Vec2 touch = disc.center + disc.radius_m * from.at;
      const Vec2 leave = disc.center + disc.radius_m * way.tangent.depart;
      if (way.tangent.length_m > 0) {
        path.pieces.push_back({leave, graph_.arrival_point(way), way.tangent.length_m});
      }
      const double turn_m = arc_m(from, way);
      if (turn_m > 0) {
        const bool left = TangentGraph::turn(from.rim) > 0;
        path.pieces.push_back({touch, leave, turn_m, true, disc.center, left});
      }
      arrival = arrivals_[arrival].previous;
    }
    std::reverse(path.pieces.begin(), path.pieces.end());
    return path;
  }

  TangentGraph graph_;
  Vec2 goal_;
  double limit_m_;  // longer paths are not looked for
  std::vector<Arrival> arrivals_;
  std::vector<std::vector<std::uint32_t>> on_rim_;  // arrivals by rim
  std::priority_queue<Step> steps_;
};

}  // namespace

std::vector<Vec2> ShortestPath::polyline(double sag_m) const {
  std::vector<Vec2> points;
  if (!pieces.empty()) points.push_back(pieces.front().start);
  for (const Piece& piece : pieces) {
    if (piece.arc) {
      const Vec2 from = piece.start - piece.center;
      const double radius_m = from.norm();
      const double angle_rad = piece.length_m / radius_m;
      // A chord over the angle a is 1 - cos(a / 2), at most a^2 / 8, radii from its arc.
      const double chord_rad = std::sqrt(8 * sag_m / radius_m);
      const auto chords = static_cast<int>(std::min(std::ceil(angle_rad / chord_rad), 1e6));
      for (int i = 1; i < chords; ++i) {
        const auto sin_cos = Sleef_cinz_sincosd1_u10purec(angle_rad * i / chords);
        const double side = piece.counter_clockwise ? sin_cos.x : -sin_cos.x;
        points.push_back(piece.center + sin_cos.y * from + side * left_of(from));
      }
    }
    points.push_back(piece.end);
  }
  return points;
}

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
