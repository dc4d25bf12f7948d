#pragma once

#include <optional>
#include <string>
#include <vector>

#include "voronaut/environments/config/config_node.h"
#include "voronaut/environments/scenario/scenario_spec.h"

// What the entries of scenarios share, whatever their world comes from. All throw ConfigError.
namespace voronaut {

using ScenarioSpecs = std::vector<ScenarioSpec>;

Vec2 read_point(const ConfigNode& node);
Bounds read_bounds(const ConfigNode& node);

// The keys of TaskConfig; `other_keys` may stand beside them. Names become file names, columns and
// arguments: letters, digits and _-.+ only.
TaskConfig read_task(const ConfigNode& entry, const std::string& default_name,
                     const std::vector<std::string>& other_keys);
std::optional<double> read_heading(const ConfigNode& entry);

// The file that a key names, relative to the file in which the key stands.
std::string existing_file(const ConfigNode& node);
// The file's name without its folder and ending.
std::string stem(const std::string& path);

// One world, its start and goal checked: a fault in one of them is reported at its key, or, where
// the entry has no such key, at `place`. The heading of the start is the entry's start_heading_rad
// or, where that is not given, the one of the file that the start comes from, if it has one.
ScenarioSpec placed_scenario(const TaskConfig& task, const std::shared_ptr<const World>& world,
                             const Vec2& start, const Vec2& goal, const ConfigNode& entry,
                             const ConfigNode& place,
                             std::optional<double> heading_of_file_rad = {});

}  // namespace voronaut
