#include "voronaut/environments/config/config_reader.h"

namespace voronaut {
namespace {

class KeyNames : public KeyVisitor {
 public:
  std::vector<std::string> names;
  bool has_presets = false;

  void number(std::string_view key, double&, double, double, std::string_view) override {
    names.emplace_back(key);
  }
  void flag(std::string_view key, bool&, std::string_view) override { names.emplace_back(key); }
  void text(std::string_view key, std::string&, std::string_view) override {
    names.emplace_back(key);
  }
  void form(std::string_view key, std::string_view, std::string_view) override {
    names.emplace_back(key);
  }

 private:
  void whole_number(std::string_view key, std::int64_t&, std::int64_t, std::int64_t,
                    std::string_view) override {
    names.emplace_back(key);
  }
  void one_of(std::string_view key, const std::vector<std::string>&, std::size_t&,
              std::string_view) override {
    names.emplace_back(key);
  }
  void nested(std::string_view key, const VisitKeys&, std::string_view) override {
    names.emplace_back(key);
  }
  void one_preset_of(const std::vector<std::string>&, std::size_t&, std::string_view) override {
    has_presets = true;
    names.emplace_back(kPresetKey);
  }
};

class KeyReader : public KeyVisitor {
 public:
  explicit KeyReader(const ConfigNode& node) : node_(node) {}

  void number(std::string_view key, double& value, double lo, double hi,
              std::string_view) override {
    if (const auto found = find(key)) value = found->number(lo, hi);
  }
  void flag(std::string_view key, bool& value, std::string_view) override {
    if (const auto found = find(key)) value = found->flag();
  }
  void text(std::string_view key, std::string& value, std::string_view) override {
    if (const auto found = find(key)) value = found->text();
  }
  void form(std::string_view, std::string_view, std::string_view) override {}

 private:
  void whole_number(std::string_view key, std::int64_t& value, std::int64_t lo, std::int64_t hi,
                    std::string_view) override {
    if (const auto found = find(key)) value = found->whole_number(lo, hi);
  }
  void one_of(std::string_view key, const std::vector<std::string>& names, std::size_t& chosen,
              std::string_view) override {
    if (const auto found = find(key)) chosen = found->choice(names);
  }
  void nested(std::string_view key, const VisitKeys& keys, std::string_view) override {
    if (const auto found = find(key)) read_keys(*found, keys);
  }
  void one_preset_of(const std::vector<std::string>& names, std::size_t& chosen,
                     std::string_view) override {
    if (node_.is_scalar())
      chosen = node_.choice(names);
    else if (const auto found = node_.find(kPresetKey))
      chosen = found->choice(names);
  }
  void one_group_of(const std::vector<std::vector<std::string>>& groups,
                    std::size_t& chosen) override {
    std::string first;
    for (std::size_t group = 0; group < groups.size(); ++group) {
      for (const std::string& key : groups[group]) {
        const auto found = find(key);
        if (!found) continue;
        if (!first.empty() && group != chosen)
          throw found->error("cannot stand beside " + first + " (allowed: " + in_words(groups) +
                             ")");
        first = key;
        chosen = group;
      }
    }
  }

  // What is a preset's name alone says nothing of single keys.
  std::optional<ConfigNode> find(std::string_view key) const {
    return node_.is_scalar() ? std::nullopt : node_.find(key);
  }

  // "a with b, or c, or d"
  static std::string in_words(const std::vector<std::vector<std::string>>& groups) {
    std::string words;
    for (const std::vector<std::string>& group : groups) {
      words += words.empty() ? "" : ", or ";
      for (const std::string& key : group) words += (key == group.front() ? "" : " with ") + key;
    }
    return words;
  }

  const ConfigNode& node_;
};

class KeyWriter : public KeyVisitor {
 public:
  ConfigEntries entries;

  void number(std::string_view key, double& value, double, double, std::string_view) override {
    put(key, number_text(value));
  }
  void flag(std::string_view key, bool& value, std::string_view) override {
    put(key, value ? "true" : "false");
  }
  void text(std::string_view key, std::string& value, std::string_view) override {
    put(key, value);
  }
  void form(std::string_view, std::string_view, std::string_view) override {}
  bool all_groups() const override { return false; }

 private:
  void whole_number(std::string_view key, std::int64_t& value, std::int64_t, std::int64_t,
                    std::string_view) override {
    put(key, std::to_string(value));
  }
  void one_of(std::string_view key, const std::vector<std::string>& names, std::size_t& chosen,
              std::string_view) override {
    if (chosen < names.size()) put(key, names[chosen]);
  }
  void nested(std::string_view key, const VisitKeys& keys, std::string_view) override {
    const std::string outer = prefix_;
    prefix_.append(key).append(".");
    keys(*this);
    prefix_ = outer;
  }

  void put(std::string_view key, std::string value) {
    entries.emplace_back(prefix_ + std::string(key), std::move(value));
  }

  std::string prefix_;
};

}  // namespace

void read_keys(const ConfigNode& node, const VisitKeys& keys,
               const std::vector<std::string>& also_allowed) {
  KeyNames own;
  keys(own);
  std::vector<std::string> allowed = also_allowed;
  for (std::string& name : own.names) allowed.push_back(std::move(name));
  if (!own.has_presets || !node.is_scalar()) node.allow_only(allowed);
  read_present_keys(node, keys);
}

void read_present_keys(const ConfigNode& node, const VisitKeys& keys) {
  KeyReader reader(node);
  keys(reader);
}

std::vector<std::string> key_names(const VisitKeys& keys) {
  KeyNames visitor;
  keys(visitor);
  return std::move(visitor.names);
}

ConfigEntries key_entries(const VisitKeys& keys) {
  KeyWriter writer;
  keys(writer);
  return std::move(writer.entries);
}

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
