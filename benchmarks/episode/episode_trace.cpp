#include "voronaut/benchmarks/episode/episode_trace.h"

#include <algorithm>
#include <cmath>

#include "voronaut/benchmarks/episode/index_of.h"
#include "voronaut/benchmarks/episode/search_trace.h"

namespace voronaut {

namespace {

TracePoint trace_point(const Vec2& p) { return {p.x(), p.y()}; }

std::vector<TracePoint> vertices(const Path& path) {
  std::vector<TracePoint> points{trace_point(path.front())};
  for (const PathSegment& segment : path.segments()) points.push_back(trace_point(segment.end));
  return points;
}

// Angle between the body's z axis and the vertical; drawn only, so any cosine of rounding is
// clamped.
double tilt_rad(const VehicleState& state) {
  const double cosine = (state.q_world_body * Vec3::UnitZ()).z();
  return std::acos(std::clamp(cosine, -1.0, 1.0));
}

TraceFrame frame_at(const Tick& tick) {
  const VehicleState& state = tick.state;
  TraceFrame frame;
  frame.t_s = tick.t_s;
  frame.x_m = state.p_world.x();
  frame.y_m = state.p_world.y();
  frame.z_m = state.p_world.z();
  frame.vx_m_s = state.v_world.x();
  frame.vy_m_s = state.v_world.y();
  const Vec2 heading = state.heading_world();
  frame.heading_x = heading.x();
  frame.heading_y = heading.y();
  frame.tilt_rad = tilt_rad(state);
  frame.clearance_m = tick.clearance_m;
  frame.actuators = state.actuators;
  frame.target_x_m = frame.x_m;
  frame.target_y_m = frame.y_m;
  return frame;
}

TraceFrame frame_at(const ScanEvent& event, const Tick& tick) {
  TraceFrame frame = frame_at(tick);
  frame.planning_time_us = event.planning_time_us;
  frame.target_x_m = event.lookahead_world.x();
  frame.target_y_m = event.lookahead_world.y();
  frame.plan = event.plan;
  frame.speed_scale = event.speed_scale;
  for (const Vec2& p : event.tube) frame.tube.push_back(trace_point(p));
  frame.known_points = event.known_points;
  frame.range_m = event.range_m;
  return frame;
}

// What a reader of a replay asks: what does it do now? The executive's state, and while tracking
// the planner's mode where it has one.
std::string shown_mode(const ScanEvent& event, const EpisodeLog& log) {
  const bool has_mode = event.executive == ExecutiveState::tracking && event.mode >= 0;
  return has_mode ? log.modes[static_cast<std::size_t>(event.mode)]
                  : std::string(to_string(event.executive));
}

int replan_of(const ScanEvent& event, std::vector<std::string>& names) {
  const bool asked = event.replan != ReplanReason::none && event.replan != ReplanReason::every_scan;
  return asked ? index_of(names, std::string(to_string(event.replan))) : -1;
}

int solve_end_of(const ScanEvent& event, std::vector<std::string>& names) {
  const bool solved = event.replan != ReplanReason::none;
  return solved ? index_of(names, std::string(to_string(event.solve_end))) : -1;
}

void add_clusters(const EpisodeLog& log, const ObstacleSnapshot& known, Trace& trace) {
  for (const Vec2& p : known.points()) trace.known_points.push_back(trace_point(p));
  trace.cluster_of = log.clusters.labels();
  for (const auto& [scan, from, into] : log.clusters.merges()) {
    trace.merges.push_back({static_cast<std::uint32_t>(scan), from, into});
  }
  for (const ClusterId cluster : known.clusters()) {
    auto& hull = trace.hulls.emplace_back();
    for (const Vec2& p : known.hull(cluster)) hull.push_back(trace_point(p));
  }
}

}  // namespace

Trace trace_of(const TrialSpec& spec, const EpisodeLog& log, const ObstacleSnapshot& known) {
  Trace trace;
  trace.trial_id = spec.trial_id;
  trace.body_radius_m = spec.vehicle.body_radius_m;
  for (const Vec2& corner : spec.vehicle.footprint.corners_body)
    trace.footprint.push_back(trace_point(corner));
  trace.clearance_min_m = spec.vehicle.planning_clearance_m;
  trace.field_of_view_rad = spec.flight.range_finder.field_of_view_rad;
  trace.max_range_m = spec.flight.range_finder.max_range_m;
  for (const Path& plan : log.plans) trace.plans.push_back(vertices(plan));
  add_clusters(log, known, trace);
  log.searches.write_to(trace);
  for (const ScanEvent& event : log.scans) {
    TraceFrame& frame = trace.frames.emplace_back(frame_at(event, log.ticks[event.tick]));
    frame.mode = index_of(trace.modes, shown_mode(event, log));
    frame.replan = replan_of(event, trace.replan_reasons);
    frame.solve_end = solve_end_of(event, trace.solve_ends);
    frame.search = event.search < trace.kept_searches ? event.search : -1;
  }
  TraceFrame end = frame_at(log.ticks.back());
  end.known_points = trace.known_points.size();
  if (!trace.frames.empty()) {
    end.mode = trace.frames.back().mode;
    end.plan = trace.frames.back().plan;
    end.search = trace.frames.back().search;
    end.speed_scale = trace.frames.back().speed_scale;
  }
  trace.frames.push_back(std::move(end));
  return trace;
}

TraceWorld trace_world(const Scenario& scenario, const std::string& world_id) {
  TraceWorld world;
  world.world_id = world_id;
  world.bounds_min = trace_point(scenario.world->bounds().min);
  world.bounds_max = trace_point(scenario.world->bounds().max);
  world.start = trace_point(scenario.start_world);
  world.goal = trace_point(scenario.goal_world);
  const Shapes& shapes = scenario.world->shapes();
  for (const Circle& c : shapes.circles) {
    world.circles.push_back({c.center.x(), c.center.y(), c.radius_m});
  }
  for (const Polygon& polygon : shapes.polygons) {
    auto& outline = world.polygons.emplace_back();
    for (const Vec2& p : polygon.vertices) outline.push_back(trace_point(p));
  }
  for (const Segment& s : shapes.segments) {
    world.segments.push_back({trace_point(s.a), trace_point(s.b)});
  }
  return world;
}

}  // namespace voronaut
