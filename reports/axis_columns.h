#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "voronaut/reports/run_record.h"

// The axes of a sweep as columns beside those of a record: what a trial has of an axis follows from
// the name of its scenario, vehicle or planner.
namespace voronaut {

struct AxisColumn {
  std::string path;     // in the suite, and the name of the column: "vehicle.max_speed_m_s"
  std::string column;   // of the record: scenario, vehicle or planner
  bool zipped = false;  // goes in step with the other zipped ones
  std::map<std::string, std::string> values;  // by the text of that column
  std::map<std::string, std::string> groups;  // the same by scenario_group, of a scenario's axis
  // What the suite calls what it made so many of: by the same names, of a scenario's axis by group.
  std::map<std::string, std::string> bases;

  // Empty for what the axis does not concern.
  std::string value_of(const RunRecord& record) const;
  std::string value_of(std::string_view scenario_group, std::string_view vehicle,
                       std::string_view planner) const;
};

// As JSON, for manifest.json and the meta row `sweep` of a store: a list of
// {"path", "column", "zipped", "values": {name: value}, "groups": {group: value},
// "bases": {name or group: base}}, numbers as numbers.
std::string axis_columns_json(const std::vector<AxisColumn>& axes);
// Of such a text; none of an empty one.
std::vector<AxisColumn> axis_columns(const std::string& json);

}  // namespace voronaut
