#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "voronaut/environments/config/config_node.h"
#include "voronaut/reports/axis_columns.h"

// What a suite varies: `sweep` makes of an entry of its lists as many as there are values.
namespace voronaut {

// An entry of a list as an axis made it.
struct SweptEntry {
  std::string label;  // in the axis's column
  std::string base;   // what the suite calls the entry
  std::string group;  // of a scenario, with
  std::string base_group;
  std::string value;     // as the suite writes it
  std::size_t step = 0;  // of the axis, from 0
};

struct SweepAxis {
  std::string path;     // "vehicle.max_speed_m_s"
  std::string column;   // of a record, whose text tells the value: scenario, vehicle or planner
  bool zipped = false;  // goes in step with the other zipped ones
  std::vector<SweptEntry> entries;
};

// Values with equal distances, both ends among them.
struct SweepRange {
  enum class Spacing { linear, logarithmic };

  double from = 0;
  double to = 1;
  int steps = 2;
  Spacing spacing = Spacing::linear;

  template <class Visitor>
  void visit(Visitor& v) {
    v.number("from", from, -1e12, 1e12, "The first value");
    v.number("to", to, -1e12, 1e12, "The last one");
    v.count("steps", steps, 2, 1000, "How many there are");
    v.choice("spacing", spacing,
             {{"linear", Spacing::linear}, {"logarithmic", Spacing::logarithmic}},
             "Equal differences, or equal ratios");
  }
};

// A suite without its `sweep`, and what that made of it:
//
//   sweep:
//     planners.RRTConnect.range: [0.5, 1, 2]            path (suite_paths.h) and values
//     range_finder.max_range_m: {from: 1, to: 5, steps: 5}
//     zipped: {vehicle.max_speed_m_s: [1, 2], navigation.margin_m: [0.1, 0.2]}
//
// All values of the axes meet each other; those of `zipped` go in step, the first with the first. A
// planner, vehicle or scenario becomes one for each value, called "RRTConnect range=0.5"; a section
// of the whole suite belongs to what flies, so each vehicle becomes one for each value. Throws
// ConfigError.
std::pair<ConfigNode, std::vector<SweepAxis>> without_sweep(const ConfigNode& root);

// The axes as columns of the results.
std::vector<AxisColumn> columns_of(const std::vector<SweepAxis>& axes);

// The step of the zipped axes that an entry stands for; none for one that no such axis made.
std::optional<std::size_t> zipped_step(const std::vector<SweepAxis>& axes, std::string_view column,
                                       const std::string& label);

}  // namespace voronaut
