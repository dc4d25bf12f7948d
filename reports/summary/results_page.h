#pragma once

#include <string>

namespace voronaut {

// What stands in results, in Markdown: how trials end, the columns of a record, the statistics.
// docs/results.md is this text, printed by `voronaut list results`.
std::string results_page();

}  // namespace voronaut
