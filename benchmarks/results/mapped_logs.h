#pragma once

#include <string>
#include <vector>

#include "voronaut/reports/page/mapping_report.h"

namespace voronaut {

// The recorded lidar that is measured and drawn; a log of this name is
// <data>/lidar/<name>-corrected.log.gz.
const std::vector<std::string>& lidar_names();
std::string lidar_path(const std::string& data, const std::string& name);

// Beyond this a return of a recorded log counts as a miss.
inline constexpr double kLidarRangeM = 20;

// Every recorded log in the folder, mapped from its first scan to its last with the defaults of
// ObstacleBaseConfig; those that are not there are left out. Throws std::runtime_error for a file
// that is damaged.
std::vector<MappedLog> map_logs(const std::string& data);

}  // namespace voronaut
