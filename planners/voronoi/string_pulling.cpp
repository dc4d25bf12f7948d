#include "voronaut/planners/voronoi/string_pulling.h"

#include <algorithm>
#include <cmath>

namespace voronaut {
namespace {

constexpr double kTouch_m = 1e-9;    // closer than this to a tangent is touching
constexpr double kCosFinest = 0.99;  // chords of arcs turn by at most 8.1 degrees, then by halves
constexpr int kMaxHalvings = 12;

// An end of the string, or its contact with a circle. The gates are those at which it was met.
struct Contact {
  Vec2 center;
  double radius_m;
  SiteId site;
  bool on_left;
  std::size_t gate;

  double signed_radius_m() const { return on_left ? radius_m : -radius_m; }
};

struct Straight {
  Vec2 from;
  Vec2 to;
  Vec2 direction;
};

// The common tangent that leaves contact i and reaches contact j with each on its own side; false
// if the circles overlap too much to have one.
bool tangent(const Contact& i, const Contact& j, Straight& s) {
  const Vec2 between = j.center - i.center;
  const double distance_m = between.norm();
  const double difference = j.signed_radius_m() - i.signed_radius_m();
  if (distance_m <= std::fabs(difference)) return false;
  const double c = difference / distance_m;
  const Vec2 along = between / distance_m;
  const Vec2 normal = c * along + std::sqrt(1 - c * c) * left_of(along);
  s.from = i.center - i.signed_radius_m() * normal;
  s.to = j.center - j.signed_radius_m() * normal;
  s.direction = -left_of(normal);
  return true;
}

class StringPulling {
 public:
  StringPulling(const StringObstacles& around, const Channel& channel, const Vec2& start,
                const Vec2& goal)
      : around_(around), channel_(channel) {
    contacts_.push_back({start, 0, -1, true, 0});
    for (const Turn& turn : channel.turns)
      if (contacts_.back().site != turn.site || contacts_.back().on_left != turn.on_left)
        contacts_.push_back(contact(turn.site, turn.on_left, turn.gate));
    contacts_.push_back({goal, 0, -1, true, channel.gates.empty() ? 0 : channel.gates.size() - 1});
  }

  // Drops circles from which the string lifts and adds those that it cuts, until neither is left.
  bool pull() {
    const std::size_t limit = 50 + 4 * channel_.gates.size();
    for (std::size_t step = 0; step < limit; ++step) {
      if (!lay_tangents()) return false;
      if (drop_one()) continue;
      if (!add_deepest()) return true;
    }
    return false;
  }

  // Sites outside the channel that a straight piece cuts after all.
  bool add_foreign() {
    for (std::size_t i = 0; i < straights_.size(); ++i) {
      const Straight& s = straights_[i];
      const std::int32_t k = around_.cells.deepest_within(s.from, s.to, around_.check_radius_m);
      if (k < 0) continue;
      const SiteId site = k + DelaunayTriangulation::kFrameSites;
      if (site == contacts_[i].site || site == contacts_[i + 1].site) return false;
      const bool on_left = cross(s.direction, around_.delaunay.site(site) - s.from) > 0;
      contacts_.insert(contacts_.begin() + i + 1, contact(site, on_left, contacts_[i].gate));
      return true;
    }
    return false;
  }

  std::vector<Vec2> polyline() const {
    std::vector<Vec2> points{contacts_.front().center};
    for (std::size_t i = 1; i + 1 < contacts_.size(); ++i) add_arc(i, points);
    points.push_back(contacts_.back().center);
    return points;
  }

 private:
  Contact contact(SiteId site, bool on_left, std::size_t gate) const {
    return {around_.delaunay.site(site), around_.radius_m, site, on_left, gate};
  }

  bool lay_tangents() {
    straights_.resize(contacts_.size() - 1);
    for (std::size_t i = 0; i < straights_.size(); ++i)
      if (!tangent(contacts_[i], contacts_[i + 1], straights_[i])) return false;
    return true;
  }

  // How far the string turns at contact i in the sense in which it goes around it: the sine.
  double turn(std::size_t i) const {
    return cross(straights_[i - 1].direction, straights_[i].direction) *
           (contacts_[i].on_left ? 1 : -1);
  }

  // A string that turns the other way does not touch the circle. More than half a turn around a
  // wall's end looks like that, too, but then it goes back.
  bool lifts(std::size_t i) const {
    return turn(i) < 0 && straights_[i - 1].direction.dot(straights_[i].direction) > 0;
  }

  bool drop_one() {
    for (std::size_t i = 1; i + 1 < contacts_.size(); ++i) {
      if (!lifts(i)) continue;
      contacts_.erase(contacts_.begin() + i);
      return true;
    }
    return false;
  }

  // How deep a straight piece cuts into the circle about a site that it must pass on a given side;
  // not positive if it does not.
  double depth_m(const Straight& s, const Vec2& site, bool on_left) const {
    const Vec2 from_start = site - s.from;
    const double along = from_start.dot(s.direction);
    if (along < 0) return around_.radius_m - from_start.norm();
    if (along > (s.to - s.from).dot(s.direction)) return around_.radius_m - (site - s.to).norm();
    const double to_left = cross(s.direction, from_start);
    return around_.radius_m - (on_left ? to_left : -to_left);
  }

  SiteId gate_site(HalfEdgeId h, bool on_left) const {
    return on_left ? around_.delaunay.target(h) : around_.delaunay.origin(h);
  }

  // A gate that ends at a circle which a straight piece touches is crossed by that piece, by the
  // arc around the circle or by the piece on the other side of it.
  bool crosses(std::size_t i, HalfEdgeId gate) const {
    const Straight& s = straights_[i];
    for (const std::size_t end : {i, i + 1}) {
      const Contact& contact = contacts_[end];
      if (contact.site < 0 || gate_site(gate, contact.on_left) != contact.site) continue;
      const Vec2 along_gate =
          around_.delaunay.site(gate_site(gate, !contact.on_left)) - contact.center;
      const Vec2 to_contact = (end == i ? s.from : s.to) - contact.center;
      const double ahead = along_gate.dot(s.direction) * (end == i ? 1 : -1);
      if (ahead < 0 || along_gate.dot(to_contact) < 0) return false;
    }
    return true;
  }

  // A site that the string cuts off, and where among the contacts it belongs; 0: none.
  struct Cut {
    double depth_m = kTouch_m;
    std::size_t where = 0;
    Contact contact{};
  };

  bool add_deepest() {
    if (channel_.gates.empty()) return false;
    Cut deepest;
    for (std::size_t i = 0; i < straights_.size(); ++i) {
      for (std::size_t k = contacts_[i].gate; k <= contacts_[i + 1].gate; ++k) {
        if (!crosses(i, channel_.gates[k])) continue;
        for (const bool on_left : {true, false}) deepen(deepest, i, k, on_left);
      }
    }
    if (deepest.where == 0) return false;
    contacts_.insert(contacts_.begin() + deepest.where, deepest.contact);
    return true;
  }

  // By the site at this end of gate k, if straight i cuts it off deeper.
  void deepen(Cut& deepest, std::size_t i, std::size_t k, bool on_left) const {
    const SiteId site = gate_site(channel_.gates[k], on_left);
    if (around_.delaunay.is_frame(site) || is_contact(i, site, on_left) ||
        is_contact(i + 1, site, on_left))
      return;
    const double depth = depth_m(straights_[i], around_.delaunay.site(site), on_left);
    if (depth > deepest.depth_m) deepest = {depth, i + 1, contact(site, on_left, k)};
  }

  bool is_contact(std::size_t i, SiteId site, bool on_left) const {
    return contacts_[i].site == site && contacts_[i].on_left == on_left;
  }

  // Corners of the arc around contact i, halved until they clear their surroundings.
  void add_arc(std::size_t i, std::vector<Vec2>& points) const {
    const Vec2 &in = straights_[i - 1].direction, &out = straights_[i].direction;
    std::vector<Vec2> directions{in, out};
    if (turn(i) < 0) directions = {in, -(in + out).normalized(), out};
    int halvings = 0;
    while (directions[0].dot(directions[1]) < kCosFinest) halve(directions, i), ++halvings;
    for (; halvings < kMaxHalvings && !corners_are_clear(i, directions); ++halvings)
      halve(directions, i);
    for (std::size_t k = 1; k < directions.size(); ++k)
      points.push_back(corner(i, directions[k - 1], directions[k]));
  }

  void halve(std::vector<Vec2>& directions, std::size_t i) const {
    std::vector<Vec2> finer;
    finer.reserve(2 * directions.size());
    for (std::size_t k = 1; k < directions.size(); ++k) {
      finer.push_back(directions[k - 1]);
      const Vec2 sum = directions[k - 1] + directions[k];
      if (sum.squaredNorm() > 1e-6)
        finer.push_back(sum.normalized());
      else  // half a turn
        finer.push_back(left_of(directions[k - 1]) * (contacts_[i].on_left ? 1 : -1));
    }
    finer.push_back(directions.back());
    directions.swap(finer);
  }

  Vec2 corner(std::size_t i, const Vec2& d1, const Vec2& d2) const {
    const Vec2 n1 = left_of(d1), n2 = left_of(d2);
    return contacts_[i].center - contacts_[i].signed_radius_m() / (1 + n1.dot(n2)) * (n1 + n2);
  }

  bool corners_are_clear(std::size_t i, const std::vector<Vec2>& directions) const {
    Vec2 last = straights_[i - 1].to;
    for (std::size_t k = 1; k < directions.size(); ++k) {
      const Vec2 next = corner(i, directions[k - 1], directions[k]);
      if (!around_.domain.contains(next) ||
          !around_.cells.swept_disc_is_clear(last, next, around_.check_radius_m))
        return false;
      last = next;
    }
    return around_.cells.swept_disc_is_clear(last, straights_[i].from, around_.check_radius_m);
  }

  const StringObstacles& around_;
  const Channel& channel_;
  std::vector<Contact> contacts_;
  std::vector<Straight> straights_;
};

bool is_clear(const StringObstacles& around, const std::vector<Vec2>& path) {
  for (std::size_t i = 1; i < path.size(); ++i)
    if (!around.domain.contains(path[i]) ||
        !around.cells.swept_disc_is_clear(path[i - 1], path[i], around.check_radius_m))
      return false;
  return true;
}

// From each point on to the farthest one that is found by doubling steps, then by halving.
std::vector<Vec2> bypass(const StringObstacles& around, const std::vector<Vec2>& path) {
  std::vector<Vec2> kept{path.front()};
  for (std::size_t i = 0; i + 1 < path.size();) {
    const auto sees = [&](std::size_t j) {
      return around.cells.swept_disc_is_clear(path[i], path[j], around.check_radius_m);
    };
    std::size_t seen = i + 1, step = 1;
    while (seen + step < path.size() && sees(seen + step)) seen += step, step *= 2;
    for (; step > 0; step /= 2)
      if (seen + step < path.size() && sees(seen + step)) seen += step;
    kept.push_back(path[seen]);
    i = seen;
  }
  return kept;
}

std::vector<Vec2> strewn(const std::vector<Vec2>& path, double spacing_m) {
  std::vector<Vec2> points{path.front()};
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Vec2 along = path[i] - path[i - 1];
    const int pieces = static_cast<int>(std::min(1000.0, std::ceil(along.norm() / spacing_m)));
    for (int k = 1; k < pieces; ++k) points.push_back(path[i - 1] + (along * k) / pieces);
    points.push_back(path[i]);
  }
  return points;
}

}  // namespace

std::optional<std::vector<Vec2>> pull_string(const StringObstacles& around, const Channel& channel,
                                             const Vec2& start, const Vec2& goal) {
  StringPulling string(around, channel, start, goal);
  constexpr int kMaxForeign = 8;
  for (int foreign = 0; foreign <= kMaxForeign; ++foreign) {
    if (!string.pull()) return std::nullopt;
    if (string.add_foreign()) continue;
    std::vector<Vec2> path = string.polyline();
    if (!is_clear(around, path)) return std::nullopt;
    return path;
  }
  return std::nullopt;
}

std::vector<Vec2> shorten_by_shortcuts(const StringObstacles& around,
                                       const std::vector<Vec2>& path) {
  if (path.size() < 3) return path;
  const std::vector<Vec2> coarse = bypass(around, path);
  return bypass(around, strewn(coarse, 0.5 * around.radius_m));
}

double length_m(const std::vector<Vec2>& path) {
  double length = 0;
  for (std::size_t i = 1; i < path.size(); ++i) length += (path[i] - path[i - 1]).norm();
  return length;
}

}  // namespace voronaut
