#include "voronaut/tests/benchmarks/small_suite.h"

#include <cstdlib>
#include <stdexcept>

#include "voronaut/benchmarks/trial/sha256.h"

namespace voronaut {

std::string small_suite_text(const std::string& name, const std::vector<std::string>& labels,
                             int repetitions) {
  std::string text =
      "suite: " + name + "\nseed: 7\nrepetitions: " + std::to_string(repetitions) +
      "\nscenarios:\n"
      "  - {name: open, world: {circles: [[2, 2, 0.5]]}, bounds: [[-1, -1], [6, 6]],"
      " start: [0, 0], goal: [5, 5]}\n"
      "  - {name: wood, generator: {name: forest, side_m: 6, density_per_m2: 0.05}}\n"
      "vehicles: [quadrotor]\nplanners:\n";
  for (const std::string& label : labels) text += "  - {name: RRTConnect, label: " + label + "}\n";
  return text + "limits: {memory_mb: 256, cpu_s: 600, wall_s: 600}\n";
}

SuiteConfig small_suite(const std::string& name, const std::vector<std::string>& labels,
                        int repetitions) {
  return read_suite(ConfigNode::parse(small_suite_text(name, labels, repetitions), "small.yaml"),
                    "", PlannerCatalog::built_in());
}

TrialResult made_up_flight(const TrialSpec& spec) {
  TrialResult result{record_of_failure(spec, Outcome::goal_reached, "made up"), std::nullopt};
  result.record.duration_s = std::stoi(spec.trial_id.substr(0, 4), nullptr, 16) / 7.0;
  result.record.replans = std::stoi(spec.trial_id.substr(4, 4), nullptr, 16);
  result.record.state_digest = sha256_hex(spec.trial_id);
  return result;
}

ShortestReferences made_up_references() {
  return ShortestReferences([](const Scenario& scenario, double radius_m) {
    return (scenario.goal_world - scenario.start_world).norm() + radius_m;
  });
}

}  // namespace voronaut
