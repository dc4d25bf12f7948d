#include "voronaut/reports/record_columns.h"
#include "voronaut/reports/store/store.h"

namespace voronaut {

namespace {

// Another database file under the name `other`, as long as this lives.
class Attached {
 public:
  Attached(sqlite::Database& database, const std::filesystem::path& file) : database_(database) {
    sqlite::Statement attach(database_, "ATTACH ? AS other");
    attach.bind(1, file.string());
    attach.step();
  }
  Attached(const Attached&) = delete;
  Attached& operator=(const Attached&) = delete;
  ~Attached() {
    try {
      database_.execute("DETACH other");
    } catch (const StoreError&) {  // closed with the database then
    }
  }

 private:
  sqlite::Database& database_;
};

// Of the first trial that both hold with unlike results.
std::optional<std::string> contradicted_trial(const sqlite::Database& database) {
  std::string unlike;
  for (const RecordColumn& column : record_columns())
    if (column.kind != ColumnKind::measured) {
      const std::string name(column.name);
      unlike += (unlike.empty() ? "a." : " OR a.") + name + " IS NOT b." + name;
    }
  sqlite::Statement query(database,
                          "SELECT a.trial_id FROM main.trials a JOIN other.trials b USING(trial_id)"
                          " WHERE " +
                              unlike + " ORDER BY a.trial_id LIMIT 1");
  return query.step() ? std::optional(query.text(0)) : std::nullopt;
}

std::string columns_in_order() {
  std::string text;
  for (const RecordColumn& column : record_columns())
    text.append(text.empty() ? "" : ", ").append(column.name);
  return text;
}

}  // namespace

void ResultStore::take_in(const std::filesystem::path& other) {
  const ResultStore from = open(other);  // holds its schema against ours
  from.meta("");                         // rolls back what a writer that was killed left
  const Attached attached(database_, other);
  sqlite::Transaction transaction(database_);
  if (const auto id = contradicted_trial(database_)) {
    const RunRecord ours = record(*id).value();
    const RunRecord theirs = from.record(*id).value();
    if (const auto difference = first_difference(ours, theirs))
      throw StoreError(other.string() + ": trial " + *id + " has another value of " +
                       difference->column + " than the same trial elsewhere: '" + difference->b +
                       "' here, '" + difference->a + "' there");
  }
  const std::string columns = columns_in_order();
  database_.execute("INSERT OR IGNORE INTO main.trials(" + columns + ") SELECT " + columns +
                    " FROM other.trials");
  database_.execute("INSERT OR IGNORE INTO main.worlds SELECT * FROM other.worlds");
  database_.execute("INSERT OR IGNORE INTO main.traces SELECT * FROM other.traces");
  transaction.commit();
  Files files = from.kept_files();
  files.merge(kept_files());
  keep_files(files);
}

}  // namespace voronaut
