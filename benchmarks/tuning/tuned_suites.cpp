#include "voronaut/benchmarks/tuning/tuned_suites.h"

#include <stdexcept>

#include <nlohmann/json.hpp>

#include "voronaut/benchmarks/suite/suite_paths.h"
#include "voronaut/environments/config/nearest_name.h"

namespace voronaut {

namespace {

const SuiteList& planners_list() {
  for (const SuiteList& list : suite_lists())
    if (list.each == "planner") return list;
  throw std::logic_error("a suite has planners");
}

// Which YAML reads as the same text.
std::string in_json(const std::string& text) { return nlohmann::json(text).dump(); }

// The entry at these values; by its own label if none is given.
ConfigNode tuned(const ConfigNode& entry, const std::vector<SearchKey>& keys,
                 const Candidate& candidate, const std::string& label) {
  const ConfigNode name = entry.is_map() ? entry.child("name") : entry;
  ConfigNode made = entry.is_map() ? entry : name.under("name");
  for (std::size_t i = 0; i < candidate.values.size(); ++i)
    made = with_entry_value(planners_list(), made, keys[i].key,
                            entry.value(candidate.values[i], entry.place()));
  return label.empty() ? made : made.with("label", entry.value(in_json(label), entry.place()));
}

std::string head(const std::string& said, const std::string& file) {
  return "# " + said + "\ninclude: " + in_json(file) + "\n";
}

}  // namespace

std::vector<Candidate> candidates_of(const std::string& planner,
                                     const std::vector<std::vector<std::string>>& points) {
  std::vector<Candidate> candidates = {{planner, {}}};
  for (const auto& point : points)
    candidates.push_back({planner + "-" + std::to_string(candidates.size()), point});
  return candidates;
}

ConfigNode planner_entry(const ConfigNode& root, const std::string& label) {
  std::vector<std::string> names;
  for (const ConfigNode& entry : root.child("planners").items()) {
    names.push_back(entry_name(entry));
    if (names.back() == label) return entry;
  }
  throw std::invalid_argument("--planner: no planner " + in_quotes(label) + " in " + root.file() +
                              allowed_names(label, names));
}

std::string candidates_suite(const ConfigNode& root, const std::string& file,
                             const std::string& planner, const std::vector<SearchKey>& keys,
                             const std::vector<Candidate>& candidates) {
  const ConfigNode entry = planner_entry(root, planner);
  std::string text = head("Candidates of a tuning of " + planner, file);
  text += "suite: " + root.child("suite").text() + "-tune\nacceptance: []\nplanners:\n";
  for (const Candidate& candidate : candidates)
    text += "  - " + tuned(entry, keys, candidate, candidate.label).yaml() + "\n";
  return text;
}

std::string winners_suite(const ConfigNode& root, const std::string& file,
                          const std::string& planner, const std::vector<SearchKey>& keys,
                          const Candidate& winner, const std::string& said) {
  std::string text = head(said, file) + "planners:\n";
  for (const ConfigNode& entry : root.child("planners").items())
    text += "  - " +
            (entry_name(entry) == planner ? tuned(entry, keys, winner, "") : entry).yaml() + "\n";
  return text;
}

}  // namespace voronaut
