#include "voronaut/benchmarks/results/merge.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>
#include <stdexcept>

#include <nlohmann/json.hpp>
#include <unistd.h>

#include "voronaut/benchmarks/results/folder_lock.h"

namespace voronaut {

namespace {

namespace paths = std::filesystem;

constexpr const char* kResults = "results.db";

std::vector<paths::path> folders_of(const MergeOrder& order) {
  std::set<paths::path> found;
  for (const paths::path& folder : order.folders) {
    const auto of_it = folders_with_results(folder);
    if (of_it.empty())
      throw std::invalid_argument(folder.string() + ": no results here (no results.db, no shards)");
    for (const paths::path& one : of_it) found.insert(paths::canonical(one));
  }
  if (paths::exists(order.into / kResults)) found.insert(paths::canonical(order.into));
  return {found.begin(), found.end()};
}

// What the merged store says about itself. Throws where the folders do not go together.
ResultStore::Meta common_meta(const std::vector<paths::path>& folders, bool mixed_builds) {
  ResultStore::Meta meta;
  std::set<std::string> builds;
  long repetitions = 0;
  for (const paths::path& folder : folders) {
    const OutputFolder part = OutputFolder::open(folder);
    for (const char* key :
         {"suite_identity", "program_sha256", "suite_file", "suite_text", "data", "seed"})
      meta.emplace(key, part.store().meta(key).value_or(""));
    for (const char* key : {"set", "sweep"})
      if (const auto given = part.store().meta(key)) meta.emplace(key, *given);
    if (part.store().meta("suite_identity") != meta.at("suite_identity"))
      throw std::invalid_argument(folder.string() + ": holds results of another suite, or of " +
                                  "another version of it, than " + folders.front().string());
    repetitions =
        std::max(repetitions, std::stol("0" + part.store().meta("repetitions").value_or("")));
    const auto of_part = part.builds();
    builds.insert(of_part.begin(), of_part.end());
    if (builds.size() > 1 && !mixed_builds)
      throw std::invalid_argument(folder.string() + ": holds rows of another build than " +
                                  folders.front().string() +
                                  "; --mixed-builds takes them all, and the report says so");
  }
  meta["repetitions"] = std::to_string(repetitions);
  for (const std::string& build : builds) meta["builds"] += build + "\n";
  return meta;
}

// A database beside the one that it is to become; goes with this unless it was moved there.
class PartFile {
 public:
  explicit PartFile(const paths::path& folder)
      : file_(folder / (kResults + (".part" + std::to_string(getpid())))) {}
  PartFile(const PartFile&) = delete;
  PartFile& operator=(const PartFile&) = delete;
  ~PartFile() {
    std::error_code ignored;
    paths::remove(file_, ignored);
    paths::remove(file_.string() + "-journal", ignored);
  }
  const paths::path& path() const { return file_; }

 private:
  paths::path file_;
};

// A folder that is deleted again if nothing comes to stand in it.
class NewFolder {
 public:
  explicit NewFolder(const paths::path& folder) : folder_(folder) {
    made_ = paths::create_directories(folder);
  }
  NewFolder(const NewFolder&) = delete;
  NewFolder& operator=(const NewFolder&) = delete;
  ~NewFolder() {
    std::error_code ignored;
    if (made_) paths::remove(folder_, ignored);  // fails where something is in it
  }

 private:
  paths::path folder_;
  bool made_ = false;
};

nlohmann::ordered_json manifest_in(const paths::path& folder) {
  std::ifstream in(folder / "manifest.json", std::ios::binary);
  return nlohmann::ordered_json::parse(in, nullptr, false);
}

// That of the first part that has one, with what became of it.
std::string merged_manifest(const std::vector<paths::path>& folders, const MergeOrder& order) {
  auto manifest = nlohmann::ordered_json::object();
  auto parts = nlohmann::ordered_json::array();
  for (const paths::path& folder : folders) {
    const auto of_part = manifest_in(folder);
    if (of_part.is_object() && manifest.empty()) manifest = of_part;
    const auto host = nlohmann::ordered_json::json_pointer("/machine/host");
    parts.push_back({{"folder", folder.string()},
                     {"host", of_part.is_object() ? of_part.value(host, "") : ""}});
  }
  manifest.erase("shard");
  manifest["command"] = order.command_line;
  manifest["merged_from"] = parts;
  return manifest.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace

paths::path shards_in(const paths::path& run) { return run / "shards"; }

std::vector<paths::path> folders_with_results(const paths::path& run) {
  std::vector<paths::path> found;
  if (paths::exists(run / kResults)) found.push_back(run);
  if (paths::is_directory(shards_in(run)))
    for (const auto& shard : paths::directory_iterator(shards_in(run)))
      if (paths::exists(shard.path() / kResults)) found.push_back(shard.path());
  std::sort(found.begin(), found.end());
  return found;
}

OutputFolder merge_folders(const MergeOrder& order) {
  const auto folders = folders_of(order);
  const auto meta = common_meta(folders, order.mixed_builds);
  {
    const NewFolder made(order.into);
    const FolderLock lock(order.into);
    const PartFile part(order.into);
    {
      ResultStore store = ResultStore::create(part.path(), meta);
      for (const paths::path& folder : folders) store.take_in(folder / kResults);
    }
    paths::rename(part.path(), order.into / kResults);
    OutputFolder merged = OutputFolder::open(order.into);
    merged.write_manifest(merged_manifest(folders, order));
    merged.write_report();
    merged.write_csv();  // last: its presence says that all of it is there
  }
  return OutputFolder::open(order.into);
}

}  // namespace voronaut
