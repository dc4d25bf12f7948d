#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "voronaut/reports/run_record.h"
#include "voronaut/reports/store/packed_trial.h"
#include "voronaut/reports/store/pending_file.h"
#include "voronaut/reports/store/sqlite.h"
#include "voronaut/reports/trace/trace.h"

namespace voronaut {

// The results of a suite in one SQLite file: table `trials` (one row per trial, the columns of
// record_columns(), absent numbers NULL), `worlds` (world_id, json), `traces` (trial_id, raw
// deflate of the JSON of trace_json.h), `files` (path, raw deflate of what was read there) and
// `meta` (key, value). PRAGMA user_version is the schema's version.
//
// Each insert is one transaction. What is kept for later shares one with others and is meanwhile in
// a file beside the database (pending_file.h), from which open() and create() take it in: a process
// that is killed at any moment loses at most the trial in flight, a machine that loses its power
// what was kept in the last kPendingTimeMax. The journal is a rollback journal, which also holds on
// network file systems. One object belongs to one thread of one process: open it anew after fork.
//
// Every failure is a StoreError that names the file and quotes SQLite.
class ResultStore {
 public:
  static constexpr int kSchemaVersion = 4;

  using Meta = std::map<std::string, std::string>;

  // An existing store; an error if the file is not there or was written with another schema.
  static ResultStore open(const std::filesystem::path& file);
  // The same, made first if the file is not there or holds nothing yet. `meta` belongs to the
  // making: a store is there with all of it or not at all, at whatever moment its maker is killed.
  static ResultStore create(const std::filesystem::path& file, const Meta& meta = {});

  std::filesystem::path file() const { return database_.file(); }
  bool has(std::string_view trial_id) const;

  // False if the trial was there already with the same deterministic columns (nothing is written
  // then); StoreError naming the column if one of them differs, for the trial is not what its id
  // says. -0.0 and 0.0 are equal, as SQLite stores them.
  bool insert(const RunRecord& record, const std::optional<Trace>& trace);
  // The same with the trace as stored, for merging.
  bool insert_with_blob(const RunRecord& record, std::string_view trace_blob);
  // All rows, worlds, traces and files of another store that this one lacks, or none: StoreError
  // naming trial, column and both values where a trial of both has another result there.
  void take_in(const std::filesystem::path& other);
  // Writes the file anew if somebody deleted, moved or replaced it while it is open; insert()
  // begins with that. What was cut off from it or overwritten in it is lost.
  void restore_at_path();
  // Kept once per world_id.
  void insert_world(const TraceWorld& world);

  // For one writer at a time: safe from now on, in the tables with the next flush(), which comes by
  // itself when much is pending.
  void keep(const RunRecord& record, std::string trace_blob);
  void keep_world(const TraceWorld& world);
  void flush();
  // If something has been pending for kPendingTimeMax. Call it often.
  void flush_when_due();
  static constexpr std::chrono::seconds kPendingTimeMax{30};

  // One record after another, however many there are; `order` is that of SQL's ORDER BY, texts by
  // bytes, and may end with a LIMIT.
  void for_each_record(const std::function<void(const RunRecord&)>& use,
                       const std::string& order = "trial_id") const;
  std::size_t size() const;  // how many records
  // Ordered by trial_id (by bytes).
  std::vector<RunRecord> records() const;
  std::vector<std::string> trial_ids() const;
  std::optional<RunRecord> record(std::string_view trial_id) const;
  std::optional<Trace> trace(std::string_view trial_id) const;
  // Raw deflate of the JSON of trace_json.h.
  std::optional<std::string> trace_blob(std::string_view trial_id) const;
  std::map<std::string, std::size_t> trace_sizes() const;  // bytes of each trace_blob
  std::vector<TraceWorld> worlds() const;                  // ordered by world_id
  // At most so many of those that are wanted.
  std::vector<TraceWorld> worlds(std::size_t most,
                                 const std::function<bool(const std::string& id)>& wanted) const;

  // All of it or nothing.
  void set_meta(const Meta& meta);
  std::optional<std::string> meta(std::string_view key) const;

  // Copies of files that the results came from, by path; all of them are replaced.
  using Files = std::map<std::string, std::string>;
  void keep_files(const Files& files);
  Files kept_files() const;

 private:
  ResultStore(const std::filesystem::path& file, sqlite::OpenMode mode);
  void create_tables(const Meta& meta);
  void write_meta(const Meta& meta);
  void check_schema() const;
  struct RowStatements;  // prepared once for many rows
  bool insert_row(RowStatements& prepared, const RunRecord& record, std::string_view trace_blob);

  void remember(PendingFile::Kind kind, std::string_view payload);
  void store_together(const std::vector<PackedTrial>& trials,
                      const std::vector<TraceWorld>& worlds);
  void insert_rows(const std::vector<PackedTrial>& trials);  // in a transaction
  void take_in_pending();
  static std::filesystem::path pending_path(const std::filesystem::path& file);
  static constexpr std::size_t kPendingMax = 128;
  static constexpr std::size_t kPendingBytesMax = std::size_t{8} << 20U;

  sqlite::Database database_;
  std::unique_ptr<PendingFile> pending_file_;
  std::vector<PackedTrial> pending_trials_;
  std::vector<TraceWorld> pending_worlds_;
  std::size_t pending_bytes_ = 0;
  std::chrono::steady_clock::time_point pending_since_;
};

// The first deterministic column in which two records of one trial differ, with both values as
// text. NaN equals NaN.
struct Difference {
  std::string column;
  std::string a;
  std::string b;
};
std::optional<Difference> first_difference(const RunRecord& a, const RunRecord& b);

}  // namespace voronaut
