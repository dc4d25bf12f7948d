#pragma once

#include <array>
#include <cstddef>
#include <string_view>

// How a trial ends, and the one table of what is said and drawn about each way.
namespace voronaut {

enum class Outcome {
  goal_reached,
  collision,
  out_of_bounds,
  timeout,
  stuck,
  infeasible,
  invalid,
  killed,
  crash,
  memory,
};

struct OutcomeEntry {
  Outcome outcome;
  std::string_view name;   // in records and files
  std::string_view words;  // for people
  std::string_view sign;   // drawn where a trial ended: a letter where no common sign says it
  std::string_view colour;
  std::string_view colour_on_dark;
  bool failure;
  bool cut_off;  // says that something is wrong with planner or suite, not how well it flew
  std::string_view meaning;
};

// In the order of the enumeration.
inline constexpr std::array kOutcomes{
    OutcomeEntry{Outcome::goal_reached, "goal_reached", "goal reached", "\u2713", "#1a7f4b",
                 "#57d08f", false, false, "at rest at the goal without a contact"},
    OutcomeEntry{Outcome::collision, "collision", "collision", "\u2715", "#b3261e", "#ff8278", true,
                 false, "the body met an obstacle of the true world"},
    OutcomeEntry{Outcome::out_of_bounds, "out_of_bounds", "out of bounds", "\u2197", "#a8488a",
                 "#e58ac4", true, false, "the centre left the bounds of the scenario"},
    OutcomeEntry{Outcome::timeout, "timeout", "timeout", "T", "#8a6000", "#e6b44c", true, false,
                 "the scenario's time, or the search of a static plan, ran out before the goal"},
    OutcomeEntry{Outcome::stuck, "stuck", "stuck", "S", "#c04f00", "#ff9248", true, false,
                 "stood still until it was pointless to wait"},
    OutcomeEntry{Outcome::infeasible, "infeasible", "infeasible", "\u2205", "#0072b2", "#56a8e8",
                 true, false, "the planner proved that there is no path through what is known"},
    OutcomeEntry{Outcome::invalid, "invalid", "invalid", "?", "#57606a", "#a3adb8", true, true,
                 "could not start: start or goal not free, or the planner refused"},
    OutcomeEntry{Outcome::killed, "killed", "killed", "K", "#5b3fa8", "#b49cff", true, true,
                 "stopped by the limit on wall-clock or CPU time, or twice by somebody else"},
    OutcomeEntry{Outcome::crash, "crash", "crash", "!", "#44484d", "#c3c9d0", true, true,
                 "the planner ended the process: signal, abort or exception"},
    OutcomeEntry{Outcome::memory, "memory", "memory", "M", "#216f96", "#8fd3f4", true, true,
                 "the planner asked for more memory than allowed"}};

constexpr const OutcomeEntry& entry_of(Outcome outcome) {
  return kOutcomes[static_cast<std::size_t>(outcome)];
}

std::string_view to_string(Outcome outcome);
// Throws std::invalid_argument for an unknown name.
Outcome outcome_from_string(std::string_view name);

}  // namespace voronaut
