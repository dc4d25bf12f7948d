#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace voronaut {

// What a word of an older YAML file is called now, if one of the `allowed` words is its new name:
// keys and values alike. So a table of pairs is enough, and a word may be old in one section and
// right in another.
std::optional<std::string> renamed(std::string_view written,
                                   const std::vector<std::string>& allowed);

// "'clearance_min_m' is now 'planning_clearance_m'", or empty.
std::string renamed_text(std::string_view written, const std::vector<std::string>& allowed);

}  // namespace voronaut
