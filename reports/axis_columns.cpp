#include "voronaut/reports/axis_columns.h"

#include <charconv>

#include <nlohmann/json.hpp>

#include "voronaut/reports/record_columns.h"

namespace voronaut {

namespace {

using Json = nlohmann::ordered_json;

Json json_of(const std::map<std::string, std::string>& values) {
  Json json = Json::object();
  for (const auto& [name, value] : values) {
    double number = 0;
    const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), number);
    const bool is_number = error == std::errc{} && end == value.data() + value.size();
    json[name] = is_number ? Json(number) : Json(value);
  }
  return json;
}

std::map<std::string, std::string> values_of(const Json& json) {
  std::map<std::string, std::string> values;
  for (const auto& [name, value] : json.items())
    values[name] = value.is_number() ? cell_text(value.get<double>()) : value.get<std::string>();
  return values;
}

std::string found_in(const std::map<std::string, std::string>& values, std::string_view name) {
  const auto found = values.find(std::string(name));
  return found == values.end() ? "" : found->second;
}

}  // namespace

std::string AxisColumn::value_of(const RunRecord& record) const {
  if (column == "scenario") return found_in(values, record.scenario);
  return found_in(values, column == "vehicle" ? record.vehicle : record.planner);
}

std::string AxisColumn::value_of(std::string_view scenario_group, std::string_view vehicle,
                                 std::string_view planner) const {
  if (column == "scenario") return found_in(groups, scenario_group);
  return found_in(values, column == "vehicle" ? vehicle : planner);
}

std::string axis_columns_json(const std::vector<AxisColumn>& axes) {
  Json list = Json::array();
  for (const AxisColumn& axis : axes)
    list.push_back({{"path", axis.path},
                    {"column", axis.column},
                    {"zipped", axis.zipped},
                    {"values", json_of(axis.values)},
                    {"groups", json_of(axis.groups)},
                    {"bases", axis.bases}});
  return list.dump();
}

std::vector<AxisColumn> axis_columns(const std::string& json) {
  std::vector<AxisColumn> axes;
  if (json.empty()) return axes;
  for (const Json& axis : Json::parse(json))
    axes.push_back({axis.at("path"), axis.at("column"), axis.at("zipped"),
                    values_of(axis.at("values")), values_of(axis.at("groups")), axis.at("bases")});
  return axes;
}

}  // namespace voronaut
