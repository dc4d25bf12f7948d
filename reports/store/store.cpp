#include "voronaut/reports/store/store.h"

#include <type_traits>

#include <unistd.h>

#include "voronaut/reports/encoding/deflate.h"
#include "voronaut/reports/record_columns.h"
#include "voronaut/reports/trace/trace_json.h"

namespace voronaut {

namespace {

// Nothing stands for an absent number; texts and counts are always there.
std::string_view sql_type(const RecordColumn& column) {
  if (std::holds_alternative<double RunRecord::*>(column.member)) return "REAL";
  return std::holds_alternative<std::int64_t RunRecord::*>(column.member) ? "INTEGER NOT NULL"
                                                                          : "TEXT NOT NULL";
}

std::string column_names() {
  std::string text;
  for (const RecordColumn& column : record_columns())
    text.append(text.empty() ? "" : ", ").append(column.name);
  return text;
}

std::string question_marks() {
  std::string text = "?";
  for (std::size_t i = 1; i < record_columns().size(); ++i) text += ", ?";
  return text;
}

void bind_record(sqlite::Statement& statement, const RunRecord& record) {
  int parameter = 0;
  visit_columns(record, [&](const RecordColumn&, const auto& value) {
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(value)>, Outcome>) {
      statement.bind(++parameter, to_string(value));
    } else {
      statement.bind(++parameter, value);
    }
  });
}

// SQLite keeps text in a column of numbers if somebody puts it there.
template <class Value>
bool holds(const sqlite::Statement& statement, int column) {
  using Type = sqlite::Statement::Type;
  const Type type = statement.type(column);
  if constexpr (std::is_same_v<Value, std::int64_t>) {
    return type == Type::integer;
  } else if constexpr (std::is_same_v<Value, double>) {
    return type == Type::real || type == Type::integer || type == Type::null;
  } else {
    return type == Type::text;
  }
}

template <class Value>
void require(const sqlite::Statement& statement, int column, std::string_view name,
             const std::string& file, const std::string& trial_id) {
  if (holds<Value>(statement, column)) return;
  const char* expected = std::is_same_v<Value, std::int64_t> ? "a whole number"
                         : std::is_same_v<Value, double>     ? "a number"
                                                             : "text";
  throw StoreError(file + ": table trials, row " +
                   (trial_id.empty() ? "without trial_id" : "with trial_id '" + trial_id + "'") +
                   ", column " + std::string(name) + ": expected " + expected + ", got '" +
                   statement.text(column).substr(0, 60) + "'");
}

RunRecord read_record(const sqlite::Statement& statement, const std::string& file) {
  RunRecord record;
  int at = 0;
  visit_columns(record, [&](const RecordColumn& column, auto& value) {
    using Value = std::remove_cvref_t<decltype(value)>;
    require<Value>(statement, at, column.name, file, record.trial_id);
    if constexpr (std::is_same_v<Value, Outcome>) {
      try {
        value = outcome_from_string(statement.text(at));
      } catch (const std::invalid_argument& error) {
        throw StoreError(file + ": trial " + record.trial_id + ": " + error.what());
      }
    } else if constexpr (std::is_same_v<Value, std::int64_t>) {
      value = statement.integer(at);
    } else if constexpr (std::is_same_v<Value, double>) {
      value = statement.real(at);
    } else {
      value = statement.text(at);
    }
    ++at;
  });
  return record;
}

}  // namespace

std::optional<Difference> first_difference(const RunRecord& a, const RunRecord& b) {
  for (const RecordColumn& column : record_columns()) {
    if (column.kind == ColumnKind::measured) continue;
    const std::string text_a = cell_text(a, column);
    const std::string text_b = cell_text(b, column);
    if (text_a != text_b) return Difference{std::string(column.name), text_a, text_b};
  }
  return std::nullopt;
}

ResultStore::ResultStore(const std::filesystem::path& file, sqlite::OpenMode mode)
    : database_(file, mode), pending_file_(std::make_unique<PendingFile>(pending_path(file))) {}

ResultStore ResultStore::open(const std::filesystem::path& file) {
  ResultStore store(file, sqlite::OpenMode::existing);
  store.check_schema();
  try {
    store.take_in_pending();
  } catch (const StoreError&) {  // may only be read: without what its runner left behind
  }
  return store;
}

ResultStore ResultStore::create(const std::filesystem::path& file, const Meta& meta) {
  ResultStore store(file, sqlite::OpenMode::create);
  store.create_tables(meta);
  store.check_schema();
  store.take_in_pending();
  store.pending_file_->clear();
  return store;
}

void ResultStore::create_tables(const Meta& meta) {
  sqlite::Transaction transaction(database_);
  {
    sqlite::Statement tables(database_, "SELECT count(*) FROM sqlite_master");
    tables.step();
    if (tables.integer(0) != 0) {
      return;  // a store already, or a stranger: check_schema tells
    }
  }
  std::string trials;
  for (const RecordColumn& column : record_columns()) {
    trials.append(trials.empty() ? "" : ", ").append(column.name).append(" ");
    trials.append(sql_type(column)).append(column.name == "trial_id" ? " PRIMARY KEY" : "");
  }
  database_.execute("CREATE TABLE trials(" + trials + ")");
  database_.execute("CREATE TABLE worlds(world_id TEXT NOT NULL PRIMARY KEY, json TEXT NOT NULL)");
  database_.execute("CREATE TABLE traces(trial_id TEXT NOT NULL PRIMARY KEY, data BLOB NOT NULL)");
  database_.execute("CREATE TABLE meta(key TEXT NOT NULL PRIMARY KEY, value TEXT NOT NULL)");
  write_meta(meta);
  database_.execute("PRAGMA user_version = " + std::to_string(kSchemaVersion));
  transaction.commit();
}

void ResultStore::check_schema() const {
  sqlite::Statement version(database_, "PRAGMA user_version");
  version.step();
  if (version.integer(0) != kSchemaVersion) {
    throw StoreError(database_.file() + ": schema version " + std::to_string(version.integer(0)) +
                     ", this program reads version " + std::to_string(kSchemaVersion));
  }
  std::string stored;
  sqlite::Statement info(database_, "SELECT name FROM pragma_table_info('trials') ORDER BY cid");
  while (info.step()) {
    stored += (stored.empty() ? "" : ", ") + info.text(0);
  }
  if (const std::string expected = column_names(); stored != expected) {
    throw StoreError(database_.file() + ": table trials has the columns (" + stored +
                     "), this program reads (" + expected + ")");
  }
}

bool ResultStore::has(std::string_view trial_id) const {
  sqlite::Statement query(database_, "SELECT 1 FROM trials WHERE trial_id = ?");
  query.bind(1, trial_id);
  return query.step();
}

bool ResultStore::insert(const RunRecord& record, const std::optional<Trace>& trace) {
  return insert_with_blob(record, trace ? compress_trace(*trace) : std::string());
}

void ResultStore::restore_at_path() {
  if (database_.is_at_its_path()) return;
  const std::filesystem::path copy = database_.file() + ".part" + std::to_string(getpid());
  std::filesystem::remove(copy);
  {
    sqlite::Statement into(database_, "VACUUM INTO ?");
    into.bind(1, copy.string());
    into.step();
  }
  std::filesystem::rename(copy, file());
  database_ = sqlite::Database(file(), sqlite::OpenMode::existing);
}

struct ResultStore::RowStatements {
  explicit RowStatements(const sqlite::Database& database)
      : stored(database, "SELECT " + column_names() + " FROM trials WHERE trial_id = ?"),
        row(database,
            "INSERT INTO trials(" + column_names() + ") VALUES (" + question_marks() + ")"),
        blob(database, "INSERT OR REPLACE INTO traces(trial_id, data) VALUES (?, ?)") {}

  sqlite::Statement stored;
  sqlite::Statement row;
  sqlite::Statement blob;
};

bool ResultStore::insert_with_blob(const RunRecord& record, std::string_view trace_blob) {
  restore_at_path();
  sqlite::Transaction transaction(database_);
  bool inserted = false;
  {
    RowStatements prepared(database_);
    inserted = insert_row(prepared, record, trace_blob);
  }
  if (inserted) transaction.commit();
  return inserted;
}

bool ResultStore::insert_row(RowStatements& prepared, const RunRecord& record,
                             std::string_view trace_blob) {
  prepared.stored.bind(1, record.trial_id);
  const auto stored = prepared.stored.step()
                          ? std::optional(read_record(prepared.stored, database_.file()))
                          : std::nullopt;
  prepared.stored.reset();
  if (stored) {
    if (const auto difference = first_difference(*stored, record)) {
      throw StoreError(database_.file() + ": trial " + record.trial_id +
                       " is stored with another value of " + difference->column + ": '" +
                       difference->a + "', now '" + difference->b + "'");
    }
    return false;
  }
  bind_record(prepared.row, record);
  prepared.row.step();
  prepared.row.reset();
  if (!trace_blob.empty()) {
    prepared.blob.bind(1, record.trial_id);
    prepared.blob.bind_blob(2, trace_blob);
    prepared.blob.step();
    prepared.blob.reset();
  }
  return true;
}

void ResultStore::insert_rows(const std::vector<PackedTrial>& trials) {
  RowStatements prepared(database_);
  for (const PackedTrial& trial : trials) insert_row(prepared, trial.record, trial.trace_blob);
}

void ResultStore::insert_world(const TraceWorld& world) {
  sqlite::Statement row(database_, "INSERT OR IGNORE INTO worlds(world_id, json) VALUES (?, ?)");
  row.bind(1, world.world_id);
  row.bind(2, world_to_json(world));
  row.step();
}

void ResultStore::for_each_record(const std::function<void(const RunRecord&)>& use,
                                  const std::string& order) const {
  const auto next = records_in(order);
  while (const auto record = next()) use(*record);
}

std::function<std::optional<RunRecord>()> ResultStore::records_in(const std::string& order) const {
  const auto query = std::make_shared<sqlite::Statement>(
      database_, "SELECT " + column_names() + " FROM trials ORDER BY " + order);
  return [query, file = database_.file()] {
    return query->step() ? std::optional(read_record(*query, file)) : std::nullopt;
  };
}

std::vector<RunRecord> ResultStore::records() const {
  std::vector<RunRecord> list;
  for_each_record([&](const RunRecord& record) { list.push_back(record); });
  return list;
}

std::size_t ResultStore::size() const {
  sqlite::Statement query(database_, "SELECT count(*) FROM trials");
  query.step();
  return static_cast<std::size_t>(query.integer(0));
}

std::vector<std::string> ResultStore::trial_ids() const {
  std::vector<std::string> list;
  sqlite::Statement query(database_, "SELECT trial_id FROM trials ORDER BY trial_id");
  while (query.step()) {
    list.push_back(query.text(0));
  }
  return list;
}

std::optional<RunRecord> ResultStore::record(std::string_view trial_id) const {
  sqlite::Statement query(database_,
                          "SELECT " + column_names() + " FROM trials WHERE trial_id = ?");
  query.bind(1, trial_id);
  return query.step() ? std::optional(read_record(query, database_.file())) : std::nullopt;
}

std::optional<std::string> ResultStore::trace_blob(std::string_view trial_id) const {
  sqlite::Statement query(database_, "SELECT data FROM traces WHERE trial_id = ?");
  query.bind(1, trial_id);
  return query.step() ? std::optional(query.blob(0)) : std::nullopt;
}

std::map<std::string, std::size_t> ResultStore::trace_sizes() const {
  std::map<std::string, std::size_t> sizes;
  sqlite::Statement query(database_, "SELECT trial_id, length(data) FROM traces");
  while (query.step()) {
    sizes.emplace(query.text(0), static_cast<std::size_t>(query.integer(1)));
  }
  return sizes;
}

std::optional<Trace> ResultStore::trace(std::string_view trial_id) const {
  const auto blob = trace_blob(trial_id);
  if (!blob) {
    return std::nullopt;
  }
  try {
    return decompress_trace(*blob);
  } catch (const std::invalid_argument& error) {
    throw StoreError(database_.file() + ": trace of trial " + std::string(trial_id) + ": " +
                     error.what());
  }
}

std::vector<TraceWorld> ResultStore::worlds() const {
  return worlds(std::numeric_limits<std::size_t>::max(), [](const std::string&) { return true; });
}

std::vector<TraceWorld> ResultStore::worlds(
    std::size_t most, const std::function<bool(const std::string& id)>& wanted) const {
  std::vector<TraceWorld> list;
  sqlite::Statement query(database_, "SELECT world_id, json FROM worlds ORDER BY world_id");
  while (list.size() < most && query.step()) {
    if (!wanted(query.text(0))) continue;
    try {
      list.push_back(world_from_json(query.text(1)));
    } catch (const std::invalid_argument& error) {
      throw StoreError(database_.file() + ": world " + query.text(0) + ": " + error.what());
    }
  }
  return list;
}

void ResultStore::set_meta(const Meta& meta) {
  sqlite::Transaction transaction(database_);
  write_meta(meta);
  transaction.commit();
}

void ResultStore::write_meta(const Meta& meta) {
  sqlite::Statement row(database_, "INSERT OR REPLACE INTO meta(key, value) VALUES (?, ?)");
  for (const auto& [key, value] : meta) {
    row.bind(1, key);
    row.bind(2, value);
    row.step();
    row.reset();
  }
}

std::optional<std::string> ResultStore::meta(std::string_view key) const {
  sqlite::Statement query(database_, "SELECT value FROM meta WHERE key = ?");
  query.bind(1, key);
  return query.step() ? std::optional(query.text(0)) : std::nullopt;
}

namespace {
constexpr const char* kFilesTable =
    "CREATE TABLE IF NOT EXISTS files(path TEXT NOT NULL PRIMARY KEY, data BLOB NOT NULL)";
}  // namespace

void ResultStore::keep_files(const Files& files) {
  if (files == kept_files()) return;
  sqlite::Transaction transaction(database_);
  database_.execute(kFilesTable);
  database_.execute("DELETE FROM files");
  {
    sqlite::Statement row(database_, "INSERT INTO files(path, data) VALUES (?, ?)");
    for (const auto& [path, bytes] : files) {
      row.bind(1, path);
      row.bind_blob(2, deflate_raw(bytes));
      row.step();
      row.reset();
    }
  }
  transaction.commit();
}

ResultStore::Files ResultStore::kept_files() const {
  Files files;
  sqlite::Statement table(database_, "SELECT 1 FROM sqlite_master WHERE name = 'files'");
  if (!table.step()) return files;
  sqlite::Statement query(database_, "SELECT path, data FROM files");
  while (query.step()) {
    try {
      files.emplace(query.text(0), inflate_raw(query.blob(1)));
    } catch (const std::invalid_argument& error) {
      throw StoreError(database_.file() + ": file " + query.text(0) + ": " + error.what());
    }
  }
  return files;
}

}  // namespace voronaut
