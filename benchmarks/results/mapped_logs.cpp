#include "voronaut/benchmarks/results/mapped_logs.h"

#include <algorithm>
#include <filesystem>
#include <string_view>

#include "voronaut/environments/sensing/carmen_log.h"
#include "voronaut/planners/mapping/obstacle_base.h"

namespace voronaut {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostReturnsDrawn = 20'000;

bool drop_ending(std::string& name, std::string_view ending) {
  if (!name.ends_with(ending)) return false;
  name.erase(name.size() - ending.size());
  return true;
}

void append(Places& places, const Vec2& p) {
  places.x_m.push_back(p.x());
  places.y_m.push_back(p.y());
}

MappedLog map_log(const std::string& name, const std::string& path) {
  MappedLog log;
  log.name = name;
  ObstacleBase base({});
  const std::vector<Scan> scans = read_carmen_log(path, kLidarRangeM);
  for (const Scan& scan : scans) {
    const UpdateReport& report = base.update(scan);
    log.returns += report.returns;
    log.invalid += report.invalid;
    append(log.track, scan.sensor_world.p_world);
  }
  log.scans = scans.size();

  const std::size_t stride = 1 + log.returns / kMostReturnsDrawn;
  std::size_t returns = 0;
  for (const Scan& scan : scans) {
    for (std::size_t i = 0; i < scan.size(); ++i) {
      if (!scan.is_return(i) || returns++ % stride != 0) continue;
      append(log.some_returns, scan.point_world(i));
    }
  }
  const ObstacleSnapshot known = base.snapshot();
  for (PointId id = 0; id < known.points().size(); ++id) {
    append(log.points, known.points()[id]);
    log.cluster.push_back(known.cluster_of(id));
  }
  log.clusters = known.cluster_count();
  return log;
}

}  // namespace

std::vector<LidarLog> lidar_logs(const std::string& data) {
  const fs::path folder = fs::path(data) / "lidar";
  std::vector<LidarLog> logs;
  if (data.empty() || !fs::is_directory(folder)) return logs;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    std::string name = entry.path().filename().string();
    drop_ending(name, ".gz");
    if (!drop_ending(name, ".log")) continue;
    drop_ending(name, "-corrected");
    logs.push_back({name, entry.path().string()});
  }
  std::sort(logs.begin(), logs.end(),
            [](const LidarLog& a, const LidarLog& b) { return a.path < b.path; });
  return logs;
}

std::vector<MappedLog> map_logs(const std::string& data) {
  std::vector<MappedLog> logs;
  for (const auto& [name, path] : lidar_logs(data)) logs.push_back(map_log(name, path));
  return logs;
}

}  // namespace voronaut
