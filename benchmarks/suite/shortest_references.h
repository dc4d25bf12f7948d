#pragma once

#include <functional>
#include <map>
#include <string>
#include <utility>

#include "voronaut/benchmarks/trial/trial.h"

namespace voronaut {

// Lengths of the shortest paths on the true world, each computed once for a world and a radius.
class ShortestReferences {
 public:
  // Length from start to goal of a scenario for a disc of that radius; NaN if there is no path.
  using Length = std::function<double(const Scenario& scenario, double radius_m)>;

  explicit ShortestReferences(Length length) : length_(std::move(length)) {}
  // By environments/shortest_path/shortest_path.h.
  static ShortestReferences exact();
  static double exact_length_m(const Scenario& scenario, double radius_m);

  // Fills shortest_length_m (at the body's radius) and shortest_at_clearance_m. A
  // std::runtime_error of `length` passes through, each time.
  void add_to(TrialSpec& spec);

 private:
  double length_m(const TrialSpec& spec, double radius_m);

  Length length_;
  using WorldAndRadius = std::pair<std::string, double>;  // the world's id
  std::map<WorldAndRadius, double> known_;
  std::map<WorldAndRadius, std::string> failed_;  // why
};

}  // namespace voronaut
