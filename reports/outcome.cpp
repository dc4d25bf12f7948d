#include "voronaut/reports/outcome.h"

#include <stdexcept>
#include <string>

namespace voronaut {

namespace {

constexpr bool is_in_order() {
  for (std::size_t i = 0; i < kOutcomes.size(); ++i)
    if (kOutcomes[i].outcome != static_cast<Outcome>(i)) return false;
  return true;
}
static_assert(is_in_order());

}  // namespace

std::string_view to_string(Outcome outcome) { return entry_of(outcome).name; }

Outcome outcome_from_string(std::string_view name) {
  std::string allowed;
  for (const OutcomeEntry& entry : kOutcomes) {
    if (entry.name == name) return entry.outcome;
    allowed.append(" ").append(entry.name);
  }
  throw std::invalid_argument("unknown outcome '" + std::string(name) + "', allowed:" + allowed);
}

}  // namespace voronaut
