#pragma once

#include <string_view>

namespace voronaut {

// Runs of digits compare as numbers, everything else by bytes.
bool natural_less(std::string_view a, std::string_view b);

}  // namespace voronaut
