#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

// A YAML document as a plain tree with line numbers: what ConfigNode walks over. Not for others.
namespace voronaut {

// A text that values come from.
struct ConfigOrigin {
  std::string called;  // by messages: a file, or what the command line said
  std::string file;    // names of files in it are relative to this one's folder
  bool has_lines = true;
};

struct ConfigTree {
  enum class Kind { nothing, scalar, list, map };

  struct Entry {
    std::string key;
    int line = 0;  // of the key
    std::shared_ptr<const ConfigTree> value;
  };

  Kind kind = Kind::nothing;
  int line = 1;
  std::shared_ptr<const ConfigOrigin> origin;  // null: that of what it stands in
  std::string scalar;
  bool quoted = false;  // scalar in quotes: always text, never a number
  std::vector<std::shared_ptr<const ConfigTree>> items;
  std::vector<Entry> entries;  // in the order of the file
};

// One YAML document; anchors and aliases are resolved. Throws ConfigError with the place for what
// is not YAML, for a second document, for a key that is given twice or is not text, and for text
// that is not UTF-8. `file` is what messages call it.
std::shared_ptr<const ConfigTree> parse_yaml(const std::string& text, const std::string& file);

// Throws ConfigError at the first byte that does not belong to a UTF-8 text.
void require_utf8(std::string_view text, const std::string& file);

}  // namespace voronaut
