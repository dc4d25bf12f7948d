#pragma once

#include <optional>
#include <string>
#include <vector>

#include "voronaut/environments/config/config_node.h"
#include "voronaut/environments/formats/foreign_world.h"

// The catalogue of foreign formats: what can be drawn by `voronaut show` and named as `world_file`
// in a scenario. docs/formats.md says what is read of each and what is ignored.
namespace voronaut {

// What a file's format is recognised by.
struct FileLook {
  std::string ending;              // ".map"
  std::string text;                // or any bytes, without a byte order mark
  std::optional<ConfigNode> yaml;  // of a .yaml or .yml
};

struct ForeignFormat {
  std::string name;
  std::string summary;
  // Whether a file that looks so is one of them.
  bool (*recognises)(const FileLook& file);
  std::vector<std::string> options;  // keys of ForeignOptions that it uses
  ForeignOptions defaults;           // of a file that no scenario names
  // Throws ConfigError.
  ForeignWorld (*read)(const std::string& path, const ForeignOptions& options);
};

const std::vector<ForeignFormat>& foreign_formats();
std::vector<std::string> foreign_format_names();

// The format with that name, or, if the name is empty, the one that recognises the file. Throws
// ConfigError that names the formats there are, and for a .yaml that is no YAML.
const ForeignFormat& foreign_format(const std::string& name, const std::string& path);

// Whether a file is to be read as one of them: it is recognised, or has not the ending of ours,
// .yaml. Throws ConfigError for a .yaml that is no YAML.
bool is_foreign_file(const std::string& path);

// The queries of a file for the world that was read from `world_path`: MovingAI's .scen, OMPL's
// circle_queries.txt, or a table
// with the columns start_x, start_y, goal_x, goal_y in m; if it has a column `map`, those of the
// rows that name the world's file without its ending, or its folder. Throws ConfigError.
std::vector<ForeignQuery> read_queries(const std::string& path, const std::string& world_path,
                                       const ForeignWorld& world);

}  // namespace voronaut
