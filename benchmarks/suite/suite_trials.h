#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "voronaut/benchmarks/suite/shard.h"
#include "voronaut/benchmarks/suite/suite_config.h"
#include "voronaut/benchmarks/trial/trial.h"

namespace voronaut {

// A trial as the runner gets it. A random scenario that drew no admissible world leaves no world to
// fly in: the trial keeps its place with the reason in `refusal`.
struct PlannedTrial {
  TrialSpec spec;
  std::string refusal;
};

// The trials of a suite one after another, in the order scenario, repetition, vehicle, planner.
// Worlds are made when it is their turn and shared by the trials in them. The seed of a world comes
// from (suite seed, scenario, repetition), so every planner and vehicle meets the same world; the
// planner's from (suite seed, scenario, planner label, repetition). Wheeled vehicles drive at
// height 0. Entries that a zipped sweep made meet in step only.
class SuiteTrials {
 public:
  // Does the work of making a world where it can do no harm and says what became of it: empty if
  // it can be done here.
  using Rehearse = std::function<std::string(const std::function<void()>& work)>;

  // A random world that `rehearse` warns of is not made; its trials have that as their refusal.
  // Of a shard only its trials come, beginning with the worlds of its own stretch of the suite: so
  // shards that fly at once measure different worlds first.
  explicit SuiteTrials(const SuiteConfig& suite, Rehearse rehearse = nullptr, Shard shard = {});

  std::size_t total() const;  // of the whole suite
  std::optional<PlannedTrial> next();

  // Makes the first world of every scenario. Throws ConfigError for one that cannot be made.
  static void check_worlds(const SuiteConfig& suite);

 private:
  // A scenario's turn: which one, for the how manieth time.
  struct Visit {
    std::size_t scenario, repetition;
  };

  std::optional<PlannedTrial> next_of_suite();
  const Visit& visit() const;    // that the next trial belongs to
  std::size_t in_world() const;  // all pairs of a vehicle and a planner
  bool meet(std::size_t scenario, std::size_t vehicle, std::size_t planner) const;
  void enter_world();
  void make_world(const ScenarioSpec& source, std::uint64_t seed);
  PlannedTrial trial(const VehicleEntry& vehicle, const PlannerSpec& planner) const;

  const SuiteConfig& suite_;
  Rehearse rehearse_;
  Shard shard_;
  std::vector<Visit> visits_;
  // Of the zipped axes of a sweep, for each entry of the lists.
  using Steps = std::vector<std::optional<std::size_t>>;
  Steps scenario_steps_, vehicle_steps_, planner_steps_;
  std::size_t next_ = 0;
  std::optional<std::size_t> made_;  // the scenario whose world is at hand
  Scenario scenario_;
  std::string world_id_;
  std::string refusal_;
};

}  // namespace voronaut
