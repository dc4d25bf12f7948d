#include "voronaut/reports/export/planner_benchmark.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>

#include "voronaut/reports/record_columns.h"

namespace voronaut {
namespace {

constexpr double kProgressPeriod_s = 0.5;

bool is_left_out(std::string_view column) {
  constexpr std::string_view kLeftOut[] = {"suite", "planner", "reason", "modes", "state_digest"};
  return std::find(std::begin(kLeftOut), std::end(kLeftOut), column) != std::end(kLeftOut);
}

std::string type_of(const RecordColumn& column) {
  if (std::holds_alternative<Outcome RunRecord::*>(column.member)) return "ENUM";
  if (std::holds_alternative<std::int64_t RunRecord::*>(column.member)) return "INTEGER";
  return std::holds_alternative<double RunRecord::*>(column.member) ? "REAL" : "STRING";
}

// The formats end a value at these.
std::string plain(std::string text) {
  for (char& c : text)
    if (c == ';' || c == ',' || c == '\n' || c == '\r') c = ' ';
  return text;
}

std::string finite_text(double value) { return std::isfinite(value) ? cell_text(value) : ""; }

std::string text_of(const RunRecord& record, const RecordColumn& column) {
  if (std::holds_alternative<Outcome RunRecord::*>(column.member))
    return std::to_string(static_cast<int>(record.outcome));
  if (const auto* number = std::get_if<double RunRecord::*>(&column.member))
    return finite_text(record.*(*number));
  return plain(cell_text(record, column));
}

std::string column_name(std::string_view name) {
  if (name == "seed") return "trial_seed";
  if (name == "outcome") return "status";
  return std::string(name);
}

const std::vector<BenchmarkColumn> kAlways = {
    {"time", "REAL"}, {"memory", "REAL"}, {"solved", "BOOLEAN"}};
const std::vector<BenchmarkColumn> kOfStaticPlans = {{"approximate_solution", "BOOLEAN"},
                                                     {"correct_solution", "BOOLEAN"},
                                                     {"solution_length", "REAL"},
                                                     {"solution_clearance", "REAL"}};

std::vector<BenchmarkColumn> run_columns(bool static_planning) {
  std::vector<BenchmarkColumn> columns = kAlways;
  if (static_planning) columns.insert(columns.end(), kOfStaticPlans.begin(), kOfStaticPlans.end());
  for (const RecordColumn& column : record_columns())
    if (!is_left_out(column.name)) columns.push_back({column_name(column.name), type_of(column)});
  return columns;
}

const char* flag(bool value) { return value ? "1" : "0"; }

// Values of kOfStaticPlans.
BenchmarkRow plan_found(const RunRecord& record) {
  if (!std::isfinite(record.path_length_m)) return BenchmarkRow(kOfStaticPlans.size());
  const bool collides = record.outcome == Outcome::collision;
  const bool leads_elsewhere = !collides && record.outcome != Outcome::goal_reached;
  return {flag(leads_elsewhere), flag(!collides), finite_text(record.path_length_m),
          finite_text(record.clearance_mean_m)};
}

BenchmarkRow run_row(const RunRecord& record, bool static_planning) {
  const double time_s = static_planning ? record.planning_time_us_mean * 1e-6 : record.duration_s;
  BenchmarkRow row = {finite_text(time_s), finite_text(record.memory_max_mb),
                      flag(record.outcome == Outcome::goal_reached)};
  if (static_planning)
    for (std::string& value : plan_found(record)) row.push_back(std::move(value));
  for (const RecordColumn& column : record_columns())
    if (!is_left_out(column.name)) row.push_back(text_of(record, column));
  return row;
}

std::vector<BenchmarkRow> progress_of(const Trace& trace, const TracePoint& goal) {
  std::vector<BenchmarkRow> rows;
  double flown_m = 0;
  double next_s = 0;
  double last_s = -1;
  for (std::size_t i = 0; i < trace.frames.size(); ++i) {
    const TraceFrame& frame = trace.frames[i];
    if (i > 0)
      flown_m +=
          std::hypot(frame.x_m - trace.frames[i - 1].x_m, frame.y_m - trace.frames[i - 1].y_m);
    const bool is_last = i + 1 == trace.frames.size();
    if ((frame.t_s < next_s && !is_last) || frame.t_s <= last_s) continue;
    rows.push_back({finite_text(std::hypot(goal.x_m - frame.x_m, goal.y_m - frame.y_m)),
                    finite_text(flown_m), finite_text(frame.planning_time_us),
                    finite_text(frame.t_s)});
    last_s = frame.t_s;
    next_s = frame.t_s + kProgressPeriod_s;
  }
  return rows;
}

// Cost over work of a static plan.
std::vector<BenchmarkRow> improvements_of(const Trace& trace) {
  std::vector<BenchmarkRow> rows;
  double last_s = -1;
  for (const TraceImprovement& i : trace.improvements) {
    if (i.time_s <= last_s) continue;  // the tables have one row for a moment
    rows.push_back({finite_text(i.cost_m), std::to_string(i.state_checks), finite_text(i.time_s)});
    last_s = i.time_s;
  }
  return rows;
}

const std::vector<BenchmarkColumn> kFlightProgress = {{"distance_to_goal_m", "REAL"},
                                                      {"flown_length_m", "REAL"},
                                                      {"planning_time_us", "REAL"},
                                                      {"time", "REAL"}};
const std::vector<BenchmarkColumn> kPlanProgress = {
    {"best_cost", "REAL"}, {"state_checks", "INTEGER"}, {"time", "REAL"}};

}  // namespace

void add_stored_runs(const ResultStore& store, PlannerBenchmark& benchmark) {
  benchmark.enum_name = "status";
  for (const OutcomeEntry& entry : kOutcomes) benchmark.enum_words.emplace_back(entry.name);
  benchmark.run_columns = run_columns(benchmark.static_planning);
  benchmark.progress_columns = benchmark.static_planning ? kPlanProgress : kFlightProgress;
  std::map<std::string, TracePoint> goals;
  for (const TraceWorld& world : store.worlds()) goals[world.world_id] = world.goal;
  std::map<std::string, BenchmarkedPlanner> planners;
  for (const RunRecord& record : store.records()) {
    BenchmarkedPlanner& planner = planners[record.planner];
    planner.name = record.planner;
    planner.runs.push_back(run_row(record, benchmark.static_planning));
    const auto trace = store.trace(record.trial_id);
    auto& samples = planner.progress.emplace_back();
    if (trace)
      samples = benchmark.static_planning ? improvements_of(*trace)
                                          : progress_of(*trace, goals[record.world_id]);
    if (std::isfinite(record.cpu_time_s)) benchmark.total_time_s += record.cpu_time_s;
  }
  for (auto& [name, planner] : planners) {
    const int runs = static_cast<int>(planner.runs.size());
    benchmark.runs_per_planner = std::max(benchmark.runs_per_planner, runs);
    benchmark.planners.push_back(std::move(planner));
  }
}

}  // namespace voronaut
