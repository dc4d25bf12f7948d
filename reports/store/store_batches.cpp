#include "voronaut/reports/store/packed_trial.h"
#include "voronaut/reports/store/store.h"
#include "voronaut/reports/trace/trace_json.h"

// Rows on their way into the database: many of them share one transaction.
namespace voronaut {

void ResultStore::keep(const RunRecord& record, std::string trace_blob) {
  PackedTrial trial{record, std::move(trace_blob)};
  const std::string packed = pack(trial);
  remember(PendingFile::Kind::trial, packed);
  pending_trials_.push_back(std::move(trial));
  if (pending_trials_.size() >= kPendingMax || pending_bytes_ >= kPendingBytesMax) flush();
}

void ResultStore::keep_world(const TraceWorld& world) {
  remember(PendingFile::Kind::world, world_to_json(world));
  pending_worlds_.push_back(world);
}

void ResultStore::remember(PendingFile::Kind kind, std::string_view payload) {
  if (pending_bytes_ == 0) pending_since_ = std::chrono::steady_clock::now();
  pending_file_->append(kind, payload);
  pending_bytes_ += payload.size();
}

void ResultStore::flush_when_due() {
  if (pending_bytes_ > 0 && std::chrono::steady_clock::now() - pending_since_ >= kPendingTimeMax)
    flush();
}

void ResultStore::flush() {
  restore_at_path();
  if (pending_bytes_ == 0) return;
  store_together(pending_trials_, pending_worlds_);
  pending_file_->clear();
  pending_trials_.clear();
  pending_worlds_.clear();
  pending_bytes_ = 0;
}

void ResultStore::store_together(const std::vector<PackedTrial>& trials,
                                 const std::vector<TraceWorld>& worlds) {
  sqlite::Transaction transaction(database_);
  for (const TraceWorld& world : worlds) insert_world(world);
  insert_rows(trials);
  transaction.commit();
}

void ResultStore::take_in_pending() {
  std::vector<PackedTrial> trials;
  std::vector<TraceWorld> worlds;
  for (const PendingFile::Frame& frame : PendingFile::read(pending_path(file()))) {
    if (frame.kind == PendingFile::Kind::world) {
      worlds.push_back(world_from_json(frame.payload));
      continue;
    }
    PackedTrial trial = unpack(frame.payload);
    if (!has(trial.record.trial_id)) trials.push_back(std::move(trial));
  }
  if (!trials.empty() || !worlds.empty()) store_together(trials, worlds);
}

std::filesystem::path ResultStore::pending_path(const std::filesystem::path& file) {
  return file.string() + "-pending";
}

}  // namespace voronaut
