#include "voronaut/benchmarks/results/published_file.h"

#include <algorithm>
#include <cstdio>
#include <stdexcept>

#include "voronaut/environments/formats/csv_table.h"

namespace voronaut {

namespace {

constexpr double kMostRuns = 1e6;
constexpr double kLongestRun_s = 1e6;
constexpr double kBestScore = 0.5;

std::int64_t count_at(const CsvTable& table, std::size_t row, const char* column, double most) {
  return static_cast<std::int64_t>(table.number(row, column, 0, most));
}

// As environments/formats/data_sets.h calls the worlds of BARN.
std::string scenario_of(const CsvTable& table, std::size_t row) {
  char name[32];
  std::snprintf(name, sizeof name, "barn_%03ld",
                static_cast<long>(count_at(table, row, "world", 999)));
  return name;
}

}  // namespace

std::vector<PublishedMethod> read_published(const std::string& file) {
  const auto table = CsvTable::read(
      file, {"method", "world", "runs", "successes", "collisions", "mean_time_success_s", "score"});
  std::vector<PublishedMethod> methods;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const std::string& name = table.text(row, "method");
    auto method = std::ranges::find(methods, name, &PublishedMethod::name);
    if (method == methods.end()) method = methods.insert(method, {name, {}});
    PublishedWorld world;
    world.scenario = scenario_of(table, row);
    world.runs = count_at(table, row, "runs", kMostRuns);
    const auto runs = static_cast<double>(world.runs);
    world.successes = count_at(table, row, "successes", runs);
    world.collisions = count_at(table, row, "collisions", runs);
    world.score = table.number(row, "score", 0, kBestScore);
    if (world.successes > 0)
      world.time_s = table.number(row, "mean_time_success_s", 0, kLongestRun_s);
    method->worlds.push_back(std::move(world));
  }
  return methods;
}

BarnComparison beside_published_file(const OutputFolder& folder, const std::string& file) {
  BarnComparison comparison = beside_published(folder.store().records(), read_published(file));
  if (comparison.differences.empty())
    throw std::invalid_argument(folder.path().string() + ": no course of BARN that " + file +
                                " has, too");
  return comparison;
}

}  // namespace voronaut
