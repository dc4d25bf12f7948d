#pragma once

#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "voronaut/benchmarks/results/folder_lock.h"
#include "voronaut/benchmarks/results/manifest.h"
#include "voronaut/reports/store/store.h"
#include "voronaut/reports/summary/comparison.h"
#include "voronaut/reports/summary/published_results.h"

namespace voronaut {

// What a report shows beside the run itself.
struct ReportBeside {
  std::optional<RunComparison> comparison;  // against another run
  std::optional<BarnComparison> published;  // beside what others published
  std::string mapping_json;                 // mapping_data_json(); empty: none
};

// A folder of results: results.db, results.csv, report.html, manifest.json. The database holds
// copies of the scenario and world files too, so the folder is whole without them.
class OutputFolder {
 public:
  // Where the results of a run go.
  struct Place {
    std::filesystem::path folder;
    bool chosen = false;  // named by the user; else it is the suite's own default
    bool shard = false;   // of a run: nothing is moved aside, no other build goes on in it
  };

  // Makes the folder or continues the one that is there, also one that was killed, or ran out of
  // disk, while it was made. It is locked as long as the object lives; std::invalid_argument says
  // who else holds it. Leftover temporary files (*.part) are deleted. Results of another version of
  // the suite are an error (std::invalid_argument) in a folder that the user chose and are moved
  // aside in the default one; so are those of another program in the default one, in a chosen one
  // they are continued with a note. In the folder of a shard both are errors, and a holder is
  // waited for a while: it may be the copy of this shard that an engine is just ending. Notes are
  // lines on `notes`.
  static OutputFolder prepare(const Place& place, const SuiteSource& source,
                              const SuiteConfig& suite, std::ostream& notes);
  // One that is there. Throws std::invalid_argument, StoreError.
  static OutputFolder open(const std::filesystem::path& folder);

  ResultStore& store() { return store_; }
  const ResultStore& store() const { return store_; }
  SuiteSource source() const;  // what its trials are made of
  Summary summary() const;     // of all its trials
  // What a summary of all records shows if the last run asked for fewer repetitions than are
  // stored, as a line; else empty.
  std::string note_on_repetitions() const;
  // A line if rows of several builds are in it; else empty.
  std::string note_on_builds() const;
  // The builds that its rows come from, "SHA-256 of the program, blank, version".
  std::vector<std::string> builds() const;
  // The one trial id that begins so. Throws std::invalid_argument if none or several do.
  std::string complete_id(const std::string& beginning) const;

  const std::filesystem::path& path() const { return folder_; }
  std::filesystem::path file(const std::string& name) const { return folder_ / name; }

  void write_manifest(const std::string& json) const;
  void write_csv() const;
  // The HTML report, by default as report.html in the folder.
  void write_report() const { write_report(file("report.html"), {}); }
  void write_report(const std::filesystem::path& file, ReportBeside beside) const;
  // What this run says against another one. Throws std::invalid_argument saying what does not match
  // where no trial has a partner, or one's partner met another world.
  RunComparison compare_with(const OutputFolder& before, const ComparisonConfig& config = {}) const;

 private:
  OutputFolder(std::filesystem::path folder, std::optional<FolderLock> lock, ResultStore store)
      : folder_(std::move(folder)), lock_(std::move(lock)), store_(std::move(store)) {}

  std::filesystem::path folder_;
  std::optional<FolderLock> lock_;  // of the run that writes it
  ResultStore store_;
};

}  // namespace voronaut
