#include "voronaut/benchmarks/suite/config_json.h"

namespace voronaut {
namespace {

class JsonWriter : public KeyVisitor {
 public:
  nlohmann::ordered_json object = nlohmann::ordered_json::object();

  void number(std::string_view key, double& value, double, double, std::string_view) override {
    put(key, value);
  }
  void flag(std::string_view key, bool& value, std::string_view) override { put(key, value); }
  void text(std::string_view key, std::string& value, std::string_view) override {
    put(key, value);
  }
  void form(std::string_view, std::string_view, std::string_view) override {}
  bool all_groups() const override { return false; }

 private:
  void whole_number(std::string_view key, std::int64_t& value, std::int64_t, std::int64_t,
                    std::string_view) override {
    put(key, value);
  }
  void one_of(std::string_view key, const std::vector<std::string>& names, std::size_t& chosen,
              std::string_view) override {
    if (chosen < names.size()) put(key, names[chosen]);
  }
  void nested(std::string_view key, const VisitKeys& keys, std::string_view) override {
    put(key, keys_json(keys));
  }

  template <class Value>
  void put(std::string_view key, const Value& value) {
    object[std::string(key)] = value;
  }
};

}  // namespace

nlohmann::ordered_json keys_json(const VisitKeys& keys) {
  JsonWriter writer;
  keys(writer);
  return std::move(writer.object);
}

}  // namespace voronaut
