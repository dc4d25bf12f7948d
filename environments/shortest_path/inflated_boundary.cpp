#include "voronaut/environments/shortest_path/inflated_boundary.h"

#include <cmath>
#include <tuple>

namespace voronaut {
namespace {

// Rounding of directions; tangents that miss the end of an arc by less belong to it.
constexpr double kDirectionTolerance = 1e-9;
// Shorter arcs are the corners of joints in straight walls: nothing bends there.
constexpr double kShortestArcQuarters = 1e-12;

// The directions, seen from the centre of a disc, at which its rim may become free or blocked.
class Crossings {
 public:
  Crossings(const Disc& disc, std::vector<double>& quarters) : disc_(disc), quarters_(quarters) {}

  void with_circle(const Vec2& center, double radius_m) {
    const Vec2 to = center - disc_.center;
    const double distance_sq = to.squaredNorm();
    if (distance_sq == 0) return;
    const double distance_m = std::sqrt(distance_sq);
    const double ahead = (distance_sq + disc_.radius_m * disc_.radius_m - radius_m * radius_m) /
                         (2 * distance_m * disc_.radius_m);
    if (std::abs(ahead) > 1) return;
    const Vec2 toward = to / distance_m;
    const Vec2 aside = std::sqrt(1 - ahead * ahead) * left_of(toward);
    add(ahead * toward + aside);
    add(ahead * toward - aside);
  }

  // The line through a along the unit vector `along`, from a to length_m ahead of it.
  void with_line(const Vec2& a, const Vec2& along, double length_m) {
    const Vec2 to = a - disc_.center;
    const double beside_m = cross(along, to);
    const double half_chord_sq = disc_.radius_m * disc_.radius_m - beside_m * beside_m;
    if (half_chord_sq < 0) return;
    const double foot_m = -along.dot(to);
    const double slack_m = 1e-6 * disc_.radius_m;
    for (const double sign : {-1.0, 1.0}) {
      const double at_m = foot_m + sign * std::sqrt(half_chord_sq);
      if (at_m >= -slack_m && at_m <= length_m + slack_m) add(to + at_m * along);
    }
  }

  void with_edge(const Segment& edge, double radius_m) {
    with_circle(edge.a, radius_m);
    with_circle(edge.b, radius_m);
    const double length_m = (edge.b - edge.a).norm();
    if (length_m == 0) return;
    const Vec2 along = (edge.b - edge.a) / length_m;
    with_line(edge.a + radius_m * left_of(along), along, length_m);
    with_line(edge.a - radius_m * left_of(along), along, length_m);
  }

  void with_bounds(const Bounds& bounds) {
    const Vec2 size_m = bounds.max - bounds.min;
    with_line(bounds.min, Vec2::UnitX(), size_m.x());
    with_line(bounds.min, Vec2::UnitY(), size_m.y());
    with_line(bounds.max, -Vec2::UnitX(), size_m.x());
    with_line(bounds.max, -Vec2::UnitY(), size_m.y());
  }

  void add(const Vec2& direction) { quarters_.push_back(quarter_turns(direction)); }

 private:
  const Disc& disc_;
  std::vector<double>& quarters_;
};

}  // namespace

double FreeArc::position(double quarters) const {
  const double ahead = quarters_ahead(from_quarters, quarters);
  if (whole() || ahead <= span_quarters) return ahead;
  if (ahead <= span_quarters + kDirectionTolerance) return span_quarters;
  return ahead >= 4 - kDirectionTolerance ? 0 : -1;
}

InflatedBoundary::InflatedBoundary(const World& world, double radius_m, double tolerance)
    : world_(world),
      radius_m_(radius_m),
      reach_m_(radius_m * (1 - tolerance)),
      same_point_m_(radius_m * tolerance) {
  for (const Circle& circle : world.index().circles()) {
    discs_.push_back({circle.center, circle.radius_m + radius_m});
  }
  for (const Segment& e : world.index().edges()) {
    discs_.push_back({e.a, radius_m});
    discs_.push_back({e.b, radius_m});
  }
  // Corners that shapes share are one; those that differ by rounding meet in the same coarse cell.
  const double coarse_m = 1e-6 * radius_m;
  const auto key = [&](const Disc& d) {
    return std::tuple(std::round(d.center.x() / coarse_m), std::round(d.center.y() / coarse_m),
                      d.radius_m, d.center.x(), d.center.y());
  };
  std::sort(discs_.begin(), discs_.end(),
            [&](const Disc& a, const Disc& b) { return key(a) < key(b); });
  const auto same = [&](const Disc& a, const Disc& b) {
    return a.radius_m == b.radius_m && (a.center - b.center).norm() <= same_point_m_;
  };
  discs_.erase(std::unique(discs_.begin(), discs_.end(), same), discs_.end());
  arcs_of_.assign(discs_.size(), {1, 0});
}

std::uint32_t InflatedBoundary::add_point(const Vec2& p) {
  const auto disc = static_cast<std::uint32_t>(discs_.size());
  const auto first = static_cast<std::uint32_t>(arcs_.size());
  discs_.push_back({p, 0});
  arcs_.push_back({disc, 0, 4});
  arcs_of_.push_back({first, first + 1});
  return disc;
}

InflatedBoundary::ArcRange InflatedBoundary::arcs_of(std::uint32_t disc) {
  if (arcs_of_[disc].begin > arcs_of_[disc].end) arcs_of_[disc] = find_arcs(disc);
  return arcs_of_[disc];
}

bool InflatedBoundary::is_free(const Disc& disc, const Vec2& direction) const {
  const Vec2 p = disc.center + disc.radius_m * direction;
  return world_.bounds().contains(p) && world_.index().clearance_m(p, radius_m_) >= reach_m_;
}

// Where the rim may change between free and blocked, in order, and the edges that end in its
// centre.
std::vector<double> InflatedBoundary::crossings_of(const Disc& disc) const {
  std::vector<double> quarters;
  Crossings crossings(disc, quarters);
  const ShapeIndex& shapes = world_.index();
  shapes.visit(
      grown(bounds_of(Circle{disc.center, disc.radius_m}), radius_m_),
      [&](std::uint32_t i) {
        const Circle& circle = shapes.circles()[i];
        crossings.with_circle(circle.center, circle.radius_m + reach_m_);
      },
      [&](std::uint32_t i) {
        const Segment& e = shapes.edges()[i];
        const bool from_a = (e.a - disc.center).norm() <= same_point_m_;
        const bool from_b = (e.b - disc.center).norm() <= same_point_m_;
        if (disc.radius_m > radius_m_ || from_a == from_b) {
          crossings.with_edge(e, reach_m_);
          return;
        }
        crossings.add(left_of(e.b - e.a));
        crossings.add(left_of(e.a - e.b));
      });
  crossings.with_bounds(world_.bounds());
  std::sort(quarters.begin(), quarters.end());
  return quarters;
}

InflatedBoundary::ArcRange InflatedBoundary::find_arcs(std::uint32_t index) {
  const Disc disc = discs_[index];
  std::vector<double> quarters = crossings_of(disc);
  if (quarters.empty()) quarters.push_back(0);

  // Between neighbouring crossings the rim is free or blocked as its middle is. Slivers between
  // crossings that coincide are neither: they join what lies on their sides.
  struct Piece {
    double from, span;
    bool sliver, free;
  };
  std::vector<Piece> pieces(quarters.size());
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const double next = i + 1 < quarters.size() ? quarters[i + 1] : quarters[0] + 4;
    const double span = next - quarters[i];
    const bool sliver = span <= kShortestArcQuarters;
    const Vec2 middle = direction_at(quarters[i] + span / 2);
    pieces[i] = {quarters[i], span, sliver, !sliver && is_free(disc, middle)};
  }
  // Begin behind a blocked piece, so that no free arc is cut by the seam.
  const auto blocked = std::find_if(pieces.begin(), pieces.end(),
                                    [](const Piece& p) { return !p.sliver && !p.free; });
  const auto first = static_cast<std::uint32_t>(arcs_.size());
  if (blocked == pieces.end()) {
    arcs_.push_back({index, 0, 4});
    return {first, first + 1};
  }
  std::rotate(pieces.begin(), blocked, pieces.end());
  bool open = false;
  for (const Piece& piece : pieces) {
    if (open && (piece.free || piece.sliver)) {
      arcs_.back().span_quarters += piece.span;
    } else if (piece.free) {
      arcs_.push_back({index, piece.from, piece.span});
    }
    open = piece.sliver ? open : piece.free;
  }
  return {first, static_cast<std::uint32_t>(arcs_.size())};
}

}  // namespace voronaut
