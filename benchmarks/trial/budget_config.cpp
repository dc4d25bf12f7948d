#include "voronaut/benchmarks/trial/budget_config.h"

#include <limits>
#include <string_view>

namespace voronaut {

namespace {

using Counts = PlanningBudget::Counts;

constexpr std::int64_t kLargest = std::numeric_limits<std::int64_t>::max();
constexpr double kLongest_s = 1e6;

struct LimitKey {
  std::string_view key;
  Counts counts;
};
constexpr LimitKey kLimits[] = {{"state_checks", Counts::state_checks},
                                {"ptc_evaluations", Counts::state_checks},
                                {"iterations", Counts::iterations},
                                {"wall_clock_s", Counts::wall_clock}};

Counts counted(const ConfigNode& node) {
  std::string_view first;
  Counts counts = Counts::state_checks;
  for (const LimitKey& limit : kLimits) {
    const auto found = node.find(limit.key);
    if (!found) continue;
    if (!first.empty() && limit.counts != counts)
      throw found->error("cannot count beside " + std::string(first) +
                         " (allowed: state_checks with ptc_evaluations, or iterations, or "
                         "wall_clock_s)");
    first = limit.key;
    counts = limit.counts;
  }
  return counts;
}

void read_count(const ConfigNode& node, std::string_view key, std::uint64_t& value) {
  if (const auto found = node.find(key))
    value = static_cast<std::uint64_t>(found->whole_number(1, kLargest));
}

}  // namespace

PlanningBudget read_budget(const ConfigNode& node) {
  node.allow_only({"state_checks", "ptc_evaluations", "iterations", "wall_clock_s", "stop"});
  PlanningBudget budget;
  budget.counts = counted(node);
  read_count(node, "state_checks", budget.state_checks);
  read_count(node, "ptc_evaluations", budget.ptc_evaluations);
  read_count(node, "iterations", budget.iterations);
  if (const auto found = node.find("wall_clock_s"))
    budget.wall_clock_s = found->number(1e-6, kLongest_s);
  if (const auto found = node.find("stop"))
    budget.stop = found->choice({"first", "budget"}) == 0 ? PlanningBudget::Stop::first
                                                          : PlanningBudget::Stop::budget;
  return budget;
}

ConfigEntries budget_entries(const PlanningBudget& budget) {
  ConfigEntries entries;
  switch (budget.counts) {
    case Counts::state_checks:
      entries.emplace_back("state_checks", std::to_string(budget.state_checks));
      entries.emplace_back("ptc_evaluations", std::to_string(budget.ptc_evaluations));
      break;
    case Counts::iterations:
      entries.emplace_back("iterations", std::to_string(budget.iterations));
      break;
    case Counts::wall_clock:
      entries.emplace_back("wall_clock_s", number_text(budget.wall_clock_s));
      break;
  }
  entries.emplace_back("stop", budget.stop == PlanningBudget::Stop::first ? "first" : "budget");
  return entries;
}

}  // namespace voronaut
