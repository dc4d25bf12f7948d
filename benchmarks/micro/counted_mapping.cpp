#include "voronaut/benchmarks/micro/counted_work.h"
#include "voronaut/benchmarks/micro/workload.h"
#include "voronaut/planners/mapping/obstacle_base.h"

namespace voronaut::micro {
namespace {

constexpr std::size_t kScans = 1000;

class MappingWork : public CountedWork {
 public:
  MappingWork(std::size_t rays, std::size_t known_scans, bool again)
      : walk_({.rays = rays, .scans = kScans}) {
    ForestWalk elsewhere(
        {.rays = rays, .scans = known_scans, .seed = 2, .aside_m = kOtherGroundAsideM});
    for (std::size_t i = 0; i < known_scans; ++i) base_.update(elsewhere.next());
    if (!again) return;
    ForestWalk before({.rays = rays, .scans = kScans});
    for (std::size_t i = 0; i < kScans; ++i) base_.update(before.next());
  }
  bool prepare() override {
    if (done_++ == kScans) return false;
    scan_ = walk_.next();
    return true;
  }
  std::size_t run() override {
    base_.update(scan_);
    return 1;
  }

 private:
  static constexpr double kOtherGroundAsideM = 100;
  ForestWalk walk_;
  ObstacleBase base_{ObstacleBaseConfig{}};
  Scan scan_;
  std::size_t done_ = 0;
};

class SensingWork : public CountedWork {
 public:
  SensingWork(std::size_t rays, bool walls)
      : rays_(rays), walk_({.rays = rays, .scans = kScans, .walls = walls}) {}
  bool prepare() override { return done_++ < kScans; }
  std::size_t run() override {
    walk_.next();
    return rays_;
  }

 private:
  std::size_t rays_;
  ForestWalk walk_;
  std::size_t done_ = 0;
};

}  // namespace

CountedWorkPtr mapping_work(std::size_t rays, std::size_t known_scans, bool again) {
  return std::make_unique<MappingWork>(rays, known_scans, again);
}

CountedWorkPtr sensing_work(std::size_t rays, bool walls) {
  return std::make_unique<SensingWork>(rays, walls);
}

}  // namespace voronaut::micro
