#pragma once

#include <span>
#include <string>
#include <string_view>

namespace voronaut {

// A question to the database of results, as the page shows it.
struct ExampleQuery {
  std::string_view question;
  std::string_view sql;
};
std::span<const ExampleQuery> example_queries();

// What stands in results, in Markdown: how trials end, the columns of a record, the statistics, the
// database.
// docs/results.md is this text, printed by `voronaut list results`.
std::string results_page();

}  // namespace voronaut
