#include "voronaut/benchmarks/results/output_folder.h"

#include <fstream>
#include <ostream>
#include <sstream>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "voronaut/benchmarks/results/build_info.h"
#include "voronaut/environments/config/nearest_name.h"
#include "voronaut/environments/scenario/scenario_spec.h"
#include "voronaut/reports/page/html_report.h"
#include "voronaut/reports/store/atomic_file.h"
#include "voronaut/reports/store/csv_writer.h"

namespace voronaut {

namespace fs = std::filesystem;

namespace {

constexpr const char* kDatabase = "results.db";

// Why what lies in the folder does not belong to this run; empty if it does.
struct Mismatch {
  bool suite = false;
  bool program = false;
};

Mismatch compare(const fs::path& database, const std::string& identity) {
  const ResultStore stored = ResultStore::open(database);
  return {stored.meta("suite_identity") != identity, stored.meta("program_sha256") != program_id()};
}

fs::path free_name(const fs::path& folder) {
  for (int i = 1;; ++i) {
    fs::path candidate = folder;
    candidate += "." + std::to_string(i);
    if (!fs::exists(candidate)) return candidate;
  }
}

void settle_mismatch(const OutputFolder::Place& place, const Mismatch& mismatch,
                     std::ostream& notes) {
  if (!mismatch.suite && !mismatch.program) return;
  const std::string what = mismatch.suite ? "another version of this suite" : "another build";
  if (!place.chosen) {
    const fs::path aside = free_name(place.folder);
    fs::rename(place.folder, aside);
    notes << "results of " << what << " moved to " << aside.string() << "\n";
  } else if (mismatch.suite) {
    throw std::invalid_argument(place.folder.string() + ": holds results of " + what +
                                "; give another --out or remove it");
  } else {
    notes << place.folder.string() << ": holds results of " << what << ", which are kept\n";
  }
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
  const std::string identity = suite_identity(suite);
  const fs::path database = place.folder / kDatabase;
  if (fs::exists(place.folder) && !fs::is_directory(place.folder))
    throw std::invalid_argument(place.folder.string() + ": is no folder");
  if (fs::exists(database)) settle_mismatch(place, compare(database, identity), notes);
  fs::create_directories(place.folder);
  OutputFolder folder(place.folder, ResultStore::create(database));
  folder.store_.set_meta("suite_identity", identity);
  folder.store_.set_meta("program_sha256", program_id());
  folder.store_.set_meta("suite_file", fs::absolute(source.file).lexically_normal().string());
  folder.store_.set_meta("suite_text", source.text);
  const std::string data = DataLocation::find(source.data_argument).folder;
  folder.store_.set_meta("data", data.empty() ? "" : fs::absolute(data).string());
  folder.store_.set_meta("seed", source.seed);
  folder.store_.set_meta("repetitions", std::to_string(suite.repetitions));
  return folder;
}

OutputFolder OutputFolder::open(const fs::path& folder) {
  if (!fs::exists(folder / kDatabase))
    throw std::invalid_argument(folder.string() + ": no results here (no " + kDatabase + ")");
  return {folder, ResultStore::open(folder / kDatabase)};
}

SuiteSource OutputFolder::source() const {
  const auto meta = [&](const char* key) { return store_.meta(key).value_or(""); };
  return {meta("suite_file"), meta("suite_text"), meta("data"), meta("seed"), meta("repetitions")};
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
  write_file_atomically(file("results.csv"), records_to_csv(store_.records()));
}

void OutputFolder::write_report(const fs::path& file, std::optional<RunComparison> comparison,
                                const std::string& mapping_json) const {
  const std::string suite = store_.records().empty() ? "empty" : store_.records().front().suite;
  ReportInput input = read_report_input(store_, suite, text_of(this->file("manifest.json")));
  input.folder = folder_.string();
  input.comparison = std::move(comparison);
  input.mapping_json = mapping_json;
  write_html_report(input, file);
}

RunComparison OutputFolder::compare_with(const OutputFolder& before) const {
  RunComparison comparison = compare_runs(store_.records(), before.store_.records());
  comparison.title = before.folder_.string();
  comparison.commit = commit_in(text_of(before.file("manifest.json")));
  return comparison;
}

}  // namespace voronaut
