#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <utility>

#include "voronaut/benchmarks/suite/shortest_references.h"

namespace voronaut {

// What the shards of a run compute of worlds and share, so that not each of them measures every
// world: a shard appends what it has computed to a file in its own folder and looks into the files
// of the others for what it lacks. Nobody waits for anybody and nothing is locked; two shards that
// come to a world at the same time both measure it, with the same result. Lines that were cut off
// are passed over.
class SharedReferences {
 public:
  // `own_folder` is the folder of the shard, beside those of the others. Files of different names
  // do not see each other: one name for each build.
  SharedReferences(std::filesystem::path own_folder, std::string file_name);

  // `length`, asked for what nobody has computed yet. Belongs to this object.
  ShortestReferences::Length sharing(ShortestReferences::Length length);
  ShortestReferences::Difficulty sharing(ShortestReferences::Difficulty difficulty);

 private:
  // The length for a radius as text, or what else it is.
  using WorldAndWhat = std::pair<std::string, std::string>;

  double length_m(const Scenario& scenario, double radius_m,
                  const ShortestReferences::Length& length);
  WorldDifficulty difficulty_of(const Scenario& scenario,
                                const ShortestReferences::Difficulty& difficulty);
  const double* find(const WorldAndWhat& key);
  void keep(const WorldAndWhat& key, double value);
  void read_what_is_new();

  std::filesystem::path own_folder_;
  std::string file_name_;
  std::map<WorldAndWhat, double> known_;
  std::map<std::filesystem::path, std::size_t> read_bytes_;  // of each file
};

}  // namespace voronaut
