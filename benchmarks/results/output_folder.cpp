#include "voronaut/benchmarks/results/output_folder.h"

#include <algorithm>
#include <cstring>
#include <fstream>
#include <ostream>
#include <set>
#include <sstream>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "voronaut/benchmarks/results/build_info.h"
#include "voronaut/benchmarks/results/digest.h"
#include "voronaut/environments/config/nearest_name.h"
#include "voronaut/environments/scenario/scenario_spec.h"
#include "voronaut/reports/page/html_report.h"
#include "voronaut/reports/store/atomic_file.h"
#include "voronaut/reports/store/csv_writer.h"
#include "voronaut/reports/summary/summary_table.h"

namespace voronaut {

namespace fs = std::filesystem;

namespace {

constexpr const char* kDatabase = "results.db";

// Why what lies in the folder does not belong to this run; empty if it does.
struct Mismatch {
  bool suite = false;
  bool program = false;
};

Mismatch compare(const ResultStore& stored, const ResultStore::Meta& meta) {
  const auto differs = [&](const char* key) {
    return stored.meta(key).value_or(meta.at(key)) != meta.at(key);
  };
  return {differs("suite_identity"), differs("program_sha256")};
}

fs::path free_name(const fs::path& folder) {
  for (int i = 1;; ++i) {
    fs::path candidate = folder;
    candidate += "." + std::to_string(i);
    if (!fs::exists(candidate)) return candidate;
  }
}

// Whether the results may be continued; if not, they are to be moved aside.
bool may_continue(const OutputFolder::Place& place, const Mismatch& mismatch, std::ostream& notes) {
  if (!mismatch.suite && !mismatch.program) return true;
  if (place.shard)
    throw std::invalid_argument(place.folder.string() + ": holds results of another " +
                                (mismatch.suite ? "version of this suite" : "build") +
                                "; give another --out or remove it");
  if (!place.chosen) return false;
  if (mismatch.suite)
    throw std::invalid_argument(place.folder.string() +
                                ": holds results of another version of this suite; give another "
                                "--out or remove it");
  notes << place.folder.string() << ": holds results of another build, which are kept\n";
  return true;
}

void move_aside(const fs::path& folder, const Mismatch& mismatch, std::ostream& notes) {
  const fs::path aside = free_name(folder);
  fs::rename(folder, aside);
  fs::remove(aside / FolderLock::kFile);  // the lock went along
  notes << "results of " << (mismatch.suite ? "another version of this suite" : "another build")
        << " moved to " << aside.string() << "\n";
}

// Of writers that were killed.
void remove_leftovers(const fs::path& folder) {
  for (const auto& entry : fs::directory_iterator(folder)) {
    std::string name = entry.path().filename().string();
    if (name.ends_with("-journal")) name.resize(name.size() - std::strlen("-journal"));
    const auto end = name.find_last_not_of("0123456789");
    if (end != std::string::npos && name.substr(0, end + 1).ends_with(".part") &&
        entry.is_regular_file())
      fs::remove(entry.path());
  }
}

// How long the holder of a shard's folder is waited for. Slurm kills what does not end 30 s after
// SIGTERM.
constexpr std::chrono::seconds kShardPatience{60};

std::string this_build() { return program_id() + " " + version_line(); }

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

// This build among those that a store says its rows come from.
std::string builds_with_this(const ResultStore& store) {
  std::string text = store.meta("builds").value_or("");
  for (const std::string& line : lines_of(text))
    if (line == this_build()) return text;
  return text + this_build() + "\n";
}

ResultStore::Meta meta_of(const SuiteSource& source, const SuiteConfig& suite) {
  const std::string data = DataLocation::find(source.data_argument).folder;
  ResultStore::Meta meta{{"suite_identity", suite_identity(suite)},
                         {"program_sha256", program_id()},
                         {"builds", this_build() + "\n"},
                         {"suite_file", fs::absolute(source.file).lexically_normal().string()},
                         {"suite_text", source.text},
                         {"data", data.empty() ? "" : fs::absolute(data).string()},
                         {"seed", source.seed},
                         {"repetitions", std::to_string(suite.repetitions)}};
  if (!source.set.empty()) meta["set"] = nlohmann::json(source.set).dump();
  if (!suite.sweep.empty()) meta["sweep"] = axis_columns_json(columns_of(suite.sweep));
  return meta;
}

std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

// Of the program that flew a run; empty if its manifest does not say.
std::string commit_in(const std::string& manifest) {
  const auto json = nlohmann::json::parse(manifest, nullptr, false);
  const auto pointer = nlohmann::json::json_pointer("/program/commit");
  return json.is_object() && json.contains(pointer) && json[pointer].is_string()
             ? json[pointer].get<std::string>()
             : "";
}

}  // namespace

OutputFolder OutputFolder::prepare(const Place& place, const SuiteSource& source,
                                   const SuiteConfig& suite, std::ostream& notes) {
  if (fs::exists(place.folder) && !fs::is_directory(place.folder))
    throw std::invalid_argument(place.folder.string() + ": is no folder");
  ResultStore::Meta meta = meta_of(source, suite);
  while (true) {
    fs::create_directories(place.folder);
    FolderLock lock(place.folder, place.shard ? kShardPatience : std::chrono::seconds{});
    remove_leftovers(place.folder);
    ResultStore store = ResultStore::create(place.folder / kDatabase, meta);
    const Mismatch mismatch = compare(store, meta);
    if (may_continue(place, mismatch, notes)) {
      meta["builds"] = builds_with_this(store);
      for (const char* key : {"set", "sweep"})  // of a run before, which this one does not have
        if (store.meta(key)) meta.try_emplace(key, "[]");
      store.set_meta(meta);
      store.keep_files(source.files);
      return {place.folder, std::move(lock), std::move(store)};
    }
    move_aside(place.folder, mismatch, notes);
  }
}

OutputFolder OutputFolder::open(const fs::path& folder) {
  if (!fs::exists(folder / kDatabase))
    throw std::invalid_argument(folder.string() + ": no results here (no " + kDatabase + ")");
  return {folder, std::nullopt, ResultStore::open(folder / kDatabase)};
}

SuiteSource OutputFolder::source() const {
  const auto meta = [&](const char* key) { return store_.meta(key).value_or(""); };
  SuiteSource source{meta("suite_file"), meta("suite_text"),  meta("data"),
                     meta("seed"),       meta("repetitions"), store_.kept_files()};
  if (const auto set = store_.meta("set"))
    source.set = nlohmann::json::parse(*set).get<std::vector<std::string>>();
  return source;
}

Summary OutputFolder::summary() const {
  SummaryTable table;
  store_.for_each_record([&](const RunRecord& record) { table.add(record); });
  return table.summarise();
}

std::string OutputFolder::note_on_repetitions() const {
  const std::string asked = store_.meta("repetitions").value_or("");
  if (asked.empty()) return {};
  std::size_t beyond = 0;
  std::int64_t most = 0;
  store_.for_each_record([&, limit = std::stoll(asked)](const RunRecord& record) {
    most = std::max(most, record.repetition + 1);
    beyond += record.repetition >= limit ? 1 : 0;
  });
  if (beyond == 0) return {};
  return "all " + std::to_string(store_.size()) + " stored trials are shown, " +
         std::to_string(beyond) + " of them beyond the " + asked + " repetitions asked for last (" +
         std::to_string(most) + " are stored)\n";
}

std::vector<std::string> OutputFolder::builds() const {
  return lines_of(store_.meta("builds").value_or(""));
}

std::string OutputFolder::note_on_builds() const {
  const auto all = builds();
  if (all.size() < 2) return {};
  std::string text = "rows of " + std::to_string(all.size()) + " builds are in one table:";
  for (const std::string& build : all)
    text += (&build == &all.front() ? " " : ", ") + build.substr(build.find(' ') + 1) +
            " with SHA-256 " + build.substr(0, 12);
  return text + "\n";
}

std::string OutputFolder::complete_id(const std::string& beginning) const {
  std::vector<std::string> found;
  for (const std::string& id : store_.trial_ids())
    if (id.starts_with(beginning)) found.push_back(id);
  if (found.size() == 1) return found.front();
  throw std::invalid_argument(
      folder_.string() + ": " +
      (found.empty() ? "no trial " : std::to_string(found.size()) + " trials begin with ") +
      in_quotes(beginning));
}

void OutputFolder::write_manifest(const std::string& json) const {
  write_file_atomically(file("manifest.json"), json);
}

void OutputFolder::write_csv() const {
  write_file_atomically(file("results.csv"), [&](std::ostream& out) { write_csv_of(store_, out); });
}

void OutputFolder::write_report(const fs::path& file, ReportBeside beside) const {
  std::string suite = "empty";
  store_.for_each_record([&](const RunRecord& first) { suite = first.suite; }, "trial_id LIMIT 1");
  std::string manifest = text_of(this->file("manifest.json"));
  if (const std::string note = note_on_builds(); !note.empty()) {
    auto json = nlohmann::ordered_json::parse(manifest, nullptr, false);
    if (!json.is_object()) json = nlohmann::ordered_json::object();
    json["mixed_builds"] = std::to_string(builds().size());
    json["mixed_builds_are"] = builds();
    manifest = json.dump();
  }
  ReportInput input = read_report_input(store_, suite, std::move(manifest));
  input.folder = folder_.string();
  input.comparison = std::move(beside.comparison);
  input.published = std::move(beside.published);
  input.mapping_json = std::move(beside.mapping_json);
  write_html_report(input, file);
}

namespace {

std::set<std::string> names_in(const ResultStore& store, std::string RunRecord::*member) {
  std::set<std::string> names;
  store.for_each_record([&](const RunRecord& record) { names.insert(record.*member); });
  return names;
}

// "scenarios 'a', 'b' and 7 more": the first few.
std::string listed(const std::set<std::string>& names) {
  constexpr std::size_t kListed = 3;
  std::string text;
  std::size_t count = 0;
  for (const std::string& name : names)
    if (count++ < kListed) text.append(text.empty() ? "" : ", ").append(in_quotes(name));
  return names.size() <= kListed
             ? text
             : text + " and " + std::to_string(names.size() - kListed) + " more";
}

// Of runs that share no trial.
std::string what_does_not_match(const ResultStore& now, const ResultStore& before) {
  struct Part {
    const char* plural;
    std::string RunRecord::*member;
  };
  for (const Part& part :
       {Part{"scenarios", &RunRecord::scenario}, Part{"vehicles", &RunRecord::vehicle},
        Part{"regulators", &RunRecord::regulator}, Part{"planners", &RunRecord::planner}}) {
    const auto here = names_in(now, part.member);
    const auto there = names_in(before, part.member);
    if (std::none_of(here.begin(), here.end(), [&](const auto& n) { return there.contains(n); }))
      return std::string("no ") + part.plural + " in common: " + listed(here) + " here, " +
             listed(there) + " there";
  }
  return "no trial has the same scenario, vehicle, regulator, planner and repetition";
}

}  // namespace

RunComparison OutputFolder::compare_with(const OutputFolder& before,
                                         const ComparisonConfig& config) const {
  const std::string refusal =
      folder_.string() + ": not to be compared with " + before.folder_.string() + ": ";
  ComparisonConfig with_flights = config;
  const SameFlight alike = config.same_flight ? config.same_flight : same_flight;
  with_flights.same_flight = [&](const RunRecord& one, const RunRecord& other) {
    if (!one.world_id.empty() && !other.world_id.empty() && one.world_id != other.world_id)
      throw std::invalid_argument(refusal + "scenario " + in_quotes(other.scenario) +
                                  ", repetition " + std::to_string(other.repetition) +
                                  ", has another world");
    return alike(one, other);
  };
  RunComparison comparison = compare_runs(store_.records_in(kPairingOrder),
                                          before.store_.records_in(kPairingOrder), with_flights);
  if (comparison.pairs == 0)
    throw std::invalid_argument(refusal + what_does_not_match(store_, before.store_));
  comparison.title = before.folder_.string();
  comparison.commit = commit_in(text_of(before.file("manifest.json")));
  return comparison;
}

}  // namespace voronaut
