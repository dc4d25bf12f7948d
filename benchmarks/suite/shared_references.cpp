#include "voronaut/benchmarks/suite/shared_references.h"

#include <charconv>
#include <fstream>
#include <sstream>

#include "voronaut/benchmarks/trial/trial_id.h"
#include "voronaut/reports/record_columns.h"

namespace voronaut {

namespace {

constexpr const char* kNoPath = "none";
constexpr const char* kEnd = "end";

// "world radius length end", or "world free_share 0.8 end"; one blank between: without the last
// word it was cut off.
std::string line_of(const std::string& world, const std::string& radius, double length_m) {
  const std::string length = cell_text(length_m);
  return world + " " + radius + " " + (length.empty() ? kNoPath : length) + " " + kEnd + "\n";
}

bool read_length(const std::string& text, double& length_m) {
  length_m = kAbsent;
  if (text == kNoPath) return true;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), length_m);
  return error == std::errc() && end == text.data() + text.size();
}

// From a byte on, whole lines only.
std::string lines_from(const std::filesystem::path& file, std::size_t begin) {
  std::ifstream in(file, std::ios::binary);
  in.seekg(static_cast<std::streamoff>(begin));
  std::ostringstream text;
  text << in.rdbuf();
  const std::string all = text.str();
  return all.substr(0, all.rfind('\n') + 1);
}

}  // namespace

SharedReferences::SharedReferences(std::filesystem::path own_folder, std::string file_name)
    : own_folder_(std::move(own_folder)), file_name_(std::move(file_name)) {}

ShortestReferences::Length SharedReferences::sharing(ShortestReferences::Length length) {
  return [this, length = std::move(length)](const Scenario& scenario, double radius_m) {
    return length_m(scenario, radius_m, length);
  };
}

ShortestReferences::Difficulty SharedReferences::sharing(
    ShortestReferences::Difficulty difficulty) {
  return [this, difficulty = std::move(difficulty)](const Scenario& scenario) {
    return difficulty_of(scenario, difficulty);
  };
}

double SharedReferences::length_m(const Scenario& scenario, double radius_m,
                                  const ShortestReferences::Length& length) {
  const WorldAndWhat key{world_id(scenario), cell_text(radius_m)};
  if (const double* known = find(key)) return *known;
  const double computed_m = length(scenario, radius_m);
  keep(key, computed_m);
  return computed_m;
}

WorldDifficulty SharedReferences::difficulty_of(const Scenario& scenario,
                                                const ShortestReferences::Difficulty& difficulty) {
  const WorldAndWhat share{world_id(scenario), "free_share"};
  const WorldAndWhat passage{share.first, "narrowest_passage_m"};
  const double* known_share = find(share);
  const double* known_passage = find(passage);
  if (known_share != nullptr && known_passage != nullptr) return {*known_share, *known_passage};
  const WorldDifficulty computed = difficulty(scenario);
  keep(share, computed.free_share);
  keep(passage, computed.narrowest_passage_m);
  return computed;
}

const double* SharedReferences::find(const WorldAndWhat& key) {
  if (!known_.contains(key)) read_what_is_new();
  const auto found = known_.find(key);
  return found != known_.end() ? &found->second : nullptr;
}

void SharedReferences::read_what_is_new() {
  std::error_code gone;  // a folder may be moved while it is looked at
  for (const auto& shard : std::filesystem::directory_iterator(own_folder_.parent_path(), gone)) {
    const std::filesystem::path file = shard.path() / file_name_;
    const auto size = std::filesystem::file_size(file, gone);
    std::size_t& read = read_bytes_[file];
    if (gone || size <= read) continue;
    const std::string text = lines_from(file, read);
    read += text.size();
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      std::istringstream words(line);
      std::string world, radius, length, end;
      double length_m = 0;
      if (words >> world >> radius >> length >> end && end == kEnd && read_length(length, length_m))
        known_[{world, radius}] = length_m;
    }
  }
}

void SharedReferences::keep(const WorldAndWhat& key, double value) {
  known_[key] = value;
  const std::filesystem::path file = own_folder_ / file_name_;
  std::ofstream out(file, std::ios::binary | std::ios::app);
  // The line before may have been cut off.
  out << "\n" + line_of(key.first, key.second, value) << std::flush;
}

}  // namespace voronaut
