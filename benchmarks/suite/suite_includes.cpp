#include "voronaut/benchmarks/suite/suite_includes.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "voronaut/environments/scenario_files/scenario_fields.h"

namespace voronaut {

namespace {

std::string place_of(const std::string& file) {
  return std::filesystem::absolute(file).lexically_normal().string();
}

// `open` are the files that are being read, by their places, each included by the one before.
ConfigNode joined_with_includes(const ConfigNode& root, std::vector<std::string>& open);

ConfigNode included(const ConfigNode& name, std::vector<std::string>& open) {
  const std::string file = name.beside(name.text());
  const std::string place = place_of(file);
  if (std::find(open.begin(), open.end(), place) != open.end()) {
    std::string chain;
    for (const std::string& each : open)
      chain += std::filesystem::path(each).filename().string() + " -> ";
    throw name.error("files include each other: " + chain +
                     std::filesystem::path(place).filename().string());
  }
  open.push_back(place);
  const ConfigNode root = joined_with_includes(ConfigNode::read_file(existing_file(name)), open);
  open.pop_back();
  return root;
}

ConfigNode joined_with_includes(const ConfigNode& root, std::vector<std::string>& open) {
  const auto include = root.find("include");
  if (!include) return root;
  std::optional<ConfigNode> base;
  for (const ConfigNode& name : include->is_list() ? include->items() : std::vector{*include}) {
    const ConfigNode file = included(name, open);
    base = base ? file.over(*base) : file;
  }
  const ConfigNode own = root.without("include");
  return base ? own.over(*base) : own;
}

}  // namespace

ConfigNode with_includes(const ConfigNode& root) {
  std::vector<std::string> open = {place_of(root.file())};
  return joined_with_includes(root, open);
}

}  // namespace voronaut
