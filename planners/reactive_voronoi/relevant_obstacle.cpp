#include "voronaut/planners/reactive_voronoi/relevant_obstacle.h"

#include <algorithm>
#include <limits>

namespace voronaut {
namespace {

using Config = ReactiveVoronoiConfig;

RelevantObstacle& obstacle_of(ClusterId cluster, std::vector<RelevantObstacle>& obstacles) {
  for (RelevantObstacle& each : obstacles)
    if (each.cluster == cluster) return each;
  obstacles.emplace_back().cluster = cluster;
  return obstacles.back();
}

std::vector<RelevantObstacle> in_sight(const Belief& belief) {
  std::vector<RelevantObstacle> obstacles;
  for (const ScanCluster& seen : belief.scan_clusters) {
    RelevantObstacle& obstacle = obstacle_of(seen.cluster, obstacles);
    obstacle.points_world.insert(obstacle.points_world.end(), seen.points_world.begin(),
                                 seen.points_world.end());
    obstacle.cut_right |= seen.cut_right;
    obstacle.cut_left |= seen.cut_left;
  }
  return obstacles;
}

// Every known obstacle, with what the scan says of its cut edges.
std::vector<RelevantObstacle> on_map(const Belief& belief) {
  std::vector<RelevantObstacle> obstacles;
  const std::span<const Vec2> points = belief.obstacles.points();
  for (PointId id = 0; id < points.size(); ++id)
    obstacle_of(belief.obstacles.cluster_of(id), obstacles).points_world.push_back(points[id]);
  for (const ScanCluster& seen : belief.scan_clusters) {
    RelevantObstacle& obstacle = obstacle_of(seen.cluster, obstacles);
    obstacle.cut_right |= seen.cut_right;
    obstacle.cut_left |= seen.cut_left;
  }
  return obstacles;
}

void find_closest(RelevantObstacle& obstacle, const Vec2& vehicle) {
  double best_sq = std::numeric_limits<double>::infinity();
  for (const Vec2& p : obstacle.points_world) {
    const double distance_sq = (p - vehicle).squaredNorm();
    if (distance_sq < best_sq) {
      best_sq = distance_sq;
      obstacle.closest_world = p;
    }
  }
  obstacle.distance_m = std::sqrt(best_sq);
}

// The map also holds what lies far beyond the range finder: no farther than that.
double reach_m(const Belief& belief) {
  return belief.scan ? belief.scan->max_range_m : std::numeric_limits<double>::infinity();
}

bool matters(const RelevantObstacle& obstacle, const Belief& belief, const Vec2& goal,
             const Config& config) {
  if (config.relevance == Config::Relevance::in_sight) {
    return std::any_of(belief.scan_clusters.begin(), belief.scan_clusters.end(),
                       [&](const ScanCluster& seen) { return seen.cluster == obstacle.cluster; });
  }
  const Vec2& vehicle = belief.pose_world.p_world;
  const double reach = reach_m(belief);
  return std::any_of(obstacle.points_world.begin(), obstacle.points_world.end(),
                     [&](const Vec2& p) {
                       return (p - vehicle).squaredNorm() <= reach * reach &&
                              in_goal_corridor(p, vehicle, goal, config.corridor_half_width_m);
                     });
}

}  // namespace

bool in_goal_corridor(const Vec2& point, const Vec2& vehicle, const Vec2& goal,
                      double half_width_m) {
  const Vec2 way = goal - vehicle;
  const Vec2 to_point = point - vehicle;
  const double along = to_point.dot(way);
  const double length_sq = way.squaredNorm();
  if (along <= 0 || along >= length_sq) return false;
  const double across = cross(way, to_point);
  return across * across <= half_width_m * half_width_m * length_sq;
}

std::vector<RelevantObstacle> relevant_obstacles(const Belief& belief, const Vec2& goal_world,
                                                 const Config& config) {
  const Vec2& vehicle = belief.pose_world.p_world;
  const Vec2 way = goal_world - vehicle;
  std::vector<RelevantObstacle> obstacles =
      config.source == Config::Source::scan ? in_sight(belief) : on_map(belief);
  std::erase_if(obstacles, [&](const RelevantObstacle& each) {
    return !matters(each, belief, goal_world, config);
  });
  if (config.passed == Config::Passed::dropped) {
    for (RelevantObstacle& each : obstacles)
      std::erase_if(each.points_world, [&](const Vec2& p) { return (p - vehicle).dot(way) <= 0; });
  }
  std::erase_if(obstacles, [](const RelevantObstacle& each) { return each.points_world.empty(); });
  for (RelevantObstacle& each : obstacles) find_closest(each, vehicle);
  std::stable_sort(obstacles.begin(), obstacles.end(),
                   [](const RelevantObstacle& a, const RelevantObstacle& b) {
                     return a.distance_m < b.distance_m;
                   });
  return obstacles;
}

}  // namespace voronaut
