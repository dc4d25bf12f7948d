#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

// The page of the microbenchmarks: what mapping a scan costs beside other maps, how that grows, and
// what the map makes of recorded lidar. The same template, script and policy as a run's report.
namespace voronaut {

struct Places {
  std::vector<double> x_m;  // world frame
  std::vector<double> y_m;
};

// A recorded log after its last scan.
struct MappedLog {
  std::string name;
  std::size_t scans = 0;
  std::size_t returns = 0;
  std::size_t invalid = 0;  // ranges that were no measurement: dropped
  std::size_t clusters = 0;
  Places points;                       // what the map keeps
  std::vector<std::uint32_t> cluster;  // of each point
  Places some_returns;                 // an even share of all
  Places track;                        // of the sensor
};

// `micro_json` is what voronaut-micro --benchmark_format=json printed. Throws std::invalid_argument
// that says what is wrong with it. Positions are rounded to centimetres.
std::string mapping_report(const std::string& title, const std::string& micro_json,
                           const std::vector<MappedLog>& logs);

// The same as data of a page: {"micro":..., "logs":[...]}. Throws as mapping_report() does.
std::string mapping_data_json(const std::string& micro_json, const std::vector<MappedLog>& logs);

}  // namespace voronaut
