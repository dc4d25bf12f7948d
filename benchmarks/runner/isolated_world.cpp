#include "voronaut/benchmarks/runner/isolated_world.h"

#include <cstring>
#include <stdexcept>
#include <utility>

#include "voronaut/benchmarks/isolation/child_process.h"

namespace voronaut {

namespace {

// Far above what any world needs: there is an end to it, no more.
constexpr ProcessLimits kLimits{.memory_mb = 64 * 1024, .cpu_s = 3600, .wall_s = 3600};

// Our own code and no planner: a crash is what it may do, to attack is not.
const ChildProcess::Setup kSetup{.namespaces = false};

// Whom somebody killed tells nothing about the world; the second time it may be the world.
ChildReport run_undisturbed(const ChildProcess::Work& work) {
  ChildReport ended = run_in_child(work, kLimits, kSetup);
  if (ended.end == ChildReport::End::killed) ended = run_in_child(work, kLimits, kSetup);
  return ended;
}

std::string bytes_of(double value) {
  std::string bytes(sizeof value, '\0');
  std::memcpy(bytes.data(), &value, sizeof value);
  return bytes;
}

}  // namespace

ShortestReferences isolated_references(ShortestReferences::Length length) {
  return ShortestReferences(isolated_length(std::move(length)));
}

ShortestReferences::Length isolated_length(ShortestReferences::Length length) {
  return [length = std::move(length)](const Scenario& scenario, double radius_m) {
    const ChildReport ended = run_undisturbed([&] { return bytes_of(length(scenario, radius_m)); });
    double length_m = kAbsent;
    if (ended.end != ChildReport::End::finished || ended.output.size() != sizeof length_m)
      throw std::runtime_error("the shortest path of its world: " + end_in_words(ended, kLimits));
    std::memcpy(&length_m, ended.output.data(), sizeof length_m);
    return length_m;
  };
}

SuiteTrials::Rehearse rehearse_in_child() {
  return [](const std::function<void()>& work) -> std::string {
    const ChildReport ended = run_undisturbed([&] {
      work();
      return std::string();
    });
    using End = ChildReport::End;
    const bool harmless = ended.end == End::finished || ended.end == End::exception;
    return harmless ? "" : "making its world: " + end_in_words(ended, kLimits);
  };
}

}  // namespace voronaut
