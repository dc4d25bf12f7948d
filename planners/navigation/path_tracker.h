#pragma once

#include <optional>

#include "voronaut/dynamics/path.h"
#include "voronaut/dynamics/speed_profile.h"
#include "voronaut/planners/mapping/obstacle_base.h"
#include "voronaut/planners/navigation/navigation_config.h"

namespace voronaut {

// What is at the end of a path.
enum class PathEnd {
  goal,  // brake to rest there
  leg,   // a further leg will follow
};

// Where to go now, and how fast at most.
struct LookaheadPoint {
  Eigen::Vector2d p_world = Eigen::Vector2d::Zero();
  double speed_limit_m_s = 0;
  PathEnd end = PathEnd::leg;  // goal: the point is the goal itself, come to rest there
  // The segment of the path that holds the point; none at the end of the path.
  std::optional<PathSegment> segment = std::nullopt;
};

// Follows a path by projecting the vehicle on what lies ahead of it, never on what is behind: with
// a waypoint radius instead, a hairpin is a limit cycle.
class PathTracker {
 public:
  PathTracker(const NavigationConfig& config, const SpeedProfile& goal_profile,
              double max_speed_m_s)
      : config_(config), goal_profile_(goal_profile), max_speed_m_s_(max_speed_m_s) {}

  // Follow this path from its start.
  void follow(Path path, PathEnd end);
  void drop() { path_ = Path(); }

  bool has_path() const { return !path_.empty(); }
  const Path& path() const { return path_; }
  double station_m() const { return station_m_; }
  double distance_off_path_m() const { return distance_off_path_m_; }
  double remaining_m() const { return path_.length_m() - station_m_; }

  // Moves the projection on. Call with every position, in order.
  void advance(const Eigen::Vector2d& p_world);

  // The point to head for: lookahead_base_m + lookahead_per_speed_s * speed further along the path,
  // or as far as the straight way there keeps `clearance_m` from the known points.
  LookaheadPoint lookahead(const Eigen::Vector2d& p_world, double speed_m_s,
                           const ObstacleSnapshot& known, double clearance_m) const;

 private:
  NavigationConfig config_;
  SpeedProfile goal_profile_;
  double max_speed_m_s_;
  Path path_;
  PathEnd end_ = PathEnd::leg;
  double station_m_ = 0;
  double distance_off_path_m_ = 0;
};

// Speed at which the corners of `path` ahead of `station_m` can still be taken when braking at
// `deceleration_m_s2`: a corner of angle t is passed at max_speed * (1 + cos t) / 2, not below a
// tenth. O(segments ahead within braking distance).
double corner_speed_limit_m_s(const Path& path, double station_m, double max_speed_m_s,
                              double deceleration_m_s2);

}  // namespace voronaut
