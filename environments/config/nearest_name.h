#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace voronaut {

// The name that was probably meant: the closest by edits (insert, delete, replace, swap of two
// neighbours; restricted Damerau-Levenshtein, https://doi.org/10.1145/363958.363994), if it is at
// most a third of the longer name's letters away. Ties go to the first. O(names * length^2).
std::optional<std::string> nearest_name(std::string_view written,
                                        const std::vector<std::string>& names);

// "a, b, c"
std::string join_names(const std::vector<std::string>& names);

// " (allowed: a, b, c; did you mean 'b'?)"
std::string allowed_names(std::string_view written, const std::vector<std::string>& names);

// `text` in quotes as an error line shows it: control characters escaped, at most 60 characters.
std::string in_quotes(std::string_view text);

}  // namespace voronaut
