#include "voronaut/benchmarks/suite/suite_includes.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "voronaut/benchmarks/suite/suite_paths.h"
#include "voronaut/environments/config/key_visitor.h"
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

// A preset says all keys of its section: below it nothing of the base is left. Over a preset of the
// base single keys hold.
ConfigNode over(const ConfigNode& top, ConfigNode base) {
  for (const std::string& key : top.keys()) {
    const auto below = base.find(key);
    if (!below || !has_presets(key)) continue;
    const ConfigNode section = top.child(key);
    if (section.is_scalar() || (section.is_map() && section.find(kPresetKey)))
      base = base.without(key);
    else if (below->is_scalar())
      base = base.with(key, below->under(kPresetKey));
  }
  return top.over(base);
}

ConfigNode joined_with_includes(const ConfigNode& root, std::vector<std::string>& open) {
  const auto include = root.find("include");
  if (!include) return root;
  std::optional<ConfigNode> base;
  for (const ConfigNode& name : include->is_list() ? include->items() : std::vector{*include}) {
    const ConfigNode file = included(name, open);
    base = base ? over(file, *base) : file;
  }
  const ConfigNode own = root.without("include");
  return base ? over(own, *base) : own;
}

}  // namespace

ConfigNode with_includes(const ConfigNode& root) {
  std::vector<std::string> open = {place_of(root.file())};
  return joined_with_includes(root, open);
}

}  // namespace voronaut
