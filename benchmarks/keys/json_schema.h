#pragma once

#include <string>

#include "voronaut/benchmarks/keys/file_keys.h"

namespace voronaut {

// JSON Schema (draft 7, which yaml-language-server reads) of suite files and of scenario files: a
// key that is unknown or misspelt, of the wrong type or out of bounds is refused by it. What needs
// more than one value to be seen, as an order of two bounds, is the program's business.
std::string suite_schema(const FileKeys& keys);
std::string scenario_schema(const FileKeys& keys);

}  // namespace voronaut
