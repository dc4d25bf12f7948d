#include "voronaut/environments/config/config_node.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>

#include "voronaut/environments/config/config_tree.h"
#include "voronaut/environments/config/nearest_name.h"
#include "voronaut/environments/config/renamed_keys.h"

namespace voronaut {
namespace {

std::string range_text(double lo, double hi) {
  const bool bounded_below = std::isfinite(lo);
  const bool bounded_above = std::isfinite(hi);
  if (bounded_below && bounded_above) return " from " + number_text(lo) + " to " + number_text(hi);
  if (bounded_below) return " of at least " + number_text(lo);
  if (bounded_above) return " of at most " + number_text(hi);
  return "";
}

std::string description(const ConfigTree& tree) {
  switch (tree.kind) {
    case ConfigTree::Kind::nothing:
      return "nothing";
    case ConfigTree::Kind::scalar:
      return (tree.quoted ? "the text " : "") + in_quotes(tree.scalar);
    case ConfigTree::Kind::list:
      return "a list of " + std::to_string(tree.items.size());
    case ConfigTree::Kind::map:
      break;
  }
  return "a map";
}

}  // namespace

std::optional<double> parse_number(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value))
    return std::nullopt;
  return value;
}

std::optional<std::int64_t> parse_whole(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::string number_text(double value) {
  if (value == 0) return "0";
  const double size = std::abs(value);
  const auto format =
      size >= 1e-4 && size < 1e15 ? std::chars_format::fixed : std::chars_format::scientific;
  char text[32];
  const auto result = std::to_chars(text, text + sizeof text, value, format);
  return {text, result.ptr};
}

ConfigNode ConfigNode::read_file(const std::string& path) {
  return parse(read_text_file(path), path);
}

ConfigNode ConfigNode::parse(const std::string& text, const std::string& file) {
  ConfigNode root(parse_yaml(text, file),
                  std::make_shared<const ConfigOrigin>(ConfigOrigin{file, file}), "", 1);
  root.line_ = root.tree_->line;
  if (!root.is_map()) throw root.expected("a map of keys");
  return root;
}

const std::string& ConfigNode::file() const { return origin_->file; }

std::string ConfigNode::place() const {
  return origin_->called + (origin_->has_lines ? ":" + std::to_string(line_) : "");
}

ConfigNode ConfigNode::below(const Tree& tree, std::string path, int line) const {
  return ConfigNode(tree, tree->origin ? tree->origin : origin_, std::move(path), line);
}

std::string ConfigNode::beside(const std::string& relative) const {
  return (std::filesystem::path(file()).parent_path() / relative).lexically_normal().string();
}

bool ConfigNode::is_map() const { return tree_->kind == ConfigTree::Kind::map; }
bool ConfigNode::is_list() const { return tree_->kind == ConfigTree::Kind::list; }
bool ConfigNode::is_scalar() const { return tree_->kind == ConfigTree::Kind::scalar; }

double ConfigNode::number(double lo, double hi) const {
  const std::string* text = plain_scalar();
  const auto value = text ? parse_number(*text) : std::nullopt;
  if (!value || *value < lo || *value > hi) throw expected("a number" + range_text(lo, hi));
  return *value;
}

std::int64_t ConfigNode::whole_number(std::int64_t lo, std::int64_t hi) const {
  const std::string* text = plain_scalar();
  const auto value = text ? parse_whole(*text) : std::nullopt;
  if (!value || *value < lo || *value > hi)
    throw expected("a whole number from " + std::to_string(lo) + " to " + std::to_string(hi));
  return *value;
}

bool ConfigNode::flag() const {
  const std::string* text = plain_scalar();
  if (text && *text == "true") return true;
  if (text && *text == "false") return false;
  throw expected("true or false");
}

std::string ConfigNode::text() const {
  if (!is_scalar()) throw expected("text");
  return tree_->scalar;
}

std::size_t ConfigNode::choice(const std::vector<std::string>& names) const {
  if (!is_scalar()) throw expected("one of " + join_names(names));
  const auto found = std::find(names.begin(), names.end(), tree_->scalar);
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  if (const std::string now = renamed_text(tree_->scalar, names); !now.empty()) throw error(now);
  const auto meant = nearest_name(tree_->scalar, names);
  throw error("expected one of " + join_names(names) + ", got " + description(*tree_) +
              (meant ? " (did you mean '" + *meant + "'?)" : ""));
}

std::vector<ConfigNode> ConfigNode::items() const {
  if (!is_list()) throw expected("a list");
  std::vector<ConfigNode> nodes;
  nodes.reserve(tree_->items.size());
  for (std::size_t i = 0; i < tree_->items.size(); ++i)
    nodes.push_back(
        below(tree_->items[i], path_ + "[" + std::to_string(i) + "]", tree_->items[i]->line));
  return nodes;
}

std::vector<ConfigNode> ConfigNode::items(std::size_t exactly, std::string_view form) const {
  if (!is_list() || tree_->items.size() != exactly) throw expected(std::string(form));
  return items();
}

std::vector<double> ConfigNode::numbers(std::size_t exactly, std::string_view form, double lo,
                                        double hi) const {
  std::vector<double> values;
  for (const ConfigNode& item : items(exactly, form)) values.push_back(item.number(lo, hi));
  return values;
}

std::vector<std::string> ConfigNode::texts() const {
  std::vector<std::string> values;
  for (const ConfigNode& item : items()) values.push_back(item.text());
  return values;
}

std::vector<std::string> ConfigNode::keys() const {
  if (!is_map()) throw expected("a map of keys");
  std::vector<std::string> names;
  for (const ConfigTree::Entry& entry : tree_->entries) names.push_back(entry.key);
  return names;
}

std::optional<ConfigNode> ConfigNode::find(std::string_view key) const {
  if (!is_map()) throw expected("a map of keys");
  for (const ConfigTree::Entry& entry : tree_->entries)
    if (entry.key == key) return below(entry.value, path_of(key), entry.line);
  return std::nullopt;
}

ConfigNode ConfigNode::child(std::string_view key) const {
  if (const auto found = find(key)) return *found;
  throw ConfigError(origin_->called, origin_->has_lines ? line_ : 0, path_of(key), "missing");
}

void ConfigNode::allow_only(const std::vector<std::string>& allowed) const {
  if (!is_map()) throw expected("a map of keys");
  for (const ConfigTree::Entry& entry : tree_->entries) {
    if (std::find(allowed.begin(), allowed.end(), entry.key) != allowed.end()) continue;
    const std::string now = renamed_text(entry.key, allowed);
    throw below(entry.value, path_of(entry.key), entry.line)
        .error(now.empty() ? "unknown key" + allowed_names(entry.key, allowed) : now);
  }
}

ConfigError ConfigNode::error(std::string_view problem) const {
  return ConfigError(origin_->called, origin_->has_lines ? line_ : 0, path_, problem);
}

ConfigError ConfigNode::expected(const std::string& what) const {
  return error("expected " + what + ", got " + description(*tree_));
}

const std::string* ConfigNode::plain_scalar() const {
  return is_scalar() && !tree_->quoted ? &tree_->scalar : nullptr;
}

std::string ConfigNode::path_of(std::string_view key) const {
  std::string shown = in_quotes(key);
  shown = shown.substr(1, shown.size() - 2);
  return path_.empty() ? shown : path_ + "." + shown;
}

}  // namespace voronaut
