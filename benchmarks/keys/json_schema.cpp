#include "voronaut/benchmarks/keys/json_schema.h"

#include <cmath>

#include <nlohmann/json.hpp>

#include "voronaut/environments/config/config_node.h"
#include "voronaut/environments/formats/data_sets.h"
#include "voronaut/environments/formats/foreign_formats.h"

namespace voronaut {
namespace {

using Json = nlohmann::ordered_json;
using Kind = KeyFact::Kind;

// The readers take a number for a text, as YAML does not quote "2024".
Json text_schema() { return {{"type", {"string", "number"}}}; }

// Of a shape like "[[x, y, r], ...]", from `at` on: a list of what is named, or, with dots at its
// end, of any number of what stands before them.
Json shape_schema(const std::string& shape, std::size_t& at) {
  if (shape[at] != '[') {
    const std::size_t end = std::min(shape.find_first_of(",]", at), shape.size());
    const std::string word = shape.substr(at, end - at);
    at = end;
    if (word == "file") return {{"type", "string"}};
    if (word == "text") return text_schema();
    return {{"type", "number"}};
  }
  Json items = Json::array();
  bool any_number = false;
  while (shape[at] != ']') {
    ++at;  // '[' or ','
    if (shape[at] == ' ') ++at;
    any_number = shape.compare(at, 3, "...") == 0;
    if (any_number)
      at += 3;
    else
      items.push_back(shape_schema(shape, at));
  }
  ++at;
  Json list = {{"type", "array"}};
  list["items"] = items.front();
  if (!any_number) list["minItems"] = list["maxItems"] = items.size();
  return list;
}

Json shape_schema(const std::string& shape) {
  std::size_t at = 0;
  return shape_schema(shape, at);
}

Json object_schema(const std::vector<KeyFact>& facts);

Json value_schema(const KeyFact& fact) {
  Json schema;
  switch (fact.kind) {
    case Kind::number:
    case Kind::whole_number:
      schema["type"] = fact.kind == Kind::number ? "number" : "integer";
      if (std::isfinite(fact.lo)) schema["minimum"] = fact.lo;
      if (std::isfinite(fact.hi)) schema["maximum"] = fact.hi;
      if (const auto value = parse_number(fact.default_text)) schema["default"] = *value;
      break;
    case Kind::flag:
      schema = {{"type", "boolean"}, {"default", fact.default_text == "true"}};
      break;
    case Kind::choice:
      schema["enum"] = fact.choices;
      if (!fact.default_text.empty()) schema["default"] = fact.default_text;
      break;
    case Kind::text:
      schema = text_schema();
      break;
    case Kind::form:
      schema = shape_schema(fact.shape);
      break;
    case Kind::section:
      schema = object_schema(fact.keys);
      if (!fact.choices.empty()) schema = {{"anyOf", {Json{{"enum", fact.choices}}, schema}}};
      break;
  }
  const std::string unit = unit_of_key(fact.key);
  const std::string description = fact.sentence + (unit.empty() ? "" : " [" + unit + "]");
  if (!description.empty()) schema["description"] = description;
  return schema;
}

Json object_schema(const std::vector<KeyFact>& facts) {
  Json object = {
      {"type", "object"}, {"additionalProperties", false}, {"properties", Json::object()}};
  Json apart = Json::array();
  for (const KeyFact& fact : facts) {
    object["properties"][fact.key] = value_schema(fact);
    for (const KeyFact& other : facts)
      if (other.group > fact.group && fact.group >= 0)
        apart.push_back({{"not", {{"required", {fact.key, other.key}}}}});
  }
  if (!apart.empty()) object["allOf"] = apart;
  return object;
}

std::vector<KeyFact> joined(std::vector<KeyFact> facts, const std::vector<KeyFact>& more) {
  facts.insert(facts.end(), more.begin(), more.end());
  return facts;
}

std::vector<std::string> names_of(const std::vector<NamedKeys>& all) {
  std::vector<std::string> names;
  names.reserve(all.size());
  for (const NamedKeys& named : all) names.push_back(named.name);
  return names;
}

// Puts another schema under a key and keeps what the key says of itself.
void put(Json& object, const std::string& key, Json schema) {
  Json& property = object["properties"][key];
  schema["description"] = property["description"];
  property = std::move(schema);
}

Json when_named(const std::string& name, Json then) {
  return {{"if", {{"properties", {{"name", {{"const", name}}}}}, {"required", {"name"}}}},
          {"then", std::move(then)}};
}

// Of an entry that is a name alone or a map: the keys under `key` depend on the name.
Json named_entry(const std::vector<KeyFact>& facts, const std::vector<NamedKeys>& all,
                 const std::string& key) {
  Json object = object_schema(facts);
  put(object, "name", {{"enum", names_of(all)}});
  put(object, key, {{"type", "object"}});
  object["required"] = {"name"};
  for (const NamedKeys& named : all)
    object["allOf"].push_back(
        when_named(named.name, {{"properties", {{key, object_schema(named.keys)}}}}));
  return object;
}

Json name_or(const std::vector<NamedKeys>& all, Json object) {
  return {{"anyOf", {Json{{"enum", names_of(all)}}, std::move(object)}}};
}

Json vehicle_schema(const FileKeys& keys) {
  Json vehicle = named_entry(keys.vehicle, keys.vehicle_params, "params");
  put(vehicle, "model", {{"type", "object"}});
  for (const NamedKeys& model : keys.vehicle_models)
    vehicle["allOf"].push_back(
        when_named(model.name, {{"properties", {{"model", object_schema(model.keys)}}}}));
  put(vehicle, "regulator",
      name_or(keys.regulators, named_entry(keys.regulator, keys.regulators, "params")));
  return name_or(keys.vehicle_params, std::move(vehicle));
}

const KeyFact& key_of(const std::vector<KeyFact>& facts, const std::string& key) {
  for (const KeyFact& fact : facts)
    if (fact.key == key) return fact;
  throw std::logic_error("no key " + key);
}

Json planner_schema(const FileKeys& keys) {
  Json planner = named_entry(keys.planner, keys.planners, "params");
  put(planner, "navigation", value_schema(key_of(keys.suite, "navigation")));
  return name_or(keys.planners, std::move(planner));
}

Json generator_schema(const FileKeys& keys) {
  Json object = {{"type", "object"}, {"required", {"name"}}, {"allOf", Json::array()}};
  object["properties"]["name"] = {{"enum", names_of(keys.generators)},
                                  {"description", "The family"}};
  for (const NamedKeys& family : keys.generators) {
    Json own = object_schema(family.keys);
    own["properties"]["name"] = Json::object();
    object["allOf"].push_back(when_named(family.name, std::move(own)));
  }
  return object;
}

// The ways to say what a scenario's world comes from.
Json scenario_sources(const FileKeys& keys) {
  const auto entry = [&](const std::vector<KeyFact>& facts, const std::string& required) {
    Json object = object_schema(joined(facts, keys.task));
    object["required"] = {required};
    return object;
  };
  const Json queries = object_schema(joined(keys.query_file, keys.query_selection));
  Json world = entry(keys.world, "world");
  world["required"] = {"world", "bounds", "start", "goal"};
  Json world_file = entry(joined(keys.world_file, keys.foreign_options), "world_file");
  put(world_file, "format", {{"enum", foreign_format_names()}});
  put(world_file, "queries", {{"anyOf", {Json{{"type", "string"}}, queries}}});
  Json generator = entry(keys.generator, "generator");
  put(generator, "generator", generator_schema(keys));
  Json data_set = entry(joined(keys.data_set, keys.foreign_options), "dataset");
  data_set["properties"].erase("name");  // its worlds have names of their own
  put(data_set, "dataset", {{"enum", data_set_names()}});
  put(data_set, "queries", object_schema(keys.query_selection));
  return {world, world_file, generator, data_set};
}

Json titled(const std::string& title, const Json& schema) {
  Json root = {{"$schema", "http://json-schema.org/draft-07/schema#"}, {"title", title}};
  root.update(schema);
  return root;
}

Json list_of(Json items) {
  return {{"type", "array"}, {"minItems", 1}, {"items", std::move(items)}};
}

// Values by path: a list of them, or from, to and how many.
Json sweep_schema(const FileKeys& keys) {
  Json range = object_schema(keys.sweep_range);
  range["required"] = {"from", "to", "steps"};
  Json value = {{"type", {"string", "number", "boolean"}}};
  Json axes = {{"type", "object"}};
  axes["additionalProperties"] = {{"anyOf", {list_of(std::move(value)), std::move(range)}}};
  Json sweep = axes;
  sweep["properties"]["zipped"] = axes;
  return sweep;
}

// A file that includes others may leave to them what a suite must say.
Json said_or_included(const std::vector<std::string>& needed) {
  return {{"anyOf", {Json{{"required", needed}}, Json{{"required", {"include"}}}}}};
}

}  // namespace

std::string suite_schema(const FileKeys& keys) {
  Json suite = object_schema(keys.suite);
  suite.update(said_or_included({"suite", "scenarios", "vehicles", "planners"}));
  put(suite, "include", {{"anyOf", {Json{{"type", "string"}}, list_of({{"type", "string"}})}}});
  put(suite, "sweep", sweep_schema(keys));
  Json sources = scenario_sources(keys);
  Json file = object_schema(keys.file);
  file["required"] = {"file"};
  sources.push_back(std::move(file));
  put(suite, "scenarios", list_of({{"anyOf", std::move(sources)}}));
  put(suite, "vehicles", list_of(vehicle_schema(keys)));
  put(suite, "planners", list_of(planner_schema(keys)));
  put(suite, "acceptance", {{"type", "array"}, {"items", object_schema(keys.criterion)}});
  return titled("Voronaut suite", suite).dump(1) + "\n";
}

std::string scenario_schema(const FileKeys& keys) {
  return titled("Voronaut scenario", {{"anyOf", scenario_sources(keys)}}).dump(1) + "\n";
}

}  // namespace voronaut
