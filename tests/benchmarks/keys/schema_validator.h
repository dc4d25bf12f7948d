#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace voronaut {

// What is wrong with a value by a JSON Schema, in one line with the place; empty if nothing is. Of
// draft 7 it knows what our schemas use and throws std::logic_error for any other word.
std::string schema_problem(const nlohmann::ordered_json& value,
                           const nlohmann::ordered_json& schema, const std::string& place = "");

// A YAML text as JSON: plain scalars become numbers and flags, quoted ones stay text.
nlohmann::ordered_json json_of_yaml(const std::string& text);

}  // namespace voronaut
