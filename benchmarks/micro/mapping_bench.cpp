#include <algorithm>
#include <cstdlib>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>

#include "voronaut/benchmarks/micro/peers/boost_intersects.h"
#include "voronaut/benchmarks/micro/peers/measured_scan.h"
#include "voronaut/benchmarks/micro/peers/naive_map.h"
#include "voronaut/benchmarks/micro/peers/occupancy_grid.h"
#include "voronaut/benchmarks/micro/workload.h"
#include "voronaut/benchmarks/results/mapped_logs.h"
#include "voronaut/environments/random.h"
#include "voronaut/environments/sensing/carmen_log.h"
#include "voronaut/planners/mapping/points/convex_polygon.h"
#include "voronaut/planners/mapping/obstacle_base.h"
#ifdef VORONAUT_WITH_NANOFLANN
#include "voronaut/benchmarks/micro/peers/nanoflann_map.h"
#endif
#ifdef VORONAUT_WITH_OCTOMAP
#include "voronaut/benchmarks/micro/peers/octomap_map.h"
#endif
#ifdef VORONAUT_WITH_PCL
#include "voronaut/benchmarks/micro/peers/pcl_clustering.h"
#endif

// The mapping step and what a user might take instead, on the same scans. Times are per scan.
namespace voronaut::micro {
namespace {

constexpr std::size_t kScans = 1000;

class OwnMap {
 public:
  explicit OwnMap(const ObstacleBaseConfig& config) : base_(config) {}
  void insert(const MeasuredScan& scan) { base_.update(scan.scan); }
  std::size_t size() const { return base_.snapshot().points().size(); }
  const ObstacleBase& base() const { return base_; }

 private:
  ObstacleBase base_;
};

std::vector<MeasuredScan> forest_scans(std::size_t rays) {
  ForestWalk walk({.rays = rays, .scans = kScans});
  std::vector<MeasuredScan> scans;
  for (std::size_t i = 0; i < kScans; ++i) scans.push_back(measured(walk.next()));
  return scans;
}

double share_of_returns(const std::vector<MeasuredScan>& scans) {
  std::size_t returns = 0;
  std::size_t beams = 0;
  for (const MeasuredScan& scan : scans) {
    returns += scan.returns_world.size();
    beams += scan.scan.size();
  }
  return static_cast<double>(returns) / static_cast<double>(beams);
}

// One iteration maps one scan; at the end of the scans a fresh start is made, untimed.
template <class Map>
void map_scans(benchmark::State& state, const std::vector<MeasuredScan>& scans, const Map& start) {
  auto map = std::make_unique<Map>(start);
  std::size_t next = 0;
  std::size_t size = 0;
  for (auto _ : state) {
    map->insert(scans[next]);
    if (++next < scans.size()) continue;
    state.PauseTiming();
    size = map->size();
    map = std::make_unique<Map>(start);
    next = 0;
    state.ResumeTiming();
  }
  state.counters["share_of_returns"] = share_of_returns(scans);
  if (size > 0) state.counters["size"] = static_cast<double>(size);
}

template <class MakeMap>
void register_on_forest(const std::string& name, const MakeMap& make_map) {
  const auto run = [make_map](benchmark::State& state) {
    map_scans(state, forest_scans(static_cast<std::size_t>(state.range(0))), make_map());
  };
  benchmark::RegisterBenchmark(("mapping/forest/" + name).c_str(), run)
      ->ArgName("rays")
      ->Arg(181)
      ->Arg(360)
      ->Arg(720)
      ->Unit(benchmark::kMicrosecond);
}

// The cost of one scan of new ground, the same 500 scans each time, when k scans of other ground
// are known.
template <class MakeMap>
void register_growth(const std::string& name, const std::vector<std::int64_t>& known_scans,
                     const MakeMap& make_map) {
  constexpr std::size_t kTimed = 500;
  const auto run = [make_map](benchmark::State& state) {
    const auto known = static_cast<std::size_t>(state.range(0));
    ForestWalk elsewhere({.scans = known, .seed = 2, .aside_m = 100});
    auto grown = make_map();
    for (std::size_t i = 0; i < known; ++i) grown.insert(measured(elsewhere.next()));
    ForestWalk walk({.scans = kTimed});
    std::vector<MeasuredScan> next;
    for (std::size_t i = 0; i < kTimed; ++i) next.push_back(measured(walk.next()));
    map_scans(state, next, grown);
    state.SetComplexityN(state.range(0));
    state.counters["size"] = static_cast<double>(grown.size());
  };
  auto* growth = benchmark::RegisterBenchmark(("mapping/growth/" + name).c_str(), run);
  growth->ArgName("known_scans")->Unit(benchmark::kMicrosecond)->Complexity();
  for (const std::int64_t k : known_scans) growth->Arg(k);
}

// How many polygon pairs come to the exact test, on the forest and where that is dense and the
// vehicle wide.
void register_merging(const std::string& name, double density_per_m2, double merge_distance_m) {
  const auto run = [=](benchmark::State& state) {
    ForestWalk walk({.density_per_m2 = density_per_m2, .scans = kScans});
    std::vector<MeasuredScan> scans;
    for (std::size_t i = 0; i < kScans; ++i) scans.push_back(measured(walk.next()));
    const ObstacleBaseConfig config{.merge_distance_m = merge_distance_m};
    map_scans(state, scans, OwnMap(config));
    ObstacleBase base(config);
    std::size_t pairs = 0;
    std::size_t merges = 0;
    for (const MeasuredScan& scan : scans) {
      pairs += base.update(scan.scan).pairs_tested;
      merges += base.report().merges;
    }
    state.counters["pairs_per_scan"] = static_cast<double>(pairs) / kScans;
    state.counters["merges_per_scan"] = static_cast<double>(merges) / kScans;
    state.counters["clusters"] = static_cast<double>(base.snapshot().cluster_count());
  };
  benchmark::RegisterBenchmark(("mapping/merging/" + name).c_str(), run)
      ->Unit(benchmark::kMicrosecond);
}

Bounds forest_bounds() { return {{-6, -13}, {211, 13}}; }

void register_maps() {
  const ObstacleBaseConfig config;
  register_on_forest("voronaut", [=] { return OwnMap(config); });
  register_on_forest("naive_full_search",
                     [=] { return NaiveMap(config.thinning_distance_m, config.link_distance_m); });
  register_on_forest("grid_0.1m_hits", [] { return OccupancyGrid(forest_bounds(), 0.1, false); });
  register_on_forest("grid_0.1m_full", [] { return OccupancyGrid(forest_bounds(), 0.1, true); });
#ifdef VORONAUT_WITH_NANOFLANN
  register_on_forest("nanoflann_single_scan",
                     [=] { return NanoflannClustering(config.link_distance_m); });
#endif
#ifdef VORONAUT_WITH_PCL
  register_on_forest("pcl_single_scan", [=] { return PclClustering(config.link_distance_m); });
#endif
#ifdef VORONAUT_WITH_OCTOMAP
  register_on_forest("octomap_0.1m_hits", [] { return OctomapMap(false); });
  register_on_forest("octomap_0.1m_full", [] { return OctomapMap(true); });
#endif
  register_touching("voronaut",
                    [](const auto& a, const auto& b) { return convex_polygons_touch(a, b); });
  register_touching("boost_geometry", boost_intersects);
  register_merging("forest", 0.1, config.merge_distance_m);
  register_merging("dense_forest_wide_vehicle", 0.2, 2);
  register_growth("voronaut", {1'000, 3'000, 10'000, 100'000}, [=] { return OwnMap(config); });
  register_growth("naive_full_search", {1'000, 3'000, 10'000},
                  [=] { return NaiveMap(config.thinning_distance_m, config.link_distance_m); });
}

// Pairs of hulls whose boxes touch, as they come to the exact test.
std::vector<std::pair<std::vector<Vec2>, std::vector<Vec2>>> hull_pairs(std::size_t corners) {
  Random random(6);
  const auto hull = [&] {
    std::vector<Vec2> points;
    const Vec2 middle(random.uniform(0, 2), random.uniform(0, 2));
    for (std::size_t i = 0; i < corners; ++i)
      points.push_back(middle + Vec2(random.normal(), random.normal()));
    reduce_to_convex_hull(points);
    return points;
  };
  std::vector<std::pair<std::vector<Vec2>, std::vector<Vec2>>> pairs;
  while (pairs.size() < 1000) {
    auto pair = std::pair(hull(), hull());
    if (boxes_touch(bounding_box(pair.first), bounding_box(pair.second)))
      pairs.push_back(std::move(pair));
  }
  return pairs;
}

template <class Touch>
void register_touching(const std::string& name, const Touch& touch) {
  const auto run = [touch](benchmark::State& state) {
    const auto pairs = hull_pairs(static_cast<std::size_t>(state.range(0)));
    std::size_t i = 0;
    std::size_t touching = 0;
    for (auto _ : state) {
      const auto& [a, b] = pairs[i++ % pairs.size()];
      touching += touch(a, b) ? 1 : 0;
    }
    state.counters["share_touching"] = static_cast<double>(touching) / static_cast<double>(i);
  };
  benchmark::RegisterBenchmark(("mapping/touching/" + name).c_str(), run)
      ->ArgName("points")
      ->Arg(4)
      ->Arg(32)
      ->Unit(benchmark::kNanosecond);
}

void register_lidar(const std::string& data) {
  for (const auto& [name, path] : lidar_logs(data)) {
    const auto run = [path = path](benchmark::State& state) {
      std::vector<MeasuredScan> scans;
      try {
        for (const Scan& scan : read_carmen_log(path, kLidarRangeM))
          scans.push_back(measured(scan));
      } catch (const std::exception& error) {
        state.SkipWithError(error.what());
        return;
      }
      const ObstacleBaseConfig config;
      map_scans(state, scans, OwnMap(config));
      OwnMap map(config);
      for (const MeasuredScan& scan : scans) map.insert(scan);
      state.counters["clusters"] = static_cast<double>(map.base().snapshot().cluster_count());
      state.counters["scans"] = static_cast<double>(scans.size());
    };
    benchmark::RegisterBenchmark(("mapping/lidar/" + name).c_str(), run)
        ->Unit(benchmark::kMicrosecond);
  }
}

// Places beside the curve, where the map knows something, and 2 m segments from there.
void checks(benchmark::State& state, bool motion) {
  const auto scans = static_cast<std::size_t>(state.range(0));
  ForestWalk walk({.scans = scans});
  ObstacleBase base({});
  for (std::size_t i = 0; i < scans; ++i) base.update(walk.next());
  Random random(5);
  std::vector<Segment> motions;
  const double length_m = 0.18 * static_cast<double>(scans);
  while (motions.size() < 4096) {
    const Vec2 a{random.uniform(0, length_m), random.uniform(-6, 6)};
    Vec2 way{random.normal(), random.normal()};
    motions.push_back({a, a + 2 * way / way.norm()});
  }
  const ObstacleSnapshot known = base.snapshot();
  std::size_t i = 0;
  std::size_t clear = 0;
  for (auto _ : state) {
    const Segment& next = motions[i++ % motions.size()];
    clear +=
        motion ? known.swept_disc_is_clear(next.a, next.b, 0.3) : known.disc_is_clear(next.a, 0.3);
  }
  state.SetComplexityN(state.range(0));
  state.counters["share_clear"] = static_cast<double>(clear) / static_cast<double>(i);
}
BENCHMARK_CAPTURE(checks, state, false)
    ->Name("checks/state")
    ->ArgName("known_scans")
    ->Arg(1'000)
    ->Arg(10'000)
    ->Complexity();
BENCHMARK_CAPTURE(checks, motion, true)
    ->Name("checks/motion_2m")
    ->ArgName("known_scans")
    ->Arg(1'000)
    ->Arg(10'000)
    ->Complexity();

void sense(benchmark::State& state) {
  ForestWalk walk({.rays = static_cast<std::size_t>(state.range(0)), .scans = 100'000});
  for (auto _ : state) benchmark::DoNotOptimize(walk.next().range_m.data());
}
BENCHMARK(sense)->Name("sensing/forest_scan")->ArgName("rays")->Arg(181)->Arg(720);

}  // namespace
}  // namespace voronaut::micro

int main(int argc, char** argv) {
  voronaut::micro::register_maps();
  if (const char* data = std::getenv("VORONAUT_DATA")) voronaut::micro::register_lidar(data);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
