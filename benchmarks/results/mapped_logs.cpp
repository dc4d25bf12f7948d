#include "voronaut/benchmarks/results/mapped_logs.h"

#include <filesystem>

#include "voronaut/environments/sensing/carmen_log.h"
#include "voronaut/planners/mapping/obstacle_base.h"

namespace voronaut {
namespace {

constexpr std::size_t kMostReturnsDrawn = 20'000;

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

const std::vector<std::string>& lidar_names() {
  static const std::vector<std::string> names{"intel",   "csail", "orebro",
                                              "seattle", "fhw",   "infinite-corridor"};
  return names;
}

std::string lidar_path(const std::string& data, const std::string& name) {
  return data + "/lidar/" + name + "-corrected.log.gz";
}

std::vector<MappedLog> map_logs(const std::string& data) {
  std::vector<MappedLog> logs;
  for (const std::string& name : lidar_names()) {
    const std::string path = lidar_path(data, name);
    if (std::filesystem::is_regular_file(path)) logs.push_back(map_log(name, path));
  }
  return logs;
}

}  // namespace voronaut
