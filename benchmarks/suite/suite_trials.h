#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

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
// height 0.
class SuiteTrials {
 public:
  // Does the work of making a world where it can do no harm and says what became of it: empty if
  // it can be done here.
  using Rehearse = std::function<std::string(const std::function<void()>& work)>;

  // A random world that `rehearse` warns of is not made; its trials have that as their refusal.
  explicit SuiteTrials(const SuiteConfig& suite, Rehearse rehearse = nullptr);

  std::size_t total() const;
  std::optional<PlannedTrial> next();

  // Makes the first world of every scenario. Throws ConfigError for one that cannot be made.
  static void check_worlds(const SuiteConfig& suite);

 private:
  void enter_world();
  void make_world(const ScenarioSpec& source, std::uint64_t seed);
  PlannedTrial trial(const VehicleEntry& vehicle, const PlannerSpec& planner) const;

  // A scenario's turn: which one, for the how manieth time.
  struct Visit {
    std::size_t scenario, repetition;
  };

  const SuiteConfig& suite_;
  Rehearse rehearse_;
  std::vector<Visit> visits_;
  std::size_t next_ = 0;
  Scenario scenario_;
  std::string world_id_;
  std::string refusal_;
};

}  // namespace voronaut
