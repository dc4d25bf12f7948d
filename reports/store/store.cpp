#include "voronaut/reports/store/store.h"

#include <type_traits>

#include <unistd.h>

#include "voronaut/reports/page/trace_json.h"
#include "voronaut/reports/store/deflate.h"
#include "voronaut/reports/summary/column_text.h"

namespace voronaut {

namespace {

template <class Value>
constexpr const char* sql_type() {
  if constexpr (std::is_same_v<Value, std::int64_t>) {
    return "INTEGER NOT NULL";
  } else if constexpr (std::is_same_v<Value, double>) {
    return "REAL";
  } else {
    return "TEXT NOT NULL";
  }
}

struct Column {
  std::string name;
  std::string type;
};

std::vector<Column> columns() {
  std::vector<Column> list;
  RunRecord().visit([&list](const char* name, const auto& value, ColumnKind) {
    list.push_back({name, sql_type<std::remove_cvref_t<decltype(value)>>()});
  });
  return list;
}

std::string join(const std::vector<Column>& list, const std::string& each = {}) {
  std::string text;
  for (const Column& column : list) {
    text += (text.empty() ? "" : ", ") + (each.empty() ? column.name : each);
  }
  return text;
}

void bind_record(sqlite::Statement& statement, const RunRecord& record) {
  int parameter = 0;
  record.visit([&](const char*, const auto& value, ColumnKind) {
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
void require(const sqlite::Statement& statement, int column, const char* name,
             const std::string& file, const std::string& trial_id) {
  if (holds<Value>(statement, column)) return;
  const char* expected = std::is_same_v<Value, std::int64_t> ? "a whole number"
                         : std::is_same_v<Value, double>     ? "a number"
                                                             : "text";
  throw StoreError(file + ": table trials, row " +
                   (trial_id.empty() ? "without trial_id" : "with trial_id '" + trial_id + "'") +
                   ", column " + name + ": expected " + expected + ", got '" +
                   statement.text(column).substr(0, 60) + "'");
}

RunRecord read_record(const sqlite::Statement& statement, const std::string& file) {
  RunRecord record;
  int column = 0;
  record.visit([&](const char* name, auto& value, ColumnKind) {
    using Value = std::remove_cvref_t<decltype(value)>;
    require<Value>(statement, column, name, file, record.trial_id);
    if constexpr (std::is_same_v<Value, Outcome>) {
      try {
        value = outcome_from_string(statement.text(column));
      } catch (const std::invalid_argument& error) {
        throw StoreError(file + ": trial " + record.trial_id + ": " + error.what());
      }
    } else if constexpr (std::is_same_v<Value, std::int64_t>) {
      value = statement.integer(column);
    } else if constexpr (std::is_same_v<Value, double>) {
      value = statement.real(column);
    } else {
      value = statement.text(column);
    }
    ++column;
  });
  return record;
}

std::vector<std::string> deterministic_texts(const RunRecord& record,
                                             std::vector<std::string>* names = nullptr) {
  std::vector<std::string> texts;
  record.visit([&](const char* name, const auto& value, ColumnKind kind) {
    using Value = std::remove_cvref_t<decltype(value)>;
    if (kind != ColumnKind::deterministic) {
      return;
    }
    if (names != nullptr) {
      names->emplace_back(name);
    }
    if constexpr (std::is_same_v<Value, Outcome>) {
      texts.emplace_back(to_string(value));
    } else if constexpr (std::is_same_v<Value, std::int64_t>) {
      texts.push_back(std::to_string(value));
    } else if constexpr (std::is_same_v<Value, double>) {
      texts.push_back(column_text(value == 0.0 ? 0.0 : value));
    } else {
      texts.push_back(value);
    }
  });
  return texts;
}

}  // namespace

std::optional<Difference> first_difference(const RunRecord& a, const RunRecord& b) {
  std::vector<std::string> names;
  const auto texts_a = deterministic_texts(a, &names);
  const auto texts_b = deterministic_texts(b);
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (texts_a[i] != texts_b[i]) {
      return Difference{names[i], texts_a[i], texts_b[i]};
    }
  }
  return std::nullopt;
}

ResultStore::ResultStore(const std::filesystem::path& file, sqlite::OpenMode mode)
    : database_(file, mode) {}

ResultStore ResultStore::open(const std::filesystem::path& file) {
  ResultStore store(file, sqlite::OpenMode::existing);
  store.check_schema();
  return store;
}

ResultStore ResultStore::create(const std::filesystem::path& file, const Meta& meta) {
  ResultStore store(file, sqlite::OpenMode::create);
  store.create_tables(meta);
  store.check_schema();
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
  for (const Column& column : columns()) {
    trials += (trials.empty() ? "" : ", ") + column.name + " " + column.type +
              (column.name == "trial_id" ? " PRIMARY KEY" : "");
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
  if (const std::string expected = join(columns()); stored != expected) {
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

bool ResultStore::insert_with_blob(const RunRecord& record, std::string_view trace_blob) {
  restore_at_path();
  sqlite::Transaction transaction(database_);
  if (const auto stored = this->record(record.trial_id)) {
    if (const auto difference = first_difference(*stored, record)) {
      throw StoreError(database_.file() + ": trial " + record.trial_id +
                       " is stored with another value of " + difference->column + ": '" +
                       difference->a + "', now '" + difference->b + "'");
    }
    return false;
  }
  {
    const auto list = columns();
    sqlite::Statement row(
        database_, "INSERT INTO trials(" + join(list) + ") VALUES (" + join(list, "?") + ")");
    bind_record(row, record);
    row.step();
  }
  if (!trace_blob.empty()) {
    sqlite::Statement blob(database_,
                           "INSERT OR REPLACE INTO traces(trial_id, data) VALUES (?, ?)");
    blob.bind(1, record.trial_id);
    blob.bind_blob(2, trace_blob);
    blob.step();
  }
  transaction.commit();
  return true;
}

void ResultStore::insert_world(const TraceWorld& world) {
  sqlite::Statement row(database_, "INSERT OR IGNORE INTO worlds(world_id, json) VALUES (?, ?)");
  row.bind(1, world.world_id);
  row.bind(2, world_to_json(world));
  row.step();
}

std::vector<RunRecord> ResultStore::records() const {
  std::vector<RunRecord> list;
  sqlite::Statement query(database_,
                          "SELECT " + join(columns()) + " FROM trials ORDER BY trial_id");
  while (query.step()) {
    list.push_back(read_record(query, database_.file()));
  }
  return list;
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
                          "SELECT " + join(columns()) + " FROM trials WHERE trial_id = ?");
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
  std::vector<TraceWorld> list;
  sqlite::Statement query(database_, "SELECT world_id, json FROM worlds ORDER BY world_id");
  while (query.step()) {
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
