#include "voronaut/environments/shortest_path.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <queue>
#include <stdexcept>

#include <sleef.h>

#include "voronaut/environments/tangent_rims.h"

namespace voronaut {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Quarter turns or radians: directions that differ by less are the same but for rounding.
constexpr double kTurnTolerance = 1e-8;

// Rims are travelled counter-clockwise (turn +1, the disc on the left) or clockwise (-1).
struct Tangent {
  std::uint32_t to_arc = 0;
  int to_turn = 1;
  Vec2 depart;  // unit, from the centre of the disc that it leaves to the point of contact
  Vec2 arrive;  // the same at the disc that it reaches
  double depart_position = 0;
  double arrive_position = 0;
  double length_m = 0;
  enum class Verdict : std::uint8_t { open, clear, blocked } verdict = Verdict::open;
};

// The common tangent of two discs, travelled from `from` to `to`. False if one holds the other.
bool common_tangent(const Disc& from, int from_turn, const Disc& to, int to_turn, Tangent& t) {
  const Vec2 between = to.center - from.center;
  const double distance_sq = between.squaredNorm();
  if (distance_sq == 0) return false;
  // Along the left normal of the direction of travel the centres are this far apart.
  const double across_m = to_turn * to.radius_m - from_turn * from.radius_m;
  const double length_sq = distance_sq - across_m * across_m;
  // Discs that touch, or a point on a rim: the tangent has no length but turns the path over.
  if (length_sq < -2 * kShortestPathTolerance * distance_sq) return false;
  t.length_m = std::sqrt(std::max(length_sq, 0.0));
  const Vec2 normal = length_sq > 0
                          ? Vec2((t.length_m * left_of(between) + across_m * between) / distance_sq)
                          : Vec2((across_m > 0 ? 1 : -1) * between.normalized());
  t.depart = -from_turn * normal;
  t.arrive = -to_turn * normal;
  t.to_turn = to_turn;
  return true;
}

// Angle from one direction to another in the sense of the turn, in [0, 2 pi).
double turned_rad(const Vec2& from, const Vec2& to, int turn) {
  const double angle_rad = Sleef_cinz_atan2d1_u10purec(turn * cross(from, to), from.dot(to));
  if (angle_rad < -kTurnTolerance) return angle_rad + 2 * std::numbers::pi;
  return std::max(angle_rad, 0.0);
}

// A bound from below without trigonometry: twice the arc sine of half the chord, cut short.
double turned_at_least_rad(const Vec2& from, const Vec2& to, int turn) {
  if (turn * cross(from, to) < -kTurnTolerance) return std::numbers::pi;
  const double half_chord = (to - from).norm() / 2;
  const double sq = half_chord * half_chord;
  return half_chord * (2 + sq * (1.0 / 3 + sq * (3.0 / 20))) * (1 - 1e-12);
}

class TangentSearch {
 public:
  TangentSearch(const World& world, const Vec2& start, const Vec2& goal, double radius_m)
      : world_(world),
        start_(start),
        goal_(goal),
        reach_m_(radius_m * (1 - kShortestPathTolerance)),
        rims_(world, radius_m, kShortestPathTolerance),
        start_disc_(rims_.add_point(start)),
        goal_disc_(rims_.add_point(goal)) {}

  std::optional<ShortestPath> run() {
    // A path of length L touches only discs within the ellipse of the points whose detour is at
    // most L. Grow it until it holds a path that is no longer than itself.
    double ellipse_m = 1.1 * (goal_ - start_).norm() + 4 * reach_m_;
    while (true) {
      const bool all = select_discs(ellipse_m);
      const std::optional<ShortestPath> path = search();
      if (path && (all || path->length_m <= ellipse_m)) return path;
      if (!path && all) return std::nullopt;
      ellipse_m = path ? path->length_m * (1 + 1e-12) : 2 * ellipse_m;
    }
  }

 private:
  // Where the path touches down on a rim.
  struct Arrival {
    std::uint32_t rim;
    std::uint32_t previous;  // arrival
    std::uint32_t tangent;   // of the previous arrival's rim
    Vec2 at;                 // unit, from the centre of the disc
    double position;         // on the arc, in quarters
    double length_m;         // of the path so far
  };
  // An arc travelled in one sense.
  struct Rim {
    bool expanded = false;
    std::vector<Tangent> tangents;
    std::vector<std::uint32_t> arrivals;
  };
  // A way on from an arrival: along its rim, then along a tangent.
  struct Step {
    double total_m;  // path length to the goal: a lower bound
    std::uint32_t arrival;
    std::uint32_t tangent;
    bool exact;  // the arc is measured, not bounded

    bool operator<(const Step& other) const {
      if (total_m != other.total_m) return total_m > other.total_m;
      if (arrival != other.arrival) return arrival > other.arrival;
      return tangent > other.tangent;
    }
  };

  static std::uint32_t rim_of(std::uint32_t arc, int turn) { return 2 * arc + (turn > 0 ? 1 : 0); }
  static int turn_of(std::uint32_t rim) { return rim % 2 == 1 ? 1 : -1; }
  const FreeArc& arc_of(std::uint32_t rim) const { return rims_.arc(rim / 2); }
  const Disc& disc_of(std::uint32_t rim) const { return rims_.discs()[arc_of(rim).disc]; }

  bool select_discs(double ellipse_m) {
    active_.clear();
    const auto count = static_cast<std::uint32_t>(rims_.discs().size()) - 2;
    for (std::uint32_t i = 0; i < count; ++i) {
      const Disc& disc = rims_.discs()[i];
      const double detour_m = (disc.center - start_).norm() + (disc.center - goal_).norm();
      if (detour_m - 2 * disc.radius_m > ellipse_m) continue;
      const TangentRims::ArcRange arcs = rims_.arcs_of(i);
      if (arcs.begin != arcs.end) active_.push_back(i);
      ++selected_of_all_;
    }
    const bool all = selected_of_all_ == count;
    selected_of_all_ = 0;
    active_.push_back(goal_disc_);
    return all;
  }

  std::optional<ShortestPath> search() {
    rim_.assign(2 * rims_.arc_count(), {});
    arrivals_.clear();
    steps_ = {};
    const std::uint32_t start_rim = rim_of(rims_.arcs_of(start_disc_).begin, 1);
    const std::uint32_t goal_rim = rim_of(rims_.arcs_of(goal_disc_).begin, 1);
    arrivals_.push_back({start_rim, 0, 0, Vec2::UnitX(), 0, 0});
    push_steps(0);
    while (!steps_.empty()) {
      Step step = steps_.top();
      steps_.pop();
      const Arrival from = arrivals_[step.arrival];
      Tangent& tangent = rim_[from.rim].tangents[step.tangent];
      if (tangent.verdict == Tangent::Verdict::blocked) continue;
      const double length_m = from.length_m + arc_m(from, tangent) + tangent.length_m;
      const std::uint32_t rim = rim_of(tangent.to_arc, tangent.to_turn);
      const Disc& disc = disc_of(rim);
      if (!step.exact) {
        step.exact = true;
        step.total_m = length_m + (goal_ - disc.center - disc.radius_m * tangent.arrive).norm();
        if (!steps_.empty() && steps_.top().total_m < step.total_m) {
          steps_.push(step);
          continue;
        }
      }
      if (dominated(rim, tangent, length_m) || !is_clear(from.rim, tangent)) continue;
      const auto arrival = static_cast<std::uint32_t>(arrivals_.size());
      arrivals_.push_back(
          {rim, step.arrival, step.tangent, tangent.arrive, tangent.arrive_position, length_m});
      if (rim == goal_rim) return path_to(arrival);
      rim_[rim].arrivals.push_back(arrival);
      push_steps(arrival);
    }
    return std::nullopt;
  }

  double arc_m(const Arrival& from, const Tangent& tangent) const {
    const Disc& disc = disc_of(from.rim);
    if (disc.radius_m == 0) return 0;
    return disc.radius_m * turned_rad(from.at, tangent.depart, turn_of(from.rim));
  }

  // Whether an earlier arrival on the rim gets to this one, along the rim, at no greater length.
  bool dominated(std::uint32_t rim, const Tangent& tangent, double length_m) const {
    const double slack_m = 1e-12 * (1 + length_m);
    const Disc& disc = disc_of(rim);
    const int turn = turn_of(rim);
    for (const std::uint32_t i : rim_[rim].arrivals) {
      const Arrival& earlier = arrivals_[i];
      if (earlier.length_m > length_m + slack_m) continue;
      if (!leads_on(rim, earlier.position, tangent.arrive_position)) continue;
      const double along_m = disc.radius_m * turned_rad(earlier.at, tangent.arrive, turn);
      if (earlier.length_m + along_m <= length_m + slack_m) return true;
    }
    return false;
  }

  // Whether travelling on along the arc comes from one position to another.
  bool leads_on(std::uint32_t rim, double from, double to) const {
    if (arc_of(rim).whole()) return true;
    return turn_of(rim) > 0 ? to >= from - kTurnTolerance : to <= from + kTurnTolerance;
  }

  bool is_clear(std::uint32_t from_rim, Tangent& tangent) {
    if (tangent.verdict == Tangent::Verdict::open) {
      const Disc& from = disc_of(from_rim);
      const Disc& to = rims_.discs()[rims_.arc(tangent.to_arc).disc];
      const bool clear =
          world_.segment_is_clear(from.center + from.radius_m * tangent.depart,
                                  to.center + to.radius_m * tangent.arrive, reach_m_);
      tangent.verdict = clear ? Tangent::Verdict::clear : Tangent::Verdict::blocked;
    }
    return tangent.verdict == Tangent::Verdict::clear;
  }

  void push_steps(std::uint32_t index) {
    const Arrival from = arrivals_[index];
    Rim& rim = rim_[from.rim];
    if (!rim.expanded) expand(from.rim);
    const Disc& disc = disc_of(from.rim);
    const int turn = turn_of(from.rim);
    for (std::uint32_t i = 0; i < rim.tangents.size(); ++i) {
      const Tangent& tangent = rim.tangents[i];
      if (tangent.verdict == Tangent::Verdict::blocked ||
          !leads_on(from.rim, from.position, tangent.depart_position)) {
        continue;
      }
      const Disc& to = rims_.discs()[rims_.arc(tangent.to_arc).disc];
      const double arc_at_least_m =
          disc.radius_m == 0 ? 0
                             : disc.radius_m * turned_at_least_rad(from.at, tangent.depart, turn);
      const double rest_m = (goal_ - to.center - to.radius_m * tangent.arrive).norm();
      steps_.push({from.length_m + arc_at_least_m + tangent.length_m + rest_m, index, i, false});
    }
  }

  // Every tangent that leaves the rim for a free arc of another disc.
  void expand(std::uint32_t index) {
    Rim& rim = rim_[index];
    rim.expanded = true;
    const FreeArc& arc = arc_of(index);
    const Disc& disc = disc_of(index);
    for (const std::uint32_t target : active_) {
      if (target == arc.disc) continue;
      for (const int turn : {1, -1}) {
        if (target == goal_disc_ && turn < 0) continue;
        Tangent tangent;
        if (!common_tangent(disc, turn_of(index), rims_.discs()[target], turn, tangent)) continue;
        tangent.depart_position = arc.position(quarter_turns(tangent.depart));
        if (tangent.depart_position < 0) continue;
        add_to_arc(target, tangent, rim);
      }
    }
  }

  void add_to_arc(std::uint32_t target, Tangent& tangent, Rim& rim) {
    const TangentRims::ArcRange arcs = rims_.arcs_of(target);
    const double arrive = quarter_turns(tangent.arrive);
    for (std::uint32_t i = arcs.begin; i < arcs.end; ++i) {
      tangent.arrive_position = rims_.arc(i).position(arrive);
      if (tangent.arrive_position < 0) continue;
      tangent.to_arc = i;
      rim.tangents.push_back(tangent);
    }
  }

  ShortestPath path_to(std::uint32_t arrival) const {
    ShortestPath path;
    path.length_m = arrivals_[arrival].length_m;
    while (arrival != 0) {
      const Arrival& from = arrivals_[arrivals_[arrival].previous];
      const Tangent& tangent = rim_[from.rim].tangents[arrivals_[arrival].tangent];
      const Disc& disc = disc_of(from.rim);
      const Disc& to = disc_of(arrivals_[arrival].rim);
      const Vec2 touch = disc.center + disc.radius_m * from.at;
      const Vec2 leave = disc.center + disc.radius_m * tangent.depart;
      const Vec2 reach = to.center + to.radius_m * tangent.arrive;
      if (tangent.length_m > 0) path.pieces.push_back({leave, reach, tangent.length_m});
      const double turn_m = arc_m(from, tangent);
      if (turn_m > 0) {
        path.pieces.push_back({touch, leave, turn_m, true, disc.center, turn_of(from.rim) > 0});
      }
      arrival = arrivals_[arrival].previous;
    }
    std::reverse(path.pieces.begin(), path.pieces.end());
    return path;
  }

  const World& world_;
  Vec2 start_;
  Vec2 goal_;
  double reach_m_;
  TangentRims rims_;
  std::uint32_t start_disc_;
  std::uint32_t goal_disc_;
  std::vector<std::uint32_t> active_;  // discs that take part
  std::uint32_t selected_of_all_ = 0;
  std::vector<Rim> rim_;  // by arc and sense
  std::vector<Arrival> arrivals_;
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
