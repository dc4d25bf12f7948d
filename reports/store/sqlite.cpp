#include "voronaut/reports/store/sqlite.h"

#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

#include <sqlite3.h>

namespace voronaut::sqlite {

namespace {
// Another process may be writing: a reader of a running suite waits for one transaction.
constexpr int kBusyTimeoutMs = 20'000;
}  // namespace

Database::Database(const std::filesystem::path& file, OpenMode mode) : file_(file.string()) {
  const int flags = SQLITE_OPEN_READWRITE | (mode == OpenMode::create ? SQLITE_OPEN_CREATE : 0);
  if (sqlite3_open_v2(file_.c_str(), &handle_, flags, nullptr) != SQLITE_OK) {
    const std::string message =
        file_ + ": cannot open the result store: " + (handle_ ? sqlite3_errmsg(handle_) : "memory");
    sqlite3_close(handle_);
    throw StoreError(message);
  }
  sqlite3_busy_timeout(handle_, kBusyTimeoutMs);
}

Database::Database(Database&& other) noexcept
    : file_(std::move(other.file_)), handle_(std::exchange(other.handle_, nullptr)) {}

Database& Database::operator=(Database&& other) noexcept {
  std::swap(file_, other.file_);
  std::swap(handle_, other.handle_);
  return *this;
}

Database::~Database() { sqlite3_close(handle_); }

void Database::execute(const std::string& sql) {
  if (sqlite3_exec(handle_, sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK) {
    fail(sql.substr(0, sql.find('(')));
  }
}

bool Database::is_at_its_path() const {
  int moved = 0;
  sqlite3_file_control(handle_, "main", SQLITE_FCNTL_HAS_MOVED, &moved);
  return moved == 0;
}

void Database::fail(std::string_view what) const {
  const int code = sqlite3_errcode(handle_) & 0xff;
  const int reason = sqlite3_system_errno(handle_);
  const bool of_system = reason != 0 && (code == SQLITE_IOERR || code == SQLITE_CANTOPEN);
  throw StoreError(file_ + ": " + std::string(what) + ": " + sqlite3_errmsg(handle_) +
                   (of_system ? " (" + std::string(std::strerror(reason)) + ")" : ""));
}

Statement::Statement(const Database& database, const std::string& sql) : database_(database) {
  if (sqlite3_prepare_v2(database.handle(), sql.c_str(), static_cast<int>(sql.size()), &handle_,
                         nullptr) != SQLITE_OK) {
    database.fail(sql.substr(0, 60));
  }
}

Statement::~Statement() { sqlite3_finalize(handle_); }

void Statement::check(int code, std::string_view what) const {
  if (code != SQLITE_OK) {
    database_.fail(what);
  }
}

void Statement::bind(int parameter, std::string_view text) {
  check(sqlite3_bind_text64(handle_, parameter, text.data() ? text.data() : "", text.size(),
                            SQLITE_TRANSIENT, SQLITE_UTF8),
        "bind text");
}

void Statement::bind(int parameter, std::int64_t value) {
  check(sqlite3_bind_int64(handle_, parameter, value), "bind integer");
}

void Statement::bind(int parameter, double value) {
  check(std::isnan(value) ? sqlite3_bind_null(handle_, parameter)
                          : sqlite3_bind_double(handle_, parameter, value),
        "bind number");
}

void Statement::bind_blob(int parameter, std::string_view bytes) {
  check(sqlite3_bind_blob64(handle_, parameter, bytes.data() ? bytes.data() : "", bytes.size(),
                            SQLITE_TRANSIENT),
        "bind blob");
}

bool Statement::step() {
  const int code = sqlite3_step(handle_);
  if (code == SQLITE_ROW) {
    return true;
  }
  if (code != SQLITE_DONE) {
    database_.fail(std::string_view(sqlite3_sql(handle_)).substr(0, 60));
  }
  return false;
}

void Statement::reset() {
  sqlite3_reset(handle_);
  sqlite3_clear_bindings(handle_);
}

Statement::Type Statement::type(int column) const {
  switch (sqlite3_column_type(handle_, column)) {
    case SQLITE_INTEGER:
      return Type::integer;
    case SQLITE_FLOAT:
      return Type::real;
    case SQLITE_TEXT:
      return Type::text;
    case SQLITE_BLOB:
      return Type::blob;
    default:
      return Type::null;
  }
}

std::string Statement::text(int column) const {
  const auto* data = reinterpret_cast<const char*>(sqlite3_column_text(handle_, column));
  return data ? std::string(data, static_cast<std::size_t>(sqlite3_column_bytes(handle_, column)))
              : std::string();
}

std::string Statement::blob(int column) const {
  const auto* data = static_cast<const char*>(sqlite3_column_blob(handle_, column));
  return data ? std::string(data, static_cast<std::size_t>(sqlite3_column_bytes(handle_, column)))
              : std::string();
}

std::int64_t Statement::integer(int column) const { return sqlite3_column_int64(handle_, column); }

double Statement::real(int column) const {
  return sqlite3_column_type(handle_, column) == SQLITE_NULL
             ? std::numeric_limits<double>::quiet_NaN()
             : sqlite3_column_double(handle_, column);
}

Transaction::Transaction(Database& database) : database_(database) {
  database_.execute("BEGIN IMMEDIATE");
}

Transaction::~Transaction() {
  if (open_) {
    // An error may have rolled back already; there is nobody to tell in a destructor.
    sqlite3_exec(database_.handle(), "ROLLBACK", nullptr, nullptr, nullptr);
  }
}

void Transaction::commit() {
  database_.execute("COMMIT");
  open_ = false;
}

}  // namespace voronaut::sqlite
