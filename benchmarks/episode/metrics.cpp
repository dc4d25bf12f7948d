#include "voronaut/benchmarks/episode/metrics.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>
#include <numeric>

namespace voronaut {

double path_length_m(std::span<const Tick> ticks) {
  double length_m = 0;
  for (std::size_t i = 1; i < ticks.size(); ++i) {
    length_m += (ticks[i].state.p_world - ticks[i - 1].state.p_world).head<2>().norm();
  }
  return length_m;
}

double clearance_smallest_m(std::span<const Tick> ticks) {
  if (ticks.empty()) return kAbsent;
  return std::ranges::min(ticks, {}, &Tick::clearance_m).clearance_m;
}

double clearance_mean_m(std::span<const Tick> ticks) {
  if (ticks.empty()) return kAbsent;
  double sum_m = 0;
  for (const Tick& tick : ticks) sum_m += tick.clearance_m;
  return sum_m / static_cast<double>(ticks.size());
}

double speed_mean_m_s(std::span<const Tick> ticks, double departure_s) {
  const auto first =
      std::ranges::find_if(ticks, [&](const Tick& t) { return t.t_s >= departure_s; });
  const auto after_departure = ticks.subspan(static_cast<std::size_t>(first - ticks.begin()));
  if (after_departure.size() < 2) return 0;
  return path_length_m(after_departure) /
         (after_departure.back().t_s - after_departure.front().t_s);
}

double speed_max_m_s(std::span<const Tick> ticks) {
  double fastest_m_s = 0;
  for (const Tick& tick : ticks) {
    fastest_m_s = std::max(fastest_m_s, tick.state.v_world.head<2>().norm());
  }
  return fastest_m_s;
}

namespace {

// NaN stays NaN.
double at_least(double length_m, double least_m) { return length_m < least_m ? least_m : length_m; }

}  // namespace

double spl(bool success, double shortest_m, double flown_m, double goal_tolerance_m) {
  if (!success) return 0;
  const double least_m = at_least(shortest_m, goal_tolerance_m);
  return least_m / std::max(flown_m, least_m);
}

double path_ratio(double to_goal_m, double shortest_m, double goal_tolerance_m) {
  return at_least(to_goal_m, goal_tolerance_m) / at_least(shortest_m, goal_tolerance_m);
}

TrackingError tracking_error(std::span<const ScanEvent> scans) {
  double sum_m2 = 0;
  double largest_m = 0;
  std::size_t count = 0;
  for (const ScanEvent& scan : scans) {
    if (std::isnan(scan.path_distance_m)) continue;
    sum_m2 += scan.path_distance_m * scan.path_distance_m;
    largest_m = std::max(largest_m, scan.path_distance_m);
    ++count;
  }
  if (count == 0) return {};
  return {std::sqrt(sum_m2 / static_cast<double>(count)), largest_m};
}

double energy_j(std::span<const Tick> ticks, const Model& model) {
  double energy = ticks.empty() ? kAbsent : 0;
  for (std::size_t i = 1; i < ticks.size(); ++i)
    energy += model.power_w(ticks[i].state) * (ticks[i].t_s - ticks[i - 1].t_s);
  return energy;
}

double mean(std::span<const double> samples) {
  if (samples.empty()) return kAbsent;
  return std::accumulate(samples.begin(), samples.end(), 0.0) / static_cast<double>(samples.size());
}

std::string state_digest(std::span<const Tick> ticks) {
  std::uint64_t hash = 14695981039346656037ULL;
  const auto add = [&hash](double value) {
    hash = (hash ^ std::bit_cast<std::uint64_t>(value)) * 1099511628211ULL;
  };
  for (const Tick& tick : ticks) {
    const VehicleState& s = tick.state;
    for (int i = 0; i < 3; ++i) {
      add(s.p_world[i]);
      add(s.v_world[i]);
      add(s.w_body[i]);
    }
    for (int i = 0; i < 4; ++i) add(s.q_world_body.coeffs()[i]);
  }
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
  return text;
}

void add_path(RunRecord& record, std::span<const Tick> ticks, const Scenario& scenario) {
  const bool success = record.outcome == Outcome::goal_reached;
  const Vec2 end_world = ticks.back().state.p_world.head<2>();
  record.path_length_m = path_length_m(ticks);
  if (success) {
    const double left_m = (end_world - scenario.goal_world).norm();
    record.path_ratio = path_ratio(record.path_length_m + left_m, record.shortest_length_m,
                                   scenario.goal_tolerance_m);
  }
  record.spl =
      spl(success, record.shortest_length_m, record.path_length_m, scenario.goal_tolerance_m);
  record.clearance_smallest_m = clearance_smallest_m(ticks);
  record.clearance_mean_m = clearance_mean_m(ticks);
  record.end_x_m = end_world.x();
  record.end_y_m = end_world.y();
}

}  // namespace voronaut
