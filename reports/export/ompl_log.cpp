#include "voronaut/reports/export/ompl_log.h"

#include "voronaut/reports/record_columns.h"

namespace voronaut {
namespace {

std::string block(std::string text) {
  if (!text.empty() && text.back() != '\n') text += '\n';
  return "<<<|\n" + text + "|>>>\n";
}

std::string columns_text(const std::vector<BenchmarkColumn>& columns, const char* what) {
  std::string text = std::to_string(columns.size()) + " " + what + "\n";
  for (const BenchmarkColumn& column : columns) text += column.name + " " + column.type + "\n";
  return text;
}

void add_planner(const PlannerBenchmark& benchmark, const BenchmarkedPlanner& planner,
                 std::string& log) {
  log += planner.name + "\n" + std::to_string(planner.settings.size()) + " common properties\n";
  for (const std::string& setting : planner.settings) log += setting + "\n";
  log += columns_text(benchmark.run_columns, "properties for each run");
  log += std::to_string(planner.runs.size()) + " runs\n";
  for (const BenchmarkRow& run : planner.runs) {
    for (const std::string& value : run) log += value + "; ";
    log += "\n";
  }
  log += columns_text(benchmark.progress_columns, "progress properties for each run");
  log += std::to_string(planner.progress.size()) + " runs\n";
  for (const std::vector<BenchmarkRow>& samples : planner.progress) {
    for (const BenchmarkRow& sample : samples) {
      for (const std::string& value : sample) log += value + ",";
      log += ";";
    }
    log += "\n";
  }
  log += ".\n";
}

}  // namespace

std::string settings_text(const BenchmarkedPlanner& planner) {
  std::string text;
  for (const std::string& setting : planner.settings) text += setting + "\n;";
  return text;
}

std::string ompl_log(const PlannerBenchmark& benchmark) {
  std::string log = "Voronaut version " + benchmark.version + "\nExperiment " + benchmark.name +
                    "\nRunning on " + benchmark.host + "\nStarting at " + benchmark.date + "\n";
  log += block(benchmark.setup) + block(benchmark.processor);
  log += std::to_string(benchmark.seed) + " is the random seed\n";
  log += cell_text(benchmark.time_limit_s) + " seconds per run\n";
  log += cell_text(benchmark.memory_limit_mb) + " MB per run\n";
  log += std::to_string(benchmark.runs_per_planner) + " runs per planner\n";
  log += cell_text(benchmark.total_time_s) + " seconds spent to collect the data\n";
  log += "1 enum type\n" + benchmark.enum_name;
  for (const std::string& word : benchmark.enum_words) log += "|" + word;
  log += "\n" + std::to_string(benchmark.planners.size()) + " planners\n";
  for (const BenchmarkedPlanner& planner : benchmark.planners) add_planner(benchmark, planner, log);
  return log;
}

}  // namespace voronaut
