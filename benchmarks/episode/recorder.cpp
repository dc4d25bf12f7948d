#include "voronaut/benchmarks/episode/recorder.h"

#include <algorithm>
#include <utility>

#include "voronaut/benchmarks/episode/index_of.h"

namespace voronaut {

Recorder::Recorder(const World& world, const VehicleSpec& vehicle, Navigator& navigator,
                   bool keep_scans)
    : body_clearance_(world.index(), vehicle),
      clearance_(world.index()),
      navigator_(navigator),
      keep_scans_(keep_scans) {
  navigator_.observe(this);
}

void Recorder::step_begins(double now_s, const VehicleState& state) {
  record_tick(now_s, state);
  scanned_ = false;
  log_.step.start();
}

void Recorder::step_ends() {
  log_.step.stop();
  if (scanned_) record_scan();
}

EpisodeLog Recorder::finish(double now_s, const VehicleState& state, const Referee& referee) {
  record_tick(now_s, state);
  log_.departure_s = navigator_.report().departed_s.value_or(0);
  log_.verdict = *referee.verdict();
  log_.end_s = referee.end_s();
  log_.body_clearance_smallest_m = body_clearance_.smallest_m();
  return std::move(log_);
}

void Recorder::stage_begins(Stage stage) {
  scanned_ = true;
  (stage == Stage::mapping ? log_.mapping : log_.planning).start();
}

void Recorder::stage_ends(Stage stage) {
  (stage == Stage::mapping ? log_.mapping : log_.planning).stop();
}

void Recorder::path_adopted(const Path& path) {
  if (keep_scans_) log_.plans.push_back(path);
}

void Recorder::record_tick(double now_s, const VehicleState& state) {
  const double clearance_m = clearance_.at(state.p_world.head<2>());
  log_.ticks.push_back({now_s, state, clearance_m});
  body_clearance_.add(state, clearance_m);
}

void Recorder::record_scan() {
  const NavigationReport& report = navigator_.report();
  if (report.replan != ReplanReason::none) {
    ++log_.replans;
    ++log_.solve_ends[static_cast<std::size_t>(report.solve_end)];
  }
  ScanEvent event;
  event.tick = log_.ticks.size() - 1;
  event.setpoint = report.setpoint;
  event.lookahead_world = report.lookahead_world;
  event.mode = mode_of_scan(report);
  event.plan = navigator_.path().empty() ? -1 : static_cast<int>(log_.plans.size()) - 1;
  if (const Path& path = navigator_.path(); !path.empty()) {
    const Vec2 p = log_.ticks.back().state.p_world.head<2>();
    event.path_distance_m = path.project(p, 0, path.length_m()).distance_m;
  }
  event.replan = report.replan;
  event.solve_end = report.solve_end;
  event.known_points = navigator_.known().points().size();
  event.executive = report.executive;
  event.speed_scale = report.speed_scale;
  event.planning_time_us = log_.planning.samples_us().back();
  if (keep_scans_) keep_for_replay(event);
  log_.scans.push_back(std::move(event));
}

// A planner that was not asked goes on with what it said last.
int Recorder::mode_of_scan(const NavigationReport& report) {
  const int mode = index_of(log_.modes, report.planner_mode);
  const bool asked = report.replan != ReplanReason::none;
  return mode < 0 && !asked && !log_.scans.empty() ? log_.scans.back().mode : mode;
}

void Recorder::keep_for_replay(ScanEvent& event) {
  const NavigationReport& report = navigator_.report();
  const std::vector<double>& range_m = navigator_.scan().range_m;
  event.tube.assign(report.tube_world.begin(), report.tube_world.end());
  event.range_m.assign(range_m.begin(), range_m.end());
  log_.clusters.note(log_.scans.size(), navigator_.known());
  if (event.replan != ReplanReason::none && !navigator_.planner_traits().plans_on_every_scan)
    log_.searches.add(log_.searches.full() ? std::vector<Segment>{} : navigator_.searched_edges());
  event.search = log_.searches.searches() - 1;
}

}  // namespace voronaut
