#pragma once

#include <functional>
#include <map>
#include <string>
#include <utility>

#include "voronaut/benchmarks/trial/trial.h"

namespace voronaut {

// How hard a world is, whatever flies there; NaN where nothing says so.
struct WorldDifficulty {
  double free_share = kAbsent;           // of the bounds that no solid covers
  double narrowest_passage_m = kAbsent;  // see narrowest_passage.h; NaN where it is infinite
};

// What is known before a flight: lengths of shortest paths, each computed once for a world and a
// radius, how hard worlds are, once for a world, and how vehicles answer steps, once for each that
// flies.
class ShortestReferences {
 public:
  // Length from start to goal of a scenario for a disc of that radius; NaN if there is no path.
  using Length = std::function<double(const Scenario& scenario, double radius_m)>;

  using Difficulty = std::function<WorldDifficulty(const Scenario& scenario)>;

  // Without `difficulty` nothing is said about it.
  explicit ShortestReferences(Length length, Difficulty difficulty = nullptr)
      : length_(std::move(length)), difficulty_(std::move(difficulty)) {}
  // By environments/shortest_path and polygons.
  static ShortestReferences exact();
  static double exact_length_m(const Scenario& scenario, double radius_m);

  static WorldDifficulty exact_difficulty(const Scenario& scenario);

  // Fills answer, shortest_length_m (at the radius of the largest disc within the body),
  // shortest_at_clearance_m, free_share and narrowest_passage_m. A std::runtime_error of `length`
  // or `difficulty` passes through, each time.
  void add_to(TrialSpec& spec);

 private:
  double length_m(const TrialSpec& spec, double radius_m);
  WorldDifficulty difficulty_of(const TrialSpec& spec);
  StepAnswer answer_of(const TrialSpec& spec);

  Length length_;
  using WorldAndRadius = std::pair<std::string, double>;  // the world's id
  std::map<WorldAndRadius, double> known_;
  std::map<WorldAndRadius, std::string> failed_;  // why
  std::map<std::string, StepAnswer> answers_;     // by the label of the vehicle
  Difficulty difficulty_;
  std::map<std::string, WorldDifficulty> difficulties_;  // by the world's id
  std::map<std::string, std::string> not_rated_;         // why
};

}  // namespace voronaut
