#include "voronaut/benchmarks/static_planning/static_trace.h"

#include <algorithm>
#include <cmath>

#include "voronaut/benchmarks/episode/search_trace.h"
#include "voronaut/environments/world.h"

namespace voronaut {

namespace {

constexpr double kWalk_m_s = 1;
constexpr double kStep_s = 0.05;

std::vector<TracePoint> polyline(const Path& path) {
  std::vector<TracePoint> points;
  if (path.empty()) return points;
  points.push_back({path.front().x(), path.front().y()});
  for (const PathSegment& s : path.segments()) points.push_back({s.end.x(), s.end.y()});
  return points;
}

// At the start, where there is no path.
TraceFrame frame_at(double at_m, const Path& path, const Scenario& scenario) {
  const Vec2 p = path.empty() ? scenario.start_world : path.point_at(at_m);
  const Vec2 along = path.empty() ? Vec2(1, 0) : path.direction_at(at_m);
  const double speed_m_s = path.empty() ? 0 : kWalk_m_s;
  TraceFrame frame;
  frame.t_s = at_m / kWalk_m_s;
  frame.x_m = p.x();
  frame.y_m = p.y();
  frame.vx_m_s = speed_m_s * along.x();
  frame.vy_m_s = speed_m_s * along.y();
  frame.heading_x = along.x();
  frame.heading_y = along.y();
  frame.clearance_m = scenario.world->clearance_m(p);
  frame.target_x_m = scenario.goal_world.x();
  frame.target_y_m = scenario.goal_world.y();
  frame.mode = 0;
  frame.plan = path.empty() ? -1 : 0;
  return frame;
}

}  // namespace

Trace static_trace(const TrialSpec& spec, const Path& path,
                   const std::vector<Improvement>& improvements,
                   const std::vector<Segment>& searched) {
  Trace trace;
  trace.trial_id = spec.trial_id;
  trace.static_planning = true;
  trace.body_radius_m = spec.vehicle.body_radius_m;
  trace.clearance_min_m = spec.vehicle.planning_clearance_m;
  trace.modes = {path.empty() ? "no path" : "along the path at 1 m/s"};
  for (const Improvement& i : improvements) {
    trace.improvements.push_back({static_cast<std::int64_t>(i.state_checks), i.time_s, i.cost});
  }
  SearchHistory history;
  history.add(searched);
  history.write_to(trace);
  if (!path.empty()) trace.plans.push_back(polyline(path));

  const double length_m = path.empty() ? 0 : path.length_m();
  const double step_m = std::max(kWalk_m_s * kStep_s, length_m / (kMostStaticFrames - 1));
  const auto steps =
      std::min(static_cast<int>(std::ceil(length_m / step_m)), kMostStaticFrames - 1);
  for (int i = 0; i <= steps; ++i) {
    trace.frames.push_back(frame_at(std::min(i * step_m, length_m), path, spec.scenario));
    trace.frames.back().search = trace.kept_searches - 1;
  }
  return trace;
}

}  // namespace voronaut
