#include "voronaut/benchmarks/micro/replan_course.h"

#include <algorithm>
#include <array>

#include "voronaut/environments/world.h"
#include "voronaut/planners/navigation/plan_request.h"

namespace voronaut::micro {

namespace {

constexpr double kStep_m = 0.125;
constexpr std::size_t kScans_max = 20'000;

bool is_clear(const Path& path, double from_m, const KnownGeometry& geometry) {
  Vec2 at = path.point_at(from_m);
  double end_m = 0;
  for (const PathSegment& segment : path.segments()) {
    end_m += segment.length_m;
    if (end_m <= from_m) continue;
    if (!geometry.motion_is_clear(at, segment.end)) return false;
    at = segment.end;
  }
  return true;
}

}  // namespace

ReplanCourse::ReplanCourse(const std::string& family, std::uint64_t seed)
    : scenario_(ScenarioSpec::generated(
                    {}, WorldGenerator::read(ConfigNode::parse(family, "replan course")))
                    .instantiate(seed)),
      problem_{scenario_.world->bounds(), scenario_.goal_world} {}

void ReplanCourse::sense(const Vec2& p, const Vec2& heading, ObstacleBase& map) const {
  Scan scan;
  Random no_noise(1);
  range_finder_.sense(*scenario_.world, {p, heading}, 0, no_noise, scan);
  map.update(scan);
}

bool ReplanCourse::fly(const PlannerCatalog& planners, const Asked& asked) const {
  PlanningProblem guide(problem_);
  const PlannerEntry& entry = *planners.find("VoronoiRoadmap");
  const ompl::base::PlannerPtr planner = entry.make(guide.space_information());
  ObstacleBase map{ObstacleBaseConfig{}};
  Vec2 p = scenario_.start_world;
  Vec2 heading = scenario_.start_heading;
  // The look around before it sets off.
  for (const Vec2& direction : std::array{Vec2(1, 0), Vec2(0, 1), Vec2(-1, 0), Vec2(0, -1)})
    sense(p, direction, map);
  Path path;
  double station_m = 0;
  for (std::size_t scan = 0; scan < kScans_max; ++scan) {
    sense(p, heading, map);
    guide.update(map.snapshot(), p);
    if (path.empty() || !is_clear(path, station_m, guide.geometry())) {
      asked(map.snapshot(), p);
      path = ask_for_plan(*planner, entry.traits, guide, {}).path;
      station_m = 0;
      if (path.empty()) return false;
    }
    station_m += kStep_m;
    p = path.point_at(station_m);
    heading = path.direction_at(std::min(station_m + 1, path.length_m()));
    if ((p - problem_.goal_world).norm() <= problem_.goal_tolerance_m) return true;
  }
  return false;
}

}  // namespace voronaut::micro
