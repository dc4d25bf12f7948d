#include <algorithm>

#include "voronaut/environments/config/config_node.h"
#include "voronaut/environments/config/config_tree.h"

namespace voronaut {
namespace {

using SharedTree = std::shared_ptr<const ConfigTree>;
using SharedOrigin = std::shared_ptr<const ConfigOrigin>;

SharedTree with_origin(const SharedTree& tree, const SharedOrigin& origin) {
  if (tree->origin) return tree;
  ConfigTree copy = *tree;
  copy.origin = origin;
  return std::make_shared<const ConfigTree>(std::move(copy));
}

ConfigTree::Entry* entry_of(ConfigTree& map, std::string_view key) {
  const auto found = std::find_if(map.entries.begin(), map.entries.end(),
                                  [&](const ConfigTree::Entry& entry) { return entry.key == key; });
  return found == map.entries.end() ? nullptr : &*found;
}

// Both say where they come from.
SharedTree joined(const SharedTree& top, const SharedTree& base) {
  if (top->kind != ConfigTree::Kind::map || base->kind != ConfigTree::Kind::map) return top;
  ConfigTree join = *top;
  for (const ConfigTree::Entry& below : base->entries) {
    const SharedTree value = with_origin(below.value, base->origin);
    if (ConfigTree::Entry* own = entry_of(join, below.key)) {
      own->value = joined(with_origin(own->value, top->origin), value);
    } else {
      join.entries.push_back({below.key, below.line, value});
    }
  }
  return std::make_shared<const ConfigTree>(std::move(join));
}

// Quoted so that it is read as text and nothing else.
std::string quoted(const std::string& text) {
  constexpr const char* kHex = "0123456789abcdef";
  std::string yaml = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') yaml += '\\';
    if (byte < 0x20 || byte == 0x7f)
      yaml.append("\\x").append(1, kHex[byte >> 4]).append(1, kHex[byte & 15]);
    else
      yaml += c;
  }
  return yaml + '"';
}

bool is_plain(const std::string& text) {
  return !text.empty() && text != "null" && text != "~" && text != "-" &&
         std::all_of(text.begin(), text.end(), [](char c) {
           return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                  c == '_' || c == '-' || c == '.' || c == '+';
         });
}

void write_yaml(const ConfigTree& tree, std::string& yaml) {
  if (tree.kind == ConfigTree::Kind::nothing) yaml += "~";
  if (tree.kind == ConfigTree::Kind::scalar)
    yaml += tree.quoted || !is_plain(tree.scalar) ? quoted(tree.scalar) : tree.scalar;
  if (tree.kind == ConfigTree::Kind::list) {
    yaml += "[";
    for (const SharedTree& item : tree.items) {
      if (&item != &tree.items.front()) yaml += ", ";
      write_yaml(*item, yaml);
    }
    yaml += "]";
  }
  if (tree.kind == ConfigTree::Kind::map) {
    yaml += "{";
    for (const ConfigTree::Entry& entry : tree.entries) {
      if (&entry != &tree.entries.front()) yaml += ", ";
      yaml.append(is_plain(entry.key) ? entry.key : quoted(entry.key)).append(": ");
      write_yaml(*entry.value, yaml);
    }
    yaml += "}";
  }
}

}  // namespace

std::string ConfigNode::yaml() const {
  std::string text;
  write_yaml(*tree_, text);
  return text;
}

ConfigNode::Tree ConfigNode::placed() const { return with_origin(tree_, origin_); }

ConfigNode ConfigNode::value(const std::string& text, const std::string& called) const {
  return {parse_yaml(text, called),
          std::make_shared<const ConfigOrigin>(ConfigOrigin{called, file(), false}), path_, 0};
}

ConfigNode ConfigNode::with(std::string_view key, const ConfigNode& value) const {
  if (!is_map()) throw expected("a map of keys");
  ConfigTree copy = *tree_;
  if (ConfigTree::Entry* entry = entry_of(copy, key)) {
    entry->value = value.placed();
    entry->line = value.line_;
  } else {
    copy.entries.push_back({std::string(key), value.line_, value.placed()});
  }
  return {std::make_shared<const ConfigTree>(std::move(copy)), origin_, path_, line_};
}

ConfigNode ConfigNode::without(std::string_view key) const {
  ConfigTree copy = *tree_;
  std::erase_if(copy.entries, [&](const ConfigTree::Entry& entry) { return entry.key == key; });
  return {std::make_shared<const ConfigTree>(std::move(copy)), origin_, path_, line_};
}

ConfigNode ConfigNode::under(std::string_view key) const {
  ConfigTree map;
  map.kind = ConfigTree::Kind::map;
  map.line = line_;
  map.entries.push_back({std::string(key), line_, placed()});
  return {std::make_shared<const ConfigTree>(std::move(map)), origin_, path_, line_};
}

ConfigNode ConfigNode::with_items(const std::vector<ConfigNode>& items) const {
  if (!is_list()) throw expected("a list");
  ConfigTree copy = *tree_;
  copy.items.clear();
  for (const ConfigNode& item : items) copy.items.push_back(item.placed());
  return {std::make_shared<const ConfigTree>(std::move(copy)), origin_, path_, line_};
}

ConfigNode ConfigNode::over(const ConfigNode& base) const {
  return {joined(placed(), base.placed()), origin_, path_, line_};
}

}  // namespace voronaut
