#include <benchmark/benchmark.h>

#include "voronaut/benchmarks/micro/workload.h"
#include "voronaut/environments/random.h"
#include "voronaut/planners/mapping/obstacle_base.h"

// What range noise and lost returns do to the map of the forest: how many points and clusters are
// known after 1000 scans of 181 rays, and what a scan costs.
namespace voronaut::micro {
namespace {

constexpr std::size_t kScans = 1000;

void noise(benchmark::State& state) {
  const double sigma_m = 1e-3 * static_cast<double>(state.range(0));
  const double lost_share = 1e-2 * static_cast<double>(state.range(1));
  ForestWalk walk({.scans = kScans});
  Random random(9);
  std::vector<Scan> scans;
  for (std::size_t i = 0; i < kScans; ++i) {
    scans.push_back(walk.next());
    Scan& scan = scans.back();
    for (std::size_t k = 0; k < scan.size(); ++k) {
      if (scan.is_return(k)) scan.range_m[k] += sigma_m * random.normal();
      if (random.uniform() < lost_share) scan.range_m[k] = 0;
    }
  }
  for (auto _ : state) {
    ObstacleBase base{ObstacleBaseConfig{}};
    std::size_t invalid = 0;
    for (const Scan& scan : scans) invalid += base.update(scan).invalid;
    state.counters["points"] = static_cast<double>(base.snapshot().points().size());
    state.counters["clusters"] = static_cast<double>(base.snapshot().cluster_count());
    state.counters["invalid"] = static_cast<double>(invalid);
  }
  state.counters["time_per_scan"] = benchmark::Counter(
      kScans, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(noise)
    ->Name("mapping/noise")
    ->ArgNames({"sigma_mm", "lost_percent"})
    ->ArgsProduct({{0, 10, 30}, {0, 20}})
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace voronaut::micro
