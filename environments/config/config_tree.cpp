#include "voronaut/environments/config/config_tree.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <sstream>
#include <string_view>
#include <utility>

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include "voronaut/environments/config/config_error.h"
#include "voronaut/environments/config/nearest_name.h"

namespace voronaut {
namespace {

// A text that ends within an item is said to be wrong in the line behind it.
int lines_of(std::string_view text) {
  const auto ends = std::count(text.begin(), text.end(), '\n');
  return static_cast<int>(ends) + (text.empty() || text.back() != '\n' ? 1 : 0);
}

int line_of(const YAML::Mark& mark) { return mark.is_null() ? 0 : mark.line + 1; }

class TreeBuilder : public YAML::EventHandler {
 public:
  explicit TreeBuilder(const std::string& file) : file_(file) {}

  std::shared_ptr<const ConfigTree> root() const { return root_; }

  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}

  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    add(make(mark, anchor, ConfigTree::Kind::nothing));
  }

  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    const auto node = make(mark, anchor, ConfigTree::Kind::scalar);
    node->scalar = value;
    node->quoted = tag == "!";
    add(node);
  }

  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    const auto node = anchors_.at(anchor);
    for (const Open& open : open_)
      if (open.node == node) throw ConfigError(file_, line_of(mark), "", "an anchor holds itself");
    add(node);
  }

  void OnSequenceStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    open(make(mark, anchor, ConfigTree::Kind::list));
  }
  void OnSequenceEnd() override { close(); }

  void OnMapStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    open(make(mark, anchor, ConfigTree::Kind::map));
  }
  void OnMapEnd() override { close(); }

 private:
  using Node = std::shared_ptr<ConfigTree>;

  struct Open {
    Node node;
    bool has_key = false;  // maps: the last entry waits for its value
    std::map<std::string, int, std::less<>> line_of_key;
  };

  Node make(const YAML::Mark& mark, YAML::anchor_t anchor, ConfigTree::Kind kind) {
    auto node = std::make_shared<ConfigTree>();
    node->kind = kind;
    node->line = line_of(mark);
    if (anchor != YAML::NullAnchor) anchors_[anchor] = node;
    return node;
  }

  void open(const Node& node) { open_.push_back({node, false, {}}); }

  void close() {
    const Node node = open_.back().node;
    open_.pop_back();
    add(node);
  }

  void add(const Node& node) {
    if (open_.empty()) {
      root_ = node;
      return;
    }
    Open& parent = open_.back();
    if (parent.node->kind == ConfigTree::Kind::list) {
      parent.node->items.push_back(node);
    } else if (parent.has_key) {
      parent.node->entries.back().value = node;
      parent.has_key = false;
    } else {
      add_key(parent, *node);
    }
  }

  void add_key(Open& map, const ConfigTree& key) {
    if (key.kind != ConfigTree::Kind::scalar)
      throw ConfigError(file_, key.line, "", "a key must be text");
    const auto [first, is_new] = map.line_of_key.emplace(key.scalar, key.line);
    if (!is_new)
      throw ConfigError(file_, key.line, "",
                        "key " + in_quotes(key.scalar) + ": given twice (first in line " +
                            std::to_string(first->second) + ")");
    map.node->entries.push_back({key.scalar, key.line, nullptr});
    map.has_key = true;
  }

  const std::string& file_;
  Node root_;
  std::vector<Open> open_;
  std::map<YAML::anchor_t, Node> anchors_;
};

// Bytes that a UTF-8 sequence with this first byte has; 0 if none starts so.
std::size_t sequence_length(unsigned char first) {
  if (first < 0x80) return 1;
  if (first >= 0xc2 && first < 0xe0) return 2;
  if (first >= 0xe0 && first < 0xf0) return 3;
  if (first >= 0xf0 && first < 0xf5) return 4;
  return 0;
}

}  // namespace

// yaml-cpp reads any bytes and fails, if at all, somewhere behind them.
void require_utf8(std::string_view text, const std::string& file) {
  int line = 1;
  for (std::size_t i = 0; i < text.size();) {
    const auto first = static_cast<unsigned char>(text[i]);
    std::size_t length = sequence_length(first);
    if (length > text.size() - i) length = 0;
    for (std::size_t k = 1; k < length; ++k)
      if ((static_cast<unsigned char>(text[i + k]) & 0xc0) != 0x80) length = 0;
    const bool control = first < 0x20 && first != '\n' && first != '\t' && first != '\r';
    if (length == 0 || control)
      throw ConfigError(file, line, "", "not a text file (byte " + std::to_string(i) + ")");
    if (first == '\n') ++line;
    i += length;
  }
}

std::shared_ptr<const ConfigTree> parse_yaml(const std::string& text, const std::string& file) {
  require_utf8(text, file);
  std::istringstream stream(text);
  TreeBuilder builder(file);
  try {
    YAML::Parser parser(stream);
    if (!parser.HandleNextDocument(builder) || !builder.root() ||
        builder.root()->kind == ConfigTree::Kind::nothing)
      throw ConfigError(file, 1, "", "the file is empty");
    auto root = builder.root();
    TreeBuilder second(file);
    if (parser.HandleNextDocument(second))
      throw ConfigError(file, second.root() ? second.root()->line : 0, "",
                        "a second document; expected one");
    return root;
  } catch (const YAML::Exception& error) {
    const bool is_json = file.ends_with(".json");  // which YAML is a superset of
    throw ConfigError(file, std::min(line_of(error.mark), lines_of(text)), "",
                      (is_json ? "not valid JSON: " : "not valid YAML: ") + error.msg);
  }
}

}  // namespace voronaut
