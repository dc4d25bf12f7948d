#include "voronaut/reports/run_record.h"

#include <cstdio>
#include <cstdlib>
#include <stdexcept>

namespace voronaut {

std::string_view to_string(Outcome outcome) {
  switch (outcome) {
    case Outcome::goal_reached:
      return "goal_reached";
    case Outcome::collision:
      return "collision";
    case Outcome::out_of_bounds:
      return "out_of_bounds";
    case Outcome::timeout:
      return "timeout";
    case Outcome::stuck:
      return "stuck";
    case Outcome::infeasible:
      return "infeasible";
    case Outcome::invalid:
      return "invalid";
    case Outcome::killed:
      return "killed";
    case Outcome::crash:
      return "crash";
    case Outcome::memory:
      return "memory";
  }
  std::fprintf(stderr, "voronaut: %d is not an outcome\n", static_cast<int>(outcome));
  std::abort();
}

Outcome outcome_from_string(std::string_view name) {
  for (const Outcome outcome : kOutcomes) {
    if (to_string(outcome) == name) {
      return outcome;
    }
  }
  std::string message = "unknown outcome '" + std::string(name) + "', allowed:";
  for (const Outcome outcome : kOutcomes) {
    message.append(" ").append(to_string(outcome));
  }
  throw std::invalid_argument(message);
}

}  // namespace voronaut
