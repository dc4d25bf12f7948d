#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>

#include "voronaut/benchmarks/micro/workload.h"
#include "voronaut/planners/mapping/index/point_index.h"
#include "voronaut/planners/mapping/obstacle_base.h"
#include "voronaut/planners/mapping/stages/cluster_base.h"
#include "voronaut/planners/mapping/stages/scan_clusterer.h"
#include "voronaut/planners/mapping/stages/scan_joining.h"
#include "voronaut/planners/mapping/stages/scan_returns.h"

// Each stage of the mapping step alone, on what the stages before it make of the forest's scans.
// Times are per scan.
namespace voronaut::micro {
namespace {

constexpr std::size_t kScans = 1000;

std::vector<Scan> forest_scans(benchmark::State& state) {
  ForestWalk walk({.rays = static_cast<std::size_t>(state.range(0)), .scans = kScans});
  std::vector<Scan> scans;
  for (std::size_t i = 0; i < kScans; ++i) scans.push_back(walk.next());
  return scans;
}

void ignore(PackedPoint, std::size_t) {}

// Scans that were read, and clustered.
struct ReadScan {
  ReadScan(const ScanReturns& unread, const ScanClusterer& unused, const Scan& scan)
      : returns(unread), clusterer(unused) {
    returns.read(scan, ignore);
    clusterer.cluster(returns);
  }
  ScanReturns returns;
  ScanClusterer clusterer;
};

// In one place each: the clusters refer to the returns.
std::vector<std::unique_ptr<ReadScan>> read_scans(const std::vector<Scan>& scans) {
  const ObstacleBaseConfig config;
  const ScanClusterer clusterer(config.link_distance_m, config.thinning_distance_m);
  const ScanReturns returns(clusterer.listing_distance_m(), config.link_distance_m);
  std::vector<std::unique_ptr<ReadScan>> read;
  read.reserve(scans.size());
  for (const Scan& scan : scans)
    read.push_back(std::make_unique<ReadScan>(returns, clusterer, scan));
  return read;
}

PointIndex index_of(const ObstacleSnapshot& known) {
  PointIndex index(ObstacleBaseConfig{}.thinning_distance_m);
  for (const Vec2& p : known.points()) index.add(p);
  return index;
}

ClusterBase clusters_of(const ObstacleSnapshot& known) {
  ClusterBase clusters(ObstacleBaseConfig{}.merge_distance_m);
  clusters.make_room(known.points().size());
  for (const ClusterId id : known.clusters()) {
    const ClusterId copy = clusters.create();
    for (const PointId p : known.members(id)) clusters.append(copy, p, known.points()[p]);
  }
  return clusters;
}

void read_returns(benchmark::State& state) {
  const std::vector<Scan> scans = forest_scans(state);
  const ObstacleBaseConfig config;
  ScanReturns returns(config.thinning_distance_m, config.link_distance_m);
  std::size_t i = 0;
  for (auto _ : state) returns.read(scans[i++ % kScans], ignore);
}
BENCHMARK(read_returns)->Name("mapping/stage/read_returns")->ArgName("rays")->Arg(181)->Arg(720);

void cluster_scan(benchmark::State& state) {
  const std::vector<Scan> scans = forest_scans(state);
  const auto read = read_scans(scans);
  std::size_t i = 0;
  for (auto _ : state) {
    ReadScan& next = *read[i++ % kScans];
    next.clusterer.cluster(next.returns);
  }
}
BENCHMARK(cluster_scan)->Name("mapping/stage/cluster_scan")->ArgName("rays")->Arg(181)->Arg(720);

// Every listed return is looked up; the base asks only where the point that followed before is not
// close.
void look_up(benchmark::State& state) {
  const std::vector<Scan> scans = forest_scans(state);
  const auto read = read_scans(scans);
  ObstacleBase base({});
  for (const Scan& scan : scans) base.update(scan);
  const PointIndex index = index_of(base.snapshot());
  const double thinning_m = base.config().thinning_distance_m;
  std::size_t i = 0;
  for (auto _ : state) {
    for (const Vec2& p : read[i++ % kScans]->returns.listed_world())
      benchmark::DoNotOptimize(index.nearest_closer_than(p, thinning_m));
  }
}
BENCHMARK(look_up)->Name("mapping/stage/look_up_listed")->ArgName("rays")->Arg(181)->Arg(720);

// Of listed returns, as far as labels change.
std::vector<Representative> representatives_of(const ScanReturns& returns, const PointIndex& index,
                                               const ClusterBase& clusters) {
  std::vector<Representative> representatives;
  std::optional<ClusterId> label;
  for (std::size_t k = 0; k < returns.listed().size(); ++k) {
    const PointId point = index.nearest_closer_than(returns.listed_world()[k],
                                                    ObstacleBaseConfig{}.thinning_distance_m);
    if (label == clusters.label(point)) continue;
    label = clusters.label(point);
    representatives.push_back({returns.listed()[k], point, false});
  }
  return representatives;
}

void join_known(benchmark::State& state) {
  const std::vector<Scan> scans = forest_scans(state);
  const auto read = read_scans(scans);
  ObstacleBase base({});
  for (const Scan& scan : scans) base.update(scan);
  const PointIndex index = index_of(base.snapshot());
  const ClusterBase clusters = clusters_of(base.snapshot());
  std::vector<std::vector<Representative>> representatives;
  representatives.reserve(read.size());
  for (const auto& scan : read)
    representatives.push_back(representatives_of(scan->returns, index, clusters));
  ScanJoining joining;
  std::size_t i = 0;
  for (auto _ : state) {
    const ReadScan& next = *read[i % kScans];
    joining.join(next.returns, next.clusterer, representatives[i % kScans],
                 static_cast<PointId>(index.size()), clusters);
    ++i;
  }
}
BENCHMARK(join_known)->Name("mapping/stage/join_known")->ArgName("rays")->Arg(181)->Arg(720);

// The points that were new in each scan, with the cluster they went to.
using Appended = std::vector<std::pair<ClusterId, PointId>>;
std::vector<Appended> appended_by(ObstacleBase& base, const std::vector<Scan>& scans) {
  std::vector<Appended> appended;
  for (const Scan& scan : scans) {
    const std::size_t before = base.snapshot().points().size();
    base.update(scan);
    const ObstacleSnapshot now = base.snapshot();
    Appended& added = appended.emplace_back();
    for (std::size_t p = before; p < now.points().size(); ++p) {
      const auto id = static_cast<PointId>(p);
      added.emplace_back(now.cluster_of(id), id);
    }
  }
  return appended;
}

// New points are appended and clusters merged, from nothing on, again and again.
void append_and_merge(benchmark::State& state) {
  ObstacleBase base({});
  const std::vector<Appended> appended = appended_by(base, forest_scans(state));
  const std::span<const Vec2> points = base.snapshot().points();
  std::unique_ptr<ClusterBase> clusters;
  std::map<ClusterId, ClusterId> copy_of;
  std::size_t i = 0;
  for (auto _ : state) {
    if (i % kScans == 0) {
      state.PauseTiming();
      clusters = std::make_unique<ClusterBase>(base.config().merge_distance_m);
      clusters->make_room(points.size());
      copy_of.clear();
      state.ResumeTiming();
    }
    for (const auto& [id, point] : appended[i++ % kScans]) {
      const auto [copy, is_new] = copy_of.try_emplace(id);
      if (is_new) copy->second = clusters->create();
      clusters->append(clusters->living_id(copy->second), point, points[point]);
    }
    benchmark::DoNotOptimize(clusters->merge_related(points));
  }
  state.counters["new_points"] = static_cast<double>(points.size()) / static_cast<double>(kScans);
}
BENCHMARK(append_and_merge)
    ->Name("mapping/stage/append_and_merge")
    ->ArgName("rays")
    ->Arg(181)
    ->Arg(720);

void known_ground(benchmark::State& state) {
  const std::vector<Scan> scans = forest_scans(state);
  ObstacleBase base({});
  for (const Scan& scan : scans) base.update(scan);
  std::size_t i = 0;
  for (auto _ : state) base.update(scans[i++ % kScans]);
}
BENCHMARK(known_ground)->Name("mapping/stage/known_ground")->ArgName("rays")->Arg(181)->Arg(720);

}  // namespace
}  // namespace voronaut::micro
