#include "voronaut/tests/reports/synthetic_run.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <random>

namespace voronaut::synthetic {

namespace {

constexpr double kBodyRadius = 0.25;
constexpr double kMaxRange = 2.5;
constexpr double kPeriod = 0.05;

double uniform(std::mt19937_64& engine, double low, double high) {
  return low + (high - low) * static_cast<double>(engine() >> 11U) * 0x1p-53;
}

double clearance(const TraceWorld& world, double x, double y) {
  double best = std::numeric_limits<double>::infinity();
  for (const auto& [cx, cy, r] : world.circles) {
    best = std::min(best, std::hypot(x - cx, y - cy) - r);
  }
  return best;
}

float cast_ray(const TraceWorld& world, double x, double y, double angle) {
  double best = kMaxRange;
  const double dx = std::cos(angle);
  const double dy = std::sin(angle);
  for (const auto& [cx, cy, r] : world.circles) {
    const double along = (cx - x) * dx + (cy - y) * dy;
    const double across = (cx - x) * dy - (cy - y) * dx;
    if (along > 0 && std::abs(across) < r) {
      best = std::min(best, std::max(0.01, along - std::sqrt(r * r - across * across)));
    }
  }
  return static_cast<float>(best);
}

void add_known_points(Trace& trace, const TraceWorld& world, const TraceFrame& frame) {
  const double heading = std::atan2(frame.heading_y, frame.heading_x);
  for (std::size_t i = 0; i < frame.range_m.size(); ++i) {
    const double range = static_cast<double>(frame.range_m[i]);
    if (range >= kMaxRange) {
      continue;
    }
    const double angle =
        heading +
        trace.field_of_view_rad *
            (static_cast<double>(i) / static_cast<double>(frame.range_m.size() - 1) - 0.5);
    const TracePoint p{frame.x_m + range * std::cos(angle), frame.y_m + range * std::sin(angle)};
    const bool known = std::any_of(
        trace.known_points.begin(), trace.known_points.end(),
        [&p](const TracePoint& q) { return std::hypot(p.x_m - q.x_m, p.y_m - q.y_m) < 0.08; });
    if (known) {
      continue;
    }
    std::uint32_t label = 0;
    for (std::uint32_t k = 0; k < world.circles.size(); ++k) {
      const auto& [cx, cy, r] = world.circles[k];
      label = std::abs(std::hypot(p.x_m - cx, p.y_m - cy) - r) < 1e-3 ? k : label;
    }
    // Each circle is two clusters that merge (merge_clusters).
    const bool merged =
        std::any_of(trace.merges.begin(), trace.merges.end(),
                    [label](const TraceMerge& merge) { return merge.into == 2 * label; });
    const std::uint32_t half = !merged && trace.known_points.size() % 2 == 1 ? 1 : 0;
    trace.known_points.push_back(p);
    trace.cluster_of.push_back(2 * label + half);
  }
}

// From a while after the first of its points on, a circle is one cluster.
void merge_clusters(Trace& trace, std::uint32_t frame) {
  constexpr std::size_t kAlone = 20;
  for (std::size_t i = 0; i + kAlone < trace.cluster_of.size(); ++i) {
    const std::uint32_t label = trace.cluster_of[i];
    const auto is_of_label = [label](const TraceMerge& merge) { return merge.from == label; };
    if (label % 2 == 1 && std::none_of(trace.merges.begin(), trace.merges.end(), is_of_label)) {
      trace.merges.push_back({frame, label, label - 1});
    }
  }
}

// A ring of edges around each circle that stays, and a fan of others that is new in each search.
void add_search(Trace& trace, const TraceWorld& world, const TraceFrame& frame) {
  constexpr int kRing = 12;
  const int search = trace.searches++;
  trace.kept_searches = trace.searches;
  const auto round = [](const TracePoint& p) {
    return TracePoint{std::round(100 * p.x_m) / 100, std::round(100 * p.y_m) / 100};
  };
  const auto on_ring = [&](const std::array<double, 3>& circle, int k) {
    const double angle = 2 * std::numbers::pi * k / kRing;
    const double radius = circle[2] + 0.5;
    return round({circle[0] + radius * std::cos(angle), circle[1] + radius * std::sin(angle)});
  };
  const std::size_t ring_edges = world.circles.size() * kRing;
  for (std::size_t i = 0; i < ring_edges; ++i) {
    const int k = static_cast<int>(i) % kRing;
    const auto& circle = world.circles[i / kRing];
    if (search == 0) {
      trace.edges.push_back({on_ring(circle, k), on_ring(circle, k + 1), 0, 0});
    }
    trace.edges[i].last_search = search;
  }
  const TracePoint here = round({frame.x_m, frame.y_m});
  for (int k = 0; k < 40; ++k) {
    const double angle = 2 * std::numbers::pi * k / 40;
    trace.edges.push_back({here,
                           round({frame.x_m + 2 * std::cos(angle), frame.y_m + std::sin(angle)}),
                           search, search});
  }
}

std::vector<TracePoint> hull_of(std::vector<TracePoint> points) {
  const auto cross = [](const TracePoint& o, const TracePoint& a, const TracePoint& b) {
    return (a.x_m - o.x_m) * (b.y_m - o.y_m) - (a.y_m - o.y_m) * (b.x_m - o.x_m);
  };
  std::sort(points.begin(), points.end(), [](const TracePoint& a, const TracePoint& b) {
    return a.x_m != b.x_m ? a.x_m < b.x_m : a.y_m < b.y_m;
  });
  std::vector<TracePoint> hull;
  for (int pass = 0; pass < 2; ++pass) {
    const std::size_t base = hull.size();
    for (const TracePoint& p : points) {
      while (hull.size() >= base + 2 && cross(hull[hull.size() - 2], hull.back(), p) <= 0) {
        hull.pop_back();
      }
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

void add_hulls(Trace& trace, std::size_t labels) {
  for (std::uint32_t label = 0; label < labels; ++label) {
    std::vector<TracePoint> members;
    for (std::size_t i = 0; i < trace.known_points.size(); ++i) {
      if (trace.cluster_of[i] / 2 == label) {
        members.push_back(trace.known_points[i]);
      }
    }
    if (members.size() > 2) {
      trace.hulls.push_back(hull_of(members));
    }
  }
}

}  // namespace

TraceWorld make_world(const std::string& world_id, std::uint64_t seed, int obstacles) {
  std::mt19937_64 engine(seed);
  TraceWorld world{.world_id = world_id,
                   .bounds_min = {-2, -2},
                   .bounds_max = {12, 12},
                   .circles = {},
                   .polygons = {{{-1.5, 9.0}, {0.0, 9.0}, {0.0, 10.5}, {-1.5, 10.5}}},
                   .segments = {{TracePoint{9.0, -1.0}, TracePoint{11.5, 1.5}}},
                   .start = {0, 0},
                   .goal = {10, 10}};
  while (static_cast<int>(world.circles.size()) < obstacles) {
    const double along = uniform(engine, 1.5, 8.5);
    const double x = along + uniform(engine, -3.0, 3.0);
    const double y = along - uniform(engine, -3.0, 3.0);
    const double r = uniform(engine, 0.2, 0.8);
    if (clearance(world, x, y) > r + 0.9) {
      world.circles.push_back({x, y, r});
    }
  }
  return world;
}

Trace make_trace(const std::string& trial_id, const TraceWorld& world, std::uint64_t seed,
                 Outcome outcome, int rays) {
  std::mt19937_64 engine(seed);
  Trace trace;
  trace.trial_id = trial_id;
  trace.body_radius_m = kBodyRadius;
  trace.clearance_min_m = 0.4;
  trace.field_of_view_rad = std::numbers::pi / 2;
  trace.max_range_m = kMaxRange;
  trace.modes = {"none", "left", "right", "between"};
  trace.replan_reasons = {"no_plan", "invalidated"};
  trace.solve_ends = {"planner", "state_checks"};
  double x = world.start.x_m;
  double y = world.start.y_m;
  double heading = std::numbers::pi / 4;
  const double push = uniform(engine, 0.6, 1.1);
  const double stop_at = outcome == Outcome::goal_reached ? 1e9 : uniform(engine, 2.0, 6.0);
  for (int i = 0; i < 600; ++i) {
    const double gx = world.goal.x_m - x;
    const double gy = world.goal.y_m - y;
    const double to_goal = std::hypot(gx, gy);
    double fx = gx / to_goal;
    double fy = gy / to_goal;
    double side = 0;
    for (const auto& [cx, cy, r] : world.circles) {
      const double distance = std::hypot(x - cx, y - cy);
      const double strength = push * std::exp(-(distance - r) / 0.4);
      fx += strength * ((x - cx) - (y - cy)) / distance;
      fy += strength * ((y - cy) + (x - cx)) / distance;
      side += strength;
    }
    const double norm = std::hypot(fx, fy);
    const double speed = std::min({2.5, 0.5 + 2.0 * i * kPeriod, 0.3 + to_goal});
    TraceFrame frame;
    frame.t_s = i * kPeriod;
    frame.x_m = x;
    frame.y_m = y;
    frame.z_m = 1.0;
    frame.vx_m_s = speed * fx / norm;
    frame.vy_m_s = speed * fy / norm;
    frame.heading_x = std::cos(heading);
    frame.heading_y = std::sin(heading);
    frame.tilt_rad = 0.1 + 0.05 * std::sin(0.2 * i);
    frame.clearance_m = clearance(world, x, y);
    frame.actuators = {300 + 10 * std::sin(0.3 * i), 300 + 10 * std::cos(0.3 * i), 305, 295};
    frame.planning_time_us = uniform(engine, 20, 90);
    frame.target_x_m = x + fx / norm;
    frame.target_y_m = y + fy / norm;
    frame.mode = side < 0.1 ? 0 : (side < 0.4 ? 1 : 3);
    if (i % 40 == 0) {
      trace.plans.push_back({{x, y}, {frame.target_x_m, frame.target_y_m}, world.goal});
      add_search(trace, world, frame);
      frame.replan = i == 0 ? 0 : 1;
      frame.solve_end = i % 80 == 0 ? 1 : 0;
    }
    frame.search = trace.searches - 1;
    frame.speed_scale = std::clamp(0.001 * std::round(1000 * frame.clearance_m), 0.05, 1.0);
    frame.tube = {{x, y},
                  {x + 0.1 * frame.vx_m_s, y + 0.1 * frame.vy_m_s},
                  {x + 0.3 * frame.vx_m_s + 0.02, y + 0.3 * frame.vy_m_s}};
    frame.plan = static_cast<int>(trace.plans.size()) - 1;
    for (int k = 0; k < rays; ++k) {
      frame.range_m.push_back(cast_ray(
          world, x, y,
          heading + trace.field_of_view_rad * (static_cast<double>(k) / (rays - 1) - 0.5)));
    }
    add_known_points(trace, world, frame);
    merge_clusters(trace, static_cast<std::uint32_t>(i));
    frame.known_points = trace.known_points.size();
    trace.frames.push_back(frame);
    if (to_goal < 0.2 || frame.t_s > stop_at) {
      break;
    }
    x += frame.vx_m_s * kPeriod;
    y += frame.vy_m_s * kPeriod;
  }
  add_hulls(trace, world.circles.size());
  return trace;
}

RunRecord make_record(const std::string& trial_id) {
  RunRecord record;
  record.trial_id = trial_id;
  record.suite = "synthetic";
  record.scenario = "between";
  record.scenario_group = "paper";
  record.world_id = "w0";
  record.vehicle = "quadrotor";
  record.regulator = "pd_rate";
  record.planner = "repaired";
  record.repetition = 2;
  record.seed = -9'000'000'000'000'000'001;
  record.outcome = Outcome::goal_reached;
  record.reason = "at rest 0.1 m from the goal";
  record.duration_s = 0.1 + 0.2;
  record.path_length_m = 15.25;
  record.shortest_length_m = 14.2;
  record.path_ratio = 15.25 / 14.2;
  record.spl = 14.2 / 15.25;
  record.clearance_smallest_m = 0.51;
  record.replans = 17;
  record.modes = "none left";
  record.planning_time_us_mean = 41.5;
  return record;
}

namespace {

void fill_results(RunRecord& record, std::mt19937_64& engine, std::size_t planner) {
  const auto rank = static_cast<double>(planner);
  const bool good = uniform(engine, 0, 1) < 0.95 - 0.2 * rank;
  constexpr std::array kBad{Outcome::collision, Outcome::timeout, Outcome::stuck,
                            Outcome::out_of_bounds, Outcome::crash};
  record.outcome = good ? Outcome::goal_reached : kBad[engine() % kBad.size()];
  record.path_ratio = good ? 1.02 + uniform(engine, 0, 0.2) * (1.0 + rank) : kAbsent;
  record.spl = good ? 1.0 / record.path_ratio : 0.0;
  record.path_length_m = 14.2 * (good ? record.path_ratio : uniform(engine, 0.2, 1.5));
  record.duration_s = record.path_length_m / uniform(engine, 1.0, 2.0);
  record.clearance_smallest_m =
      record.outcome == Outcome::collision ? 0.25 : uniform(engine, 0.3, 0.8);
  record.clearance_mean_m = record.clearance_smallest_m + 0.5;
  record.speed_mean_m_s = uniform(engine, 0.8, 2.0);
  record.speed_max_m_s = 2.5;
  record.replans = static_cast<std::int64_t>(engine() % 40);
  record.state_checks = 100 + static_cast<std::int64_t>(engine() % (1000 + 4000 * planner));
  record.planning_time_us_mean = uniform(engine, 20, 200);
  record.step_time_us_mean = record.planning_time_us_mean + 30;
  record.reason = good ? "at rest at the goal" : "ended under way";
}

}  // namespace

Run make_run(const RunConfig& config) {
  Run run;
  std::mt19937_64 engine(config.seed);
  const auto add_trial = [&](const std::string& group, const std::string& scenario,
                             const TraceWorld& world, std::size_t planner, int repetition) {
    std::array<char, 32> id{};
    std::snprintf(id.data(), id.size(), "t%06zu", run.records.size());
    RunRecord& record = run.records.emplace_back(make_record(id.data()));
    record.scenario = scenario;
    record.scenario_group = group;
    record.world_id = world.world_id;
    record.planner = config.planners[planner];
    record.repetition = repetition;
    record.seed = static_cast<std::int64_t>(engine() >> 1U);
    fill_results(record, engine, planner);
    if (repetition < config.traced_repetitions) {
      const Trace& trace = run.traces.emplace_back(
          make_trace(id.data(), world, engine(), record.outcome, config.rays));
      record.end_x_m = trace.frames.back().x_m;
      record.end_y_m = trace.frames.back().y_m;
    }
  };
  for (std::size_t g = 0; g < config.groups.size(); ++g) {
    for (int s = 0; s < config.scenarios_per_group; ++s) {
      const std::string scenario = config.groups[g] + "-" + std::to_string(s);
      run.worlds.push_back(make_world("world-" + scenario, engine(), 4 + 3 * static_cast<int>(g)));
      for (std::size_t p = 0; p < config.planners.size(); ++p) {
        for (int repetition = 0; repetition < config.repetitions; ++repetition) {
          add_trial(config.groups[g], scenario, run.worlds.back(), p, repetition);
        }
      }
    }
  }
  return run;
}

}  // namespace voronaut::synthetic
