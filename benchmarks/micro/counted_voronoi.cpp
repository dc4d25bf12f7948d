#include <cmath>
#include <vector>

#include "voronaut/benchmarks/micro/counted_work.h"
#include "voronaut/environments/random.h"
#include "voronaut/planners/voronoi/voronoi_router.h"

namespace voronaut::micro {
namespace {

constexpr double kSitesPerM2 = 0.1;
constexpr double kClearanceM = 0.4;

struct RandomSites {
  explicit RandomSites(std::size_t count) {
    const double half_m = 0.5 * std::sqrt(static_cast<double>(count) / kSitesPerM2);
    bounds = {Vec2::Constant(-half_m), Vec2::Constant(half_m)};
    Random random(8);
    while (points.size() < count)
      points.emplace_back(random.uniform(-half_m, half_m), random.uniform(-half_m, half_m));
  }

  void observe_first(VoronoiRouter& router, std::size_t count) const {
    router.observe(std::span(points).first(count), bounds, kClearanceM, {});
  }

  Bounds bounds;
  std::vector<Vec2> points;
};

class VoronoiBuildWork : public CountedWork {
 public:
  explicit VoronoiBuildWork(std::size_t sites) : sites_(sites) {}
  bool prepare() override {
    router_ = {};
    return runs_++ < kRuns;
  }
  std::size_t run() override {
    sites_.observe_first(router_, sites_.points.size());
    router_.graph();
    return sites_.points.size();
  }

 private:
  static constexpr int kRuns = 3;
  RandomSites sites_;
  VoronoiRouter router_;
  int runs_ = 0;
};

// The last tenth of the sites, one by one.
class VoronoiInsertWork : public CountedWork {
 public:
  explicit VoronoiInsertWork(std::size_t sites) : sites_(sites), known_(sites - sites / 10) {
    sites_.observe_first(router_, known_);
  }
  bool prepare() override { return known_++ < sites_.points.size(); }
  std::size_t run() override {
    sites_.observe_first(router_, known_);
    return 1;
  }

 private:
  RandomSites sites_;
  VoronoiRouter router_;
  std::size_t known_;
};

}  // namespace

CountedWorkPtr voronoi_build_work(std::size_t sites) {
  return std::make_unique<VoronoiBuildWork>(sites);
}
CountedWorkPtr voronoi_insert_work(std::size_t sites) {
  return std::make_unique<VoronoiInsertWork>(sites);
}

}  // namespace voronaut::micro
