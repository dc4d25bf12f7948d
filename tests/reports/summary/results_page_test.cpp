#include "voronaut/reports/summary/results_page.h"

#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

#include "voronaut/reports/axis_columns.h"
#include "voronaut/reports/store/store.h"
#include "voronaut/tests/reports/synthetic_run.h"
#include "voronaut/tests/support/temporary_folder.h"

namespace voronaut {
namespace {

TEST(ResultsPage, IsTheOneThatTheDocumentationHolds) {
  std::ifstream file(std::string(VORONAUT_SOURCE_DIR) + "/docs/results.md");
  const std::string text(std::istreambuf_iterator<char>(file), {});
  EXPECT_EQ(text, results_page()) << "print it with: voronaut list results > docs/results.md";
}

TEST(ResultsPage, ShowsQueriesThatTheDatabaseAnswers) {
  const TemporaryFolder folder;
  const auto run = synthetic::make_run();
  const std::string planner = run.records.front().planner;
  ResultStore store = ResultStore::create(
      folder.path() / "results.db",
      {{"sweep",
        axis_columns_json({{"planner.range", "planner", false, {{planner, "0.5"}}, {}, {}}})}});
  for (const TraceWorld& world : run.worlds) store.insert_world(world);
  for (const RunRecord& record : run.records) store.insert(record, std::nullopt);
  store.keep_files({{"suite.yaml", "suite: s"}});
  const sqlite::Database database(folder.path() / "results.db", sqlite::OpenMode::existing);
  EXPECT_EQ(example_queries().size(), 6U);
  for (const ExampleQuery& query : example_queries()) {
    sqlite::Statement statement(database, std::string(query.sql));
    EXPECT_TRUE(statement.step()) << query.question;
    EXPECT_NE(statement.type(0), sqlite::Statement::Type::null) << query.question;
  }
  sqlite::Statement tables(database, "SELECT name FROM sqlite_master WHERE type = 'table'");
  while (tables.step())
    EXPECT_NE(results_page().find("| " + tables.text(0) + " |"), std::string::npos)
        << tables.text(0);
}

}  // namespace
}  // namespace voronaut
