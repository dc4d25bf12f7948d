#include "voronaut/reports/page/mapping_report.h"

#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "voronaut/reports/encoding/json_text.h"
#include "voronaut/reports/page/html_report.h"
#include "voronaut/reports/store/atomic_file.h"

namespace voronaut {
namespace {

nlohmann::json rounded(const std::vector<double>& metres) {
  nlohmann::json list = nlohmann::json::array();
  for (const double value : metres) list.push_back(std::round(value * 100) / 100);
  return list;
}

nlohmann::json json_of(const Places& places) {
  return {{"x", rounded(places.x_m)}, {"y", rounded(places.y_m)}};
}

nlohmann::json json_of(const MappedLog& log) {
  nlohmann::json points = json_of(log.points);
  points["cluster"] = log.cluster;
  return {{"name", log.name},
          {"scans", log.scans},
          {"return_count", log.returns},
          {"invalid", log.invalid},
          {"clusters", log.clusters},
          {"points", std::move(points)},
          {"returns", json_of(log.some_returns)},
          {"track", json_of(log.track)}};
}

nlohmann::json data_of(const std::string& micro_json, const std::vector<MappedLog>& logs) {
  nlohmann::json micro = parse_as("not JSON", [&] { return nlohmann::json::parse(micro_json); });
  if (!micro.is_object() || !micro.contains("benchmarks") || !micro["benchmarks"].is_array()) {
    throw std::invalid_argument(
        "no list 'benchmarks', expected is what voronaut-micro --benchmark_format=json prints");
  }
  nlohmann::json data{{"micro", std::move(micro)}, {"logs", nlohmann::json::array()}};
  for (const MappedLog& log : logs) data["logs"].push_back(json_of(log));
  return data;
}

// What `make` makes of the file's text; an error names the file.
template <class Make>
std::string made_of(const std::filesystem::path& micro_json, Make&& make) {
  std::ifstream file(micro_json);
  std::ostringstream text;
  text << file.rdbuf();
  if (!file) throw std::invalid_argument(micro_json.string() + ": cannot be read");
  try {
    return make(text.str());
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(micro_json.string() + ": " + error.what());
  }
}

}  // namespace

std::string mapping_report(const std::string& title, const std::string& micro_json,
                           const std::vector<MappedLog>& logs) {
  nlohmann::json data = data_of(micro_json, logs);
  data["title"] = title;
  return page_with(title, json_text(data));
}

std::string mapping_data_json(const std::filesystem::path& file,
                              const std::vector<MappedLog>& logs) {
  return made_of(file, [&](const std::string& text) { return json_text(data_of(text, logs)); });
}

void write_mapping_report(const std::filesystem::path& micro_json,
                          const std::vector<MappedLog>& logs, const std::filesystem::path& page) {
  write_file_atomically(page, made_of(micro_json, [&](const std::string& text) {
                          return mapping_report("The mapping step", text, logs);
                        }));
}

}  // namespace voronaut
