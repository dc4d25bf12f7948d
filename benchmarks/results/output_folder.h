#pragma once

#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "voronaut/benchmarks/results/manifest.h"
#include "voronaut/reports/store/store.h"
#include "voronaut/reports/summary/comparison.h"

namespace voronaut {

// A folder of results: results.db, results.csv, report.html, manifest.json.
class OutputFolder {
 public:
  // Where the results of a run go.
  struct Place {
    std::filesystem::path folder;
    bool chosen = false;  // named by the user; else it is the suite's own default
  };

  // Makes the folder or continues the one that is there. Results of another version of the suite
  // are an error (std::invalid_argument) in a folder that the user chose and are moved aside in the
  // default one; so are those of another program in the default one, in a chosen one they are
  // continued with a note. Notes are lines on `notes`.
  static OutputFolder prepare(const Place& place, const SuiteSource& source,
                              const SuiteConfig& suite, std::ostream& notes);
  // One that is there. Throws std::invalid_argument, StoreError.
  static OutputFolder open(const std::filesystem::path& folder);

  ResultStore& store() { return store_; }
  const ResultStore& store() const { return store_; }
  SuiteSource source() const;  // what its trials are made of
  // The one trial id that begins so. Throws std::invalid_argument if none or several do.
  std::string complete_id(const std::string& beginning) const;

  std::filesystem::path file(const std::string& name) const { return folder_ / name; }

  void write_manifest(const std::string& json) const;
  void write_csv() const;
  // The HTML report, by default as report.html in the folder.
  void write_report() const { write_report(file("report.html"), {}, {}); }
  void write_report(const std::filesystem::path& file, std::optional<RunComparison> comparison,
                    const std::string& mapping_json) const;
  // What this run says against another one.
  RunComparison compare_with(const OutputFolder& before) const;

 private:
  OutputFolder(std::filesystem::path folder, ResultStore store)
      : folder_(std::move(folder)), store_(std::move(store)) {}

  std::filesystem::path folder_;
  ResultStore store_;
};

}  // namespace voronaut
