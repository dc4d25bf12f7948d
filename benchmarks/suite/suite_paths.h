#pragma once

#include <string>
#include <vector>

#include "voronaut/environments/config/config_node.h"

// Values of a suite file by their path, as --set and `sweep` name them:
//
//   range_finder.max_range_m      keys from the root, sections that are missing are made
//   planners.RRTConnect.range     an entry of a list by its label or name, then its key; what is no
//                                 key of the entry is one of its parameters
//   vehicle.max_speed_m_s         every entry of the list: planner, vehicle, scenario
//   sweep.vehicle.max_speed_m_s   an axis of the sweep, whose key is a path itself
namespace voronaut {

// Whether a section of a suite may be the name of a preset alone: `navigation: paper`, which is
// short for `navigation: {preset: paper}`.
bool has_presets(const std::string& section);

struct SuiteList {
  std::string key;   // "planners"
  std::string each;  // "planner"
};
// The lists of a suite whose entries have names.
const std::vector<SuiteList>& suite_lists();

// What an entry of such a list is called: its label or name, else that of its generator, its data
// set or its file.
std::string entry_name(const ConfigNode& entry);

// Where a path leads: into which list, which of its entries, and what of them.
struct EntryPath {
  const SuiteList* list = nullptr;  // null: no list, all of the path is keys from the root
  std::string entry;                // empty: every entry
  std::string key;                  // empty: the list or the entry as a whole
};
// Names may have dots in them: the longest that the suite has counts. Throws `place.error()` for a
// name that it has not.
EntryPath entry_path(const ConfigNode& root, const std::string& path, const ConfigNode& place);

// An entry of a list with a value at a key of it.
ConfigNode with_entry_value(const SuiteList& list, const ConfigNode& entry, const std::string& key,
                            const ConfigNode& value);

// The suite with a value at a path. A key that there is not is put in all the same: the readers
// refuse it, as they refuse it in a file. Throws `value.error()` for a path that leads nowhere.
ConfigNode with_value_at(const ConfigNode& root, const std::string& path, const ConfigNode& value);

// The suite as the argument of --set changes it: "path=value", the value as YAML writes it.
ConfigNode with_setting(const ConfigNode& root, const std::string& assignment);

}  // namespace voronaut
