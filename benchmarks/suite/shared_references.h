#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <utility>

#include "voronaut/benchmarks/suite/shortest_references.h"

namespace voronaut {

// Lengths of shortest paths that the shards of a run share, so that not each of them measures every
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

 private:
  using WorldAndRadius = std::pair<std::string, std::string>;

  double length_m(const Scenario& scenario, double radius_m,
                  const ShortestReferences::Length& length);
  void read_what_is_new();
  void append(const WorldAndRadius& key, double length_m);

  std::filesystem::path own_folder_;
  std::string file_name_;
  std::map<WorldAndRadius, double> known_;
  std::map<std::filesystem::path, std::size_t> read_bytes_;  // of each file
};

}  // namespace voronaut
