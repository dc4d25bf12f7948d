#include "voronaut/reports/summary/results_page.h"

#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

namespace voronaut {
namespace {

TEST(ResultsPage, IsTheOneThatTheDocumentationHolds) {
  std::ifstream file(std::string(VORONAUT_SOURCE_DIR) + "/docs/results.md");
  const std::string text(std::istreambuf_iterator<char>(file), {});
  EXPECT_EQ(text, results_page()) << "print it with: voronaut list results > docs/results.md";
}

}  // namespace
}  // namespace voronaut
