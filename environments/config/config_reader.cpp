#include "voronaut/environments/config/config_reader.h"

namespace voronaut {

std::string canonical_text(const ConfigEntries& entries) {
  std::string text;
  for (const auto& [key, value] : entries) {
    text.append(key).append("=");
    for (const char c : value) {
      if (c == '\\' || c == '=' || c == ';') text += '\\';
      text += c;
    }
    text += ';';
  }
  return text;
}

}  // namespace voronaut
