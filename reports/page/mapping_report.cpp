#include "voronaut/reports/page/mapping_report.h"

#include <cmath>
#include <stdexcept>

#include "voronaut/reports/encoding/json_text.h"
#include "voronaut/reports/page/html_report.h"

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

}  // namespace

std::string mapping_report(const std::string& title, const std::string& micro_json,
                           const std::vector<MappedLog>& logs) {
  nlohmann::json data = data_of(micro_json, logs);
  data["title"] = title;
  return page_with(title, json_text(data));
}

std::string mapping_data_json(const std::string& micro_json, const std::vector<MappedLog>& logs) {
  return json_text(data_of(micro_json, logs));
}

}  // namespace voronaut
