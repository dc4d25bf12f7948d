#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

// The few calls of SQLite's C API that the store needs, with owners for the handles and with every
// error turned into a StoreError that names the file and quotes SQLite. Not thread-safe.
namespace voronaut {

class StoreError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

namespace sqlite {

enum class OpenMode {
  existing,  // read and write, read-only where the file is; an error if it is not there
  create,    // read and write, made if it is not there
};

class Database {
 public:
  Database(const std::filesystem::path& file, OpenMode mode);
  Database(Database&& other) noexcept;
  Database& operator=(Database&& other) noexcept;
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;
  ~Database();

  void execute(const std::string& sql);
  // Throws StoreError "<file>: <what>: <SQLite's message>", with the system's reason if there is
  // one.
  [[noreturn]] void fail(std::string_view what) const;

  // Whether its path still leads to the file that was opened.
  bool is_at_its_path() const;

  sqlite3* handle() const { return handle_; }
  const std::string& file() const { return file_; }

 private:
  std::string file_;
  sqlite3* handle_ = nullptr;
};

// A prepared statement. Parameters count from 1, columns from 0, as in SQLite. The database must
// outlive it.
class Statement {
 public:
  Statement(const Database& database, const std::string& sql);
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;
  ~Statement();

  void bind(int parameter, std::string_view text);
  void bind(int parameter, std::int64_t value);
  void bind(int parameter, double value);  // NaN becomes NULL
  void bind_blob(int parameter, std::string_view bytes);

  // True while there is a row.
  bool step();
  void reset();

  enum class Type { null, integer, real, text, blob };
  Type type(int column) const;  // of the value, whatever the column's declared type
  std::string text(int column) const;
  std::string blob(int column) const;
  std::int64_t integer(int column) const;
  double real(int column) const;  // NULL becomes NaN

 private:
  void check(int code, std::string_view what) const;

  const Database& database_;
  sqlite3_stmt* handle_ = nullptr;
};

// All or nothing: rolled back unless committed.
class Transaction {
 public:
  explicit Transaction(Database& database);
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  ~Transaction();
  void commit();

 private:
  Database& database_;
  bool open_ = true;
};

}  // namespace sqlite
}  // namespace voronaut
