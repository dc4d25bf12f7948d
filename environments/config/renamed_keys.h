#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace voronaut {

// What a word of an older YAML file, a key or the name of a choice, is called now.
struct Renaming {
  std::string_view old;
  std::string_view now;
};

// All of them.
std::span<const Renaming> renamings();

// "'clearance_min_m' is now 'planning_clearance_m'" if `written` is an old word whose new one is
// `allowed` here, else empty: a word may be old in one section and right in another.
std::string renamed_text(std::string_view written, const std::vector<std::string>& allowed);

}  // namespace voronaut
