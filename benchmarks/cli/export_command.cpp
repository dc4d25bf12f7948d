#include <filesystem>
#include <fstream>
#include <ostream>
#include <sstream>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "voronaut/benchmarks/cli/commands.h"
#include "voronaut/benchmarks/results/output_folder.h"
#include "voronaut/reports/export/mcap_log.h"
#include "voronaut/reports/export/ompl_log.h"
#include "voronaut/reports/export/planner_arena.h"
#include "voronaut/reports/store/atomic_file.h"
#include "voronaut/reports/store/csv_writer.h"

namespace voronaut {
namespace {

using Json = nlohmann::json;

Json manifest_of(const OutputFolder& folder) {
  const std::filesystem::path file = folder.file("manifest.json");
  std::ifstream stream(file);
  Json manifest = Json::parse(stream, nullptr, false);
  if (manifest.is_discarded()) throw std::invalid_argument(file.string() + ": missing or not JSON");
  return manifest;
}

std::string text_at(const Json& manifest, const char* pointer) {
  const Json value = manifest.value(Json::json_pointer(pointer), Json());
  return value.is_string() ? value.get<std::string>() : "";
}

double number_at(const Json& manifest, const char* pointer) {
  const Json value = manifest.value(Json::json_pointer(pointer), Json());
  return value.is_number() ? value.get<double>() : 0;
}

// "a = 1" for every parameter that the suite gives the planner of that label.
std::vector<std::string> settings_of(const Json& manifest, const std::string& label) {
  std::vector<std::string> settings;
  const Json none = Json::array();
  for (const Json& planner : manifest.value(Json::json_pointer("/configuration/planners"), none)) {
    if (planner.value("label", "") != label) continue;
    settings.push_back("planner = " + planner.value("name", ""));
    const Json params = planner.value("params", Json::object());
    for (const auto& [key, value] : params.items())
      settings.push_back(key + " = " +
                         (value.is_string() ? value.get<std::string>() : value.dump()));
  }
  return settings;
}

PlannerBenchmark benchmark_of(const OutputFolder& folder) {
  const Json manifest = manifest_of(folder);
  PlannerBenchmark benchmark;
  benchmark.static_planning = text_at(manifest, "/configuration/kind") == "static";
  benchmark.name = text_at(manifest, "/configuration/suite");
  benchmark.version = text_at(manifest, "/program/version") + "+" +
                      text_at(manifest, "/program/commit").substr(0, 8);
  benchmark.host = text_at(manifest, "/machine/host");
  benchmark.processor = text_at(manifest, "/machine/processor");
  benchmark.date = text_at(manifest, "/started_utc").substr(0, 19);
  if (benchmark.date.size() > 10) benchmark.date[10] = ' ';
  benchmark.setup = text_at(manifest, "/suite_text");
  benchmark.seed = static_cast<std::int64_t>(number_at(manifest, "/configuration/seed"));
  benchmark.time_limit_s = number_at(manifest, "/configuration/limits/wall_s");
  benchmark.memory_limit_mb = number_at(manifest, "/configuration/limits/memory_mb");
  add_stored_runs(folder.store(), benchmark);
  for (BenchmarkedPlanner& planner : benchmark.planners)
    planner.settings = settings_of(manifest, planner.name);
  return benchmark;
}

}  // namespace

ExitCode execute(const ExportOptions& options, const CommandContext& context) {
  const OutputFolder folder = OutputFolder::open(options.folder);
  const std::string ending = options.format == "ompl-log"       ? "log"
                             : options.format == "plannerarena" ? "db"
                                                                : options.format;
  const std::string out =
      options.out.empty() ? folder.file("export." + ending).string() : options.out;
  if (options.format == "csv")
    write_file_atomically(out, [&](std::ostream& file) { write_csv_of(folder.store(), file); });
  else if (options.format == "mcap")
    write_file_atomically(out, mcap_log(folder.store()));
  else if (options.format == "plannerarena")
    write_planner_arena(benchmark_of(folder), out);
  else
    write_file_atomically(out, ompl_log(benchmark_of(folder)));
  context.out << out << "\n";
  return ExitCode::success;
}

}  // namespace voronaut
