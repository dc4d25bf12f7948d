#pragma once

#include <string>
#include <vector>

#include "voronaut/reports/page/mapping_report.h"

namespace voronaut {

// A recorded log: `intel` of .../lidar/intel-corrected.log.gz.
struct LidarLog {
  std::string name;
  std::string path;
};

// Every CARMEN log in <data>/lidar (*.log, *.log.gz) in the order of the paths; none if there is no
// such folder.
std::vector<LidarLog> lidar_logs(const std::string& data);

// Beyond this a return of a recorded log counts as a miss.
inline constexpr double kLidarRangeM = 20;

// Every recorded log mapped from its first scan to its last with the defaults of
// ObstacleBaseConfig. Throws std::runtime_error for a file that is damaged.
std::vector<MappedLog> map_logs(const std::string& data);

}  // namespace voronaut
