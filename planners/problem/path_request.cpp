#include "voronaut/planners/problem/path_request.h"

#include <algorithm>
#include <cmath>

namespace voronaut {

namespace {

constexpr double kSamePlace_m = 1e-9;  // also how far rounding may lead out of the bounds

}  // namespace

bool is_place(const Vec2& p_world) {
  // Said so that whatever is no number fails; as below.
  return std::abs(p_world.x()) <= kFarthestPlace_m && std::abs(p_world.y()) <= kFarthestPlace_m;
}

std::string flaw_of(std::span<const Vec2> path_world, const PathRequest& request) {
  if (path_world.empty()) return "its path has no positions";
  if (!std::ranges::all_of(path_world, is_place)) return "its path has a position that is no place";
  const auto near = [](const Vec2& a, const Vec2& b, double most_m) {
    return (a - b).norm() <= most_m;
  };
  if (!near(path_world.front(), request.start_world, kSamePlace_m))
    return "its path begins elsewhere";
  const bool arrives = near(path_world.back(), request.goal_world, request.goal_tolerance_m) ||
                       near(path_world.back(), request.place_world, request.goal_tolerance_m);
  return arrives ? "" : "its path does not end at the goal";
}

bool is_clear(std::span<const Vec2> path_world, const PathRequest& request,
              const KnownGeometry& geometry) {
  const Vec2 rim(kSamePlace_m, kSamePlace_m);
  const Bounds bounds{request.bounds_world.min - rim, request.bounds_world.max + rim};
  const auto within = [&](const Vec2& p) { return bounds.contains(p); };
  if (path_world.empty() || !std::ranges::all_of(path_world, within)) return false;
  if (!geometry.motion_is_clear(path_world.front(), path_world.front())) return false;
  for (std::size_t i = 1; i < path_world.size(); ++i) {
    if (!geometry.motion_is_clear(path_world[i - 1], path_world[i])) return false;
  }
  return true;
}

}  // namespace voronaut
