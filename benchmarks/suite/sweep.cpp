#include "voronaut/benchmarks/suite/sweep.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <nlohmann/json.hpp>

#include "voronaut/benchmarks/suite/suite_paths.h"
#include "voronaut/benchmarks/trial/flight_config.h"
#include "voronaut/environments/config/config_reader.h"
#include "voronaut/environments/config/nearest_name.h"

namespace voronaut {

namespace {

constexpr std::size_t kEntriesMax = 10'000;  // of one list

// An axis as the file says it.
struct WrittenAxis {
  std::string path;
  EntryPath where;
  bool zipped = false;
  std::vector<ConfigNode> values;
  std::vector<std::string> texts;
};

// With so many digits as tell it from its neighbours, `step` away, to a thousandth of that.
std::string short_text(double value, double step) {
  const double unit = std::pow(10.0, 3 - std::floor(std::log10(std::abs(step))));
  return number_text(std::isfinite(unit) ? std::round(value * unit) / unit : value);
}

std::vector<ConfigNode> values_of_range(const ConfigNode& node) {
  SweepRange range;
  for (const char* key : {"from", "to", "steps"}) node.child(key);
  read_into(node, range);
  const bool ratios = range.spacing == SweepRange::Spacing::logarithmic;
  if (ratios && (range.from <= 0 || range.to <= 0))
    throw node.error("logarithmic needs `from` and `to` above 0");
  if (range.from == range.to) throw node.error("`from` and `to` are the same");
  const double ratio = ratios ? std::pow(range.to / range.from, 1.0 / (range.steps - 1)) : 1;
  const double step = (range.to - range.from) / (range.steps - 1);
  std::vector<ConfigNode> values;
  for (int i = 0; i < range.steps; ++i) {
    const double value = ratios ? range.from * std::pow(ratio, i) : range.from + i * step;
    std::string text = short_text(value, ratios ? value * (ratio - 1) : step);
    if (i == 0) text = number_text(range.from);
    if (i + 1 == range.steps) text = number_text(range.to);
    values.push_back(node.value(text, node.place()));
  }
  return values;
}

// Sections of the suite belong to what flies, so they are keys of its vehicles.
EntryPath swept_path(const ConfigNode& root, const std::string& path, const ConfigNode& node) {
  EntryPath where = entry_path(root, path, node);
  const std::string head = path.substr(0, path.find('.'));
  if (where.list == nullptr) {
    auto sections = key_names<FlightConfig>();
    if (std::find(sections.begin(), sections.end(), head) == sections.end()) {
      for (const SuiteList& list : suite_lists())
        sections.insert(sections.end(), {list.key, list.each});
      throw node.error("a sweep goes over no " + in_quotes(head) + allowed_names(head, sections));
    }
    for (const SuiteList& list : suite_lists())
      if (list.each == "vehicle") where = {&list, "", path};
  }
  const bool names_it = where.key == "label" || where.key == "group" ||
                        (where.key == "name" && where.list->each == "scenario");
  if (where.key.empty() || names_it || where.key == head)
    throw node.error(
        "expected the path of a key whose values can differ, as vehicle.max_speed_m_s");
  return where;
}

WrittenAxis read_axis(const ConfigNode& root, const std::string& path, const ConfigNode& node,
                      bool zipped) {
  WrittenAxis axis{path, swept_path(root, path, node), zipped, {}, {}};
  axis.values = node.is_map() ? values_of_range(node) : node.items();
  if (axis.values.empty()) throw node.error("expected at least one value, got none");
  for (const ConfigNode& value : axis.values) {
    const std::string text = value.text();
    if (std::find(axis.texts.begin(), axis.texts.end(), text) != axis.texts.end())
      throw value.error("the value " + in_quotes(text) + " is given twice");
    axis.texts.push_back(text);
  }
  return axis;
}

std::vector<WrittenAxis> read_axes(const ConfigNode& root, const ConfigNode& sweep) {
  std::vector<WrittenAxis> axes;
  for (const std::string& path : sweep.keys())
    if (path != "zipped") axes.push_back(read_axis(root, path, sweep.child(path), false));
  const auto zipped = sweep.find("zipped");
  if (!zipped) return axes;
  const std::size_t first = axes.size();
  for (const std::string& path : zipped->keys()) {
    const ConfigNode node = zipped->child(path);
    axes.push_back(read_axis(root, path, node, true));
    const std::size_t count = axes.back().values.size();
    if (count != axes[first].values.size())
      throw node.error("has " + std::to_string(count) + " values, " + in_quotes(axes[first].path) +
                       " has " + std::to_string(axes[first].values.size()) +
                       "; those that go in step have equally many");
  }
  return axes;
}

// Which value of each axis; of an axis that does not concern the entry the first.
using Steps = std::vector<std::size_t>;

// All that an entry becomes, the last axis turning fastest.
std::vector<Steps> steps_of(const std::vector<WrittenAxis>& axes,
                            const std::vector<std::size_t>& concern, const ConfigNode& entry) {
  std::vector<Steps> all = {Steps(axes.size(), 0)};
  bool zipped_done = false;
  for (const std::size_t a : concern) {
    if (axes[a].zipped && zipped_done) continue;
    zipped_done = zipped_done || axes[a].zipped;
    if (all.size() * axes[a].values.size() > kEntriesMax)
      throw entry.error("the sweep makes more than " + std::to_string(kEntriesMax) + " of it");
    std::vector<Steps> more;
    for (const Steps& steps : all) {
      for (std::size_t i = 0; i < axes[a].values.size(); ++i) {
        Steps& next = more.emplace_back(steps);
        for (const std::size_t b : concern)
          if (b == a || (axes[a].zipped && axes[b].zipped)) next[b] = i;
      }
    }
    all = std::move(more);
  }
  return all;
}

std::string last_key(const std::string& path) { return path.substr(path.rfind('.') + 1); }

// "RRTConnect range=0.5"; the names of scenarios have no blanks: "forest-density_per_m2-0.1".
std::string suffix_of(const std::vector<WrittenAxis>& axes, const std::vector<std::size_t>& concern,
                      const Steps& steps) {
  std::string suffix;
  for (const std::size_t a : concern) {
    const std::string& key = axes[a].where.key;
    const auto alike = std::count_if(concern.begin(), concern.end(), [&](std::size_t b) {
      return last_key(axes[b].where.key) == last_key(key);
    });
    const bool scenario = axes[a].where.list->each == "scenario";
    suffix.append(scenario ? "-" : " ").append(alike > 1 ? key : last_key(key));
    suffix.append(scenario ? "-" : "=").append(axes[a].texts[steps[a]]);
  }
  return suffix;
}

ConfigNode text_node(const ConfigNode& entry, const std::string& text) {
  return entry.value(nlohmann::json(text).dump(), entry.place());
}

std::string group_of(const ConfigNode& scenario, const std::string& base) {
  const auto group = scenario.find("group");
  return group ? group->text() : base;
}

ConfigNode named(const ConfigNode& entry, const SweptEntry& made) {
  if (made.group.empty()) return entry.with("label", text_node(entry, made.label));
  return entry.with("name", text_node(entry, made.label))
      .with("group", text_node(entry, made.group));
}

// The entries of a list as the axes that concern it make them.
std::vector<ConfigNode> swept(const SuiteList& list, const ConfigNode& node,
                              const std::vector<WrittenAxis>& axes, std::vector<SweepAxis>& made) {
  std::vector<ConfigNode> entries;
  for (const ConfigNode& entry : node.items()) {
    const std::string base = entry_name(entry);
    std::vector<std::size_t> concern;
    for (std::size_t a = 0; a < axes.size(); ++a)
      if (axes[a].where.list == &list &&
          (axes[a].where.entry.empty() || axes[a].where.entry == base))
        concern.push_back(a);
    if (concern.empty()) {
      entries.push_back(entry);
      continue;
    }
    if (list.each == "scenario" && (entry.find("file") || entry.find("dataset")))
      throw entry.error(
          "a sweep goes over scenarios that are said in the suite itself, not over "
          "those of a file or a data set");
    for (const Steps& steps : steps_of(axes, concern, entry)) {
      ConfigNode variant = entry;
      for (const std::size_t a : concern)
        variant = with_entry_value(list, variant, axes[a].where.key, axes[a].values[steps[a]]);
      const std::string suffix = suffix_of(axes, concern, steps);
      SweptEntry entry_made{base + suffix, base, "", "", "", 0};
      if (list.each == "scenario") {
        entry_made.base_group = group_of(entry, base);
        entry_made.group = entry_made.base_group + suffix;
      }
      entries.push_back(named(variant, entry_made));
      for (const std::size_t a : concern) {
        entry_made.value = axes[a].texts[steps[a]];
        entry_made.step = steps[a];
        made[a].entries.push_back(entry_made);
      }
    }
  }
  return entries;
}

}  // namespace

std::pair<ConfigNode, std::vector<SweepAxis>> without_sweep(const ConfigNode& root) {
  const auto sweep = root.find("sweep");
  if (!sweep) return {root, {}};
  const std::vector<WrittenAxis> axes = read_axes(root, *sweep);
  std::vector<SweepAxis> made;
  for (const WrittenAxis& axis : axes)
    made.push_back({axis.path, axis.where.list->each, axis.zipped, {}});
  ConfigNode expanded = root.without("sweep");
  for (const SuiteList& list : suite_lists()) {
    const bool concerned = std::any_of(axes.begin(), axes.end(), [&](const WrittenAxis& axis) {
      return axis.where.list == &list;
    });
    if (!concerned) continue;
    const ConfigNode node = root.child(list.key);
    expanded = expanded.with(list.key, node.with_items(swept(list, node, axes, made)));
  }
  return {expanded, made};
}

std::vector<AxisColumn> columns_of(const std::vector<SweepAxis>& axes) {
  std::vector<AxisColumn> columns;
  for (const SweepAxis& axis : axes) {
    AxisColumn& column =
        columns.emplace_back(AxisColumn{axis.path, axis.column, axis.zipped, {}, {}, {}});
    for (const SweptEntry& entry : axis.entries) {
      column.values[entry.label] = entry.value;
      if (entry.group.empty()) {
        column.bases[entry.label] = entry.base;
      } else {
        column.groups[entry.group] = entry.value;
        column.bases[entry.group] = entry.base_group;
      }
    }
  }
  return columns;
}

std::optional<std::size_t> zipped_step(const std::vector<SweepAxis>& axes, std::string_view column,
                                       const std::string& label) {
  for (const SweepAxis& axis : axes) {
    if (!axis.zipped || axis.column != column) continue;
    for (const SweptEntry& entry : axis.entries)
      if (entry.label == label) return entry.step;
  }
  return std::nullopt;
}

}  // namespace voronaut
