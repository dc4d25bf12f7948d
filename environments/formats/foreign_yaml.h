#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "voronaut/environments/config/config_node.h"

// YAML files of other programs: their readers take more than ours for the same. All throw
// ConfigError.
namespace voronaut {

// A flag of a file that another program's YAML reader takes for one: true and false as in our own
// files, but also True, TRUE, yes, on and their opposites (YAML 1.1).
bool read_yaml_flag(const ConfigNode& node);

// The value of a key, none where it is missing, empty, ~ or null.
std::optional<ConfigNode> find_given(const ConfigNode& map, std::string_view key);

// Refuses a key that is none of these but looks like a misspelt one of them. Others are left alone:
// the program that the file was written for has more of them in each version.
void refuse_misspelt(const ConfigNode& map, const std::vector<std::string>& known);

}  // namespace voronaut
