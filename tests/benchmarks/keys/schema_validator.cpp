#include "voronaut/tests/benchmarks/keys/schema_validator.h"

#include <algorithm>
#include <functional>
#include <map>
#include <stdexcept>

#include <yaml-cpp/yaml.h>

#include "voronaut/environments/config/config_node.h"

namespace voronaut {
namespace {

using Json = nlohmann::ordered_json;

bool is_of_type(const Json& value, const std::string& type) {
  if (type == "object") return value.is_object();
  if (type == "array") return value.is_array();
  if (type == "string") return value.is_string();
  if (type == "boolean") return value.is_boolean();
  if (type == "integer") return value.is_number_integer();
  if (type == "number") return value.is_number();
  throw std::logic_error("a type unknown to this test: " + type);
}

std::string type_problem(const Json& value, const Json& types) {
  if (types.is_string()) return is_of_type(value, types) ? "" : "is no " + types.dump();
  const bool fits =
      std::any_of(types.begin(), types.end(), [&](const Json& t) { return is_of_type(value, t); });
  return fits ? "" : "is none of " + types.dump();
}

std::string object_problem(const Json& value, const Json& schema, const std::string& place) {
  if (!value.is_object()) return "";
  const Json properties = schema.value("properties", Json::object());
  for (const auto& [key, inner] : value.items()) {
    if (const auto found = properties.find(key); found != properties.end()) {
      if (const auto problem = schema_problem(inner, *found, place + "." + key); !problem.empty())
        return problem;
    } else if (const auto others = schema.find("additionalProperties"); others != schema.end()) {
      if (others->is_boolean() && !*others) return place + "." + key + " is no key";
      if (others->is_object())
        if (const auto problem = schema_problem(inner, *others, place + "." + key);
            !problem.empty())
          return problem;
    }
  }
  for (const Json& key : schema.value("required", Json::array()))
    if (!value.contains(key)) return place + " lacks " + key.dump();
  return "";
}

std::string list_problem(const Json& value, const Json& schema, const std::string& place) {
  if (!value.is_array()) return "";
  if (value.size() < schema.value("minItems", 0U)) return place + " is too short";
  if (schema.contains("maxItems") && value.size() > schema["maxItems"])
    return place + " is too long";
  if (!schema.contains("items")) return "";
  for (std::size_t i = 0; i < value.size(); ++i) {
    const std::string at = place + "[" + std::to_string(i) + "]";
    if (const auto problem = schema_problem(value[i], schema["items"], at); !problem.empty())
      return problem;
  }
  return "";
}

std::string combined_problem(const Json& value, const Json& schema, const std::string& place) {
  for (const Json& part : schema.value("allOf", Json::array()))
    if (const auto problem = schema_problem(value, part, place); !problem.empty()) return problem;
  if (schema.contains("anyOf")) {
    std::string all;
    for (const Json& part : schema["anyOf"]) {
      const std::string problem = schema_problem(value, part, place);
      if (problem.empty()) return "";
      all += (all.empty() ? "" : " or ") + problem;
    }
    return all;
  }
  if (schema.contains("not") && schema_problem(value, schema["not"], place).empty())
    return place + " has what cannot stand together";
  if (schema.contains("if") && schema_problem(value, schema["if"], place).empty())
    return schema_problem(value, schema["then"], place);
  return "";
}

std::string scalar_problem(const Json& value, const Json& schema) {
  if (schema.contains("type"))
    if (const std::string problem = type_problem(value, schema["type"]); !problem.empty())
      return problem;
  if (schema.contains("const") && value != schema["const"]) return "is another";
  if (schema.contains("enum")) {
    const Json& names = schema["enum"];
    if (std::find(names.begin(), names.end(), value) == names.end())
      return "is none of " + names.dump();
  }
  if (value.is_number() && schema.contains("minimum") && value < schema["minimum"])
    return "is too small";
  if (value.is_number() && schema.contains("maximum") && value > schema["maximum"])
    return "is too large";
  return "";
}

Json json_of(const YAML::Node& node) {
  if (node.IsSequence()) {
    Json list = Json::array();
    for (const YAML::Node& item : node) list.push_back(json_of(item));
    return list;
  }
  if (node.IsMap()) {
    Json object = Json::object();
    for (const auto& entry : node) object[entry.first.Scalar()] = json_of(entry.second);
    return object;
  }
  if (node.IsNull()) return nullptr;
  const std::string text = node.Scalar();
  if (node.Tag() == "!") return text;  // in quotes
  if (text == "true" || text == "false") return text == "true";
  if (const auto whole = parse_whole(text)) return *whole;
  if (const auto number = parse_number(text)) return *number;
  return text;
}

}  // namespace

std::string schema_problem(const Json& value, const Json& schema, const std::string& place) {
  for (const auto& [word, said] : schema.items()) {
    static const std::vector<std::string> kKnown = {
        "$schema", "title", "description", "default",  "type",
        "const",   "enum",  "minimum",     "maximum",  "items",
        "allOf",   "anyOf", "properties",  "required", "minItems",
        "not",     "if",    "then",        "maxItems", "additionalProperties"};
    if (std::find(kKnown.begin(), kKnown.end(), word) == kKnown.end())
      throw std::logic_error("a word unknown to this test: " + word);
  }
  if (const std::string problem = scalar_problem(value, schema); !problem.empty())
    return place + " " + problem;
  for (const auto& part : {object_problem, list_problem, combined_problem})
    if (const std::string problem = part(value, schema, place); !problem.empty()) return problem;
  return "";
}

Json json_of_yaml(const std::string& text) { return json_of(YAML::Load(text)); }

}  // namespace voronaut
