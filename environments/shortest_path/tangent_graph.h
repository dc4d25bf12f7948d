#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "voronaut/environments/shortest_path/common_tangent.h"
#include "voronaut/environments/shortest_path/inflated_boundary.h"

namespace voronaut {

// The free arcs of the rims, each in both senses of travel, and the tangents that lead from one to
// the other. Tangents are found when they are asked for, and tested when they are to be used.
class TangentGraph {
 public:
  // A free arc (rim / 2 is its index in InflatedBoundary) travelled clockwise (even) or
  // counter-clockwise.
  using Rim = std::uint32_t;

  struct Way {
    CommonTangent tangent;
    Rim to = 0;
    double depart_position = 0;  // on the arcs, as FreeArc::position
    double arrive_position = 0;
    enum class Verdict : std::uint8_t { untested, clear, blocked } verdict = Verdict::untested;
  };

  TangentGraph(const World& world, const Vec2& start, const Vec2& goal, double radius_m,
               double tolerance);

  // Forgets all ways and admits the discs that a path of at most limit_m can touch. True if these
  // are all there are.
  bool restrict_to(double limit_m);

  Rim start() const { return start_rim_; }
  Rim goal() const { return goal_rim_; }
  std::size_t rim_count() const { return ways_.size(); }
  const Disc& disc(Rim rim) const { return boundary_.discs()[boundary_.arc(rim / 2).disc]; }
  static int turn(Rim rim) { return rim % 2 == 1 ? 1 : -1; }
  Vec2 arrival_point(const Way& way) const {
    return disc(way.to).center + disc(way.to).radius_m * way.tangent.arrive;
  }

  // The tangents that leave a rim. O(discs admitted) the first time.
  std::vector<Way>& ways_from(Rim rim);
  // Whether the way is clear of obstacles: a swept-disc test the first time.
  bool is_clear(Rim from, Way& way) const;
  // Whether travel along the rim comes from one position on its arc to another.
  bool leads_on(Rim rim, double from_position, double to_position) const;

 private:
  static Rim rim(std::uint32_t arc, int turn) { return 2 * arc + (turn > 0 ? 1 : 0); }
  void find_ways(Rim from);
  void add_ways(Way way, std::uint32_t target, int target_turn, std::vector<Way>& ways);

  const World& world_;
  Vec2 start_point_;
  Vec2 goal_point_;
  double tolerance_;
  double reach_m_;
  InflatedBoundary boundary_;
  Rim start_rim_;
  std::uint32_t goal_disc_;
  Rim goal_rim_;
  double limit_m_ = 0;
  std::vector<std::uint32_t> admitted_;  // discs
  std::vector<std::vector<Way>> ways_;   // by rim
  std::vector<bool> found_;              // by rim
};

}  // namespace voronaut
