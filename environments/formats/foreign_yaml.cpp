#include "voronaut/environments/formats/foreign_yaml.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "voronaut/environments/config/nearest_name.h"

namespace voronaut {

bool read_yaml_flag(const ConfigNode& node) {
  constexpr std::array kTrue = {"true", "yes", "on"};
  constexpr std::array kFalse = {"false", "no", "off"};
  std::string text = node.is_scalar() ? node.text() : "";
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (std::find(kTrue.begin(), kTrue.end(), text) != kTrue.end()) return true;
  if (std::find(kFalse.begin(), kFalse.end(), text) != kFalse.end()) return false;
  return node.flag();
}

std::optional<ConfigNode> find_given(const ConfigNode& map, std::string_view key) {
  const auto found = map.find(key);
  const bool given = found && (found->is_map() || found->is_list() || found->is_scalar());
  return given ? found : std::nullopt;
}

void refuse_misspelt(const ConfigNode& map, const std::vector<std::string>& known) {
  for (const std::string& key : map.keys())
    if (std::find(known.begin(), known.end(), key) == known.end() && nearest_name(key, known))
      throw map.child(key).error("unknown key" + allowed_names(key, known));
}

}  // namespace voronaut
