#pragma once

#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "voronaut/environments/config/config_reader.h"

namespace voronaut {

// Writes the members of a Config into a JSON object, in the order of the visit list.
class ConfigJson {
 public:
  nlohmann::ordered_json object = nlohmann::ordered_json::object();

  void number(std::string_view key, double& value, double, double) { put(key, value); }
  void count(std::string_view key, int& value, int, int) { put(key, value); }
  void flag(std::string_view key, bool& value) { put(key, value); }
  void text(std::string_view key, std::string& value) { put(key, value); }
  template <class Enum>
  void choice(std::string_view key, Enum& value, ChoiceList<std::type_identity_t<Enum>> options) {
    for (const auto& [name, option] : options)
      if (option == value) put(key, std::string(name));
  }

 private:
  template <class Value>
  void put(std::string_view key, const Value& value) {
    object[std::string(key)] = value;
  }
};

template <class Config>
nlohmann::ordered_json config_json(Config config) {
  ConfigJson writer;
  config.visit(writer);
  return std::move(writer.object);
}

}  // namespace voronaut
