#pragma once

#include <string>

#include "voronaut/benchmarks/keys/file_keys.h"

namespace voronaut {

// docs/keys.md: every key with what it may be, its unit, its default and one sentence, as Markdown.
std::string keys_page(const FileKeys& keys);

}  // namespace voronaut
