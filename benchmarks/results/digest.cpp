#include "voronaut/benchmarks/results/digest.h"

#include <cmath>
#include <cstdint>
#include <sstream>

#include "voronaut/benchmarks/trial/sha256.h"
#include "voronaut/environments/config/config_node.h"
#include "voronaut/reports/record_columns.h"

namespace voronaut {

std::string deterministic_text(const RunRecord& record) {
  std::string text;
  for (const RecordColumn& column : record_columns())
    if (column.kind == ColumnKind::deterministic)
      text.append(column.name).append("=").append(cell_text(record, column)).append("\n");
  return text;
}

std::string difference_text(const RunRecord& stored, const RunRecord& flown) {
  std::istringstream old_lines(deterministic_text(stored));
  std::istringstream new_lines(deterministic_text(flown));
  std::string text;
  for (std::string a, b; std::getline(old_lines, a) && std::getline(new_lines, b);) {
    if (a == b) continue;
    text += (text.empty() ? "" : "; ") + a + ", now " + b.substr(b.find('=') + 1);
  }
  return text;
}

std::string digest(const std::vector<RunRecord>& records) {
  Sha256 hash;
  for (const RunRecord& record : records) hash.add(deterministic_text(record) + "\n");
  return hash.hex();
}

std::string digest(const ResultStore& store) {
  Sha256 hash;
  store.for_each_record([&](const RunRecord& r) { hash.add(deterministic_text(r) + "\n"); });
  return hash.hex();
}

namespace {

std::string flight_text(const RunRecord& r) {
  std::string text(to_string(r.outcome));
  for (const double number :
       {r.duration_s, r.path_length_m, r.shortest_length_m, r.shortest_at_clearance_m, r.path_ratio,
        r.spl, r.clearance_smallest_m, r.clearance_mean_m, r.speed_mean_m_s, r.speed_max_m_s,
        r.end_x_m, r.end_y_m})
    text += "\n" + (std::isnan(number) ? std::string() : number_text(number));
  for (const std::int64_t count :
       {r.replans, r.state_checks, r.budget_stops, r.map_points, r.map_obstacles})
    text += "\n" + std::to_string(count);
  return text + "\n" + r.state_digest + "\n";
}

}  // namespace

bool same_flight(const RunRecord& a, const RunRecord& b) {
  return flight_text(a) == flight_text(b);
}

std::string flights_digest(const ResultStore& store) {
  Sha256 hash;
  const auto add = [&hash](const RunRecord& r) {
    hash.add(r.scenario + "\n" + r.vehicle + "\n" + r.planner + "\n" +
             std::to_string(r.repetition) + "\n" + flight_text(r));
  };
  store.for_each_record(add, "scenario, vehicle, planner, repetition, trial_id");
  return hash.hex();
}

}  // namespace voronaut
