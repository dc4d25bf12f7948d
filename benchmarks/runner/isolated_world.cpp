#include "voronaut/benchmarks/runner/isolated_world.h"

#include <cstring>
#include <functional>
#include <stdexcept>
#include <type_traits>
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

// What `compute` makes in a child; `what` it is of the world stands in the error.
template <class Value>
Value computed_in_child(const char* what, const std::function<Value()>& compute) {
  static_assert(std::is_trivially_copyable_v<Value>);
  const ChildReport ended = run_undisturbed([&] {
    const Value value = compute();
    std::string bytes(sizeof value, '\0');
    std::memcpy(bytes.data(), &value, sizeof value);
    return bytes;
  });
  Value value;
  if (ended.end != ChildReport::End::finished || ended.output.size() != sizeof value)
    throw std::runtime_error(std::string(what) + " of its world: " + end_in_words(ended, kLimits));
  std::memcpy(&value, ended.output.data(), sizeof value);
  return value;
}

}  // namespace

ShortestReferences isolated_references(ShortestReferences::Length length,
                                       ShortestReferences::Difficulty difficulty) {
  return ShortestReferences(isolated_length(std::move(length)),
                            isolated_difficulty(std::move(difficulty)));
}

ShortestReferences::Length isolated_length(ShortestReferences::Length length) {
  return [length = std::move(length)](const Scenario& scenario, double radius_m) {
    return computed_in_child<double>("the shortest path",
                                     [&] { return length(scenario, radius_m); });
  };
}

ShortestReferences::Difficulty isolated_difficulty(ShortestReferences::Difficulty difficulty) {
  if (!difficulty) return nullptr;
  return [difficulty = std::move(difficulty)](const Scenario& scenario) {
    return computed_in_child<WorldDifficulty>("the free share and the narrowest passage",
                                              [&] { return difficulty(scenario); });
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
