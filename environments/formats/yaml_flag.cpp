#include "voronaut/environments/formats/yaml_flag.h"

#include <algorithm>
#include <array>
#include <cctype>

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

}  // namespace voronaut
