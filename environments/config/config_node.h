#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "voronaut/environments/config/config_error.h"

namespace voronaut {

struct ConfigOrigin;
struct ConfigTree;

// One value of a YAML file that knows its file, line and path ("world.circles[2]"). Every getter
// throws ConfigError with the place, what is allowed and what is there. Cheap to copy; the file's
// tree stays alive as long as one of its nodes. Nothing is converted behind the user's back: text
// in quotes is no number, "yes" is no flag, NaN and infinities are no numbers.
class ConfigNode {
 public:
  static constexpr double kUnbounded = std::numeric_limits<double>::infinity();

  // The root of a file, which must be a map of keys. Also throws for what is missing, unreadable,
  // empty, not text, not YAML, or gives a key twice.
  static ConfigNode read_file(const std::string& path);
  // The same for a text in memory; `file` is what messages call it.
  static ConfigNode parse(const std::string& text, const std::string& file);

  const std::string& file() const;
  int line() const { return line_; }
  const std::string& path() const { return path_; }  // from the root, empty for the root itself
  std::string place() const;                         // "file:line", or what stands in no file
  // A file name as it is meant here: relative to the folder of this file.
  std::string beside(const std::string& relative) const;

  bool is_map() const;
  bool is_list() const;
  bool is_scalar() const;

  double number(double lo = -kUnbounded, double hi = kUnbounded) const;  // inclusive bounds
  std::int64_t whole_number(std::int64_t lo, std::int64_t hi) const;     // inclusive bounds
  bool flag() const;
  std::string text() const;
  // One of these names; its index.
  std::size_t choice(const std::vector<std::string>& names) const;

  std::vector<ConfigNode> items() const;  // of a list
  // Of a list of so many; `form` says what is expected, like "[x, y]".
  std::vector<ConfigNode> items(std::size_t exactly, std::string_view form) const;
  // The same of numbers within inclusive bounds.
  std::vector<double> numbers(std::size_t exactly, std::string_view form, double lo = -kUnbounded,
                              double hi = kUnbounded) const;
  std::vector<std::string> texts() const;  // of a list of texts

  // Of a map: its keys in the order of the file, a value that may be missing, one that must be
  // there.
  std::vector<std::string> keys() const;
  std::optional<ConfigNode> find(std::string_view key) const;
  ConfigNode child(std::string_view key) const;
  // Refuses a key that is not among these, naming the nearest one, or what an old one is called now
  // (renamed_keys.h). Call it before the getters, so that a misspelt key is called unknown instead
  // of the right one missing.
  void allow_only(const std::vector<std::string>& allowed) const;

  // For a problem that only the caller can see: throw node.error("lies outside the bounds").
  ConfigError error(std::string_view problem) const;

  std::string yaml() const;  // in one line; names of files in it stay as they are

  // Copies with a change (config_edit.cpp). What is put in keeps its own file and line, so that
  // messages name the place where it was written.
  // A value that stands in no file: YAML, called so by messages, files beside this one's.
  ConfigNode value(const std::string& text, const std::string& called) const;
  ConfigNode with(std::string_view key, const ConfigNode& value) const;  // of a map
  ConfigNode without(std::string_view key) const;                        // of a map
  ConfigNode under(std::string_view key) const;                          // a map of this alone
  ConfigNode with_items(const std::vector<ConfigNode>& items) const;     // of a list
  // This where it says something, else `base`: maps are joined key by key, all else is replaced.
  ConfigNode over(const ConfigNode& base) const;

 private:
  using Tree = std::shared_ptr<const ConfigTree>;
  using Origin = std::shared_ptr<const ConfigOrigin>;

  ConfigNode(Tree tree, Origin origin, std::string path, int line)
      : tree_(std::move(tree)), origin_(std::move(origin)), path_(std::move(path)), line_(line) {}

  ConfigNode below(const Tree& tree, std::string path, int line) const;
  Tree placed() const;  // its tree, which says itself where it comes from
  ConfigError expected(const std::string& what) const;
  const std::string* plain_scalar() const;
  std::string path_of(std::string_view key) const;

  Tree tree_;
  Origin origin_;
  std::string path_;
  int line_ = 0;
};

// The bytes of a file. Throws ConfigError if it is missing, no file but a folder, a pipe or a
// device, too large (input_file.h), unreadable or not UTF-8 text.
std::string read_text_file(const std::string& path);
// The same of any bytes.
std::string read_bytes(const std::string& path);
// A finite number as YAML and our CSV files may write it; nothing else around it.
std::optional<double> parse_number(std::string_view text);
std::optional<std::int64_t> parse_whole(std::string_view text);
// The shortest decimal that reads back as the same double, without an exponent from 1e-4 to 1e15;
// -0 is 0.
std::string number_text(double value);

}  // namespace voronaut
