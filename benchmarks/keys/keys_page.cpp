#include "voronaut/benchmarks/keys/keys_page.h"

#include "voronaut/environments/config/renamed_keys.h"

namespace voronaut {
namespace {

using Kind = KeyFact::Kind;

std::string cell(std::string text) {
  for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2)
    text.insert(at, "\\");
  return text;
}

std::string code(const std::string& text) { return text.empty() ? "" : "`" + text + "`"; }

std::string table(const std::vector<KeyFact>& facts) {
  if (facts.empty()) return "No keys.\n\n";
  std::string text = "| key | allowed | unit | default | |\n|---|---|---|---|---|\n";
  for (const KeyFact& fact : facts) {
    text += "| " + code(fact.key) + " | " + cell(allowed_text(fact)) + " | " +
            unit_of_key(fact.key) + " | " + code(fact.default_text) + " | " + cell(fact.sentence) +
            " |\n";
  }
  return text + "\n";
}

std::string heading(int level, const std::string& text) {
  return std::string(static_cast<std::size_t>(level), '#') + " " + text + "\n\n";
}

// A table for each section, below that of the keys it stands among.
std::string with_sections(const std::vector<KeyFact>& facts, int level) {
  std::string text = table(facts);
  for (const KeyFact& fact : facts) {
    if (fact.kind != Kind::section) continue;
    text += heading(level, "`" + fact.key + "`") + fact.sentence + ".\n\n" +
            with_sections(fact.keys, level + 1);
  }
  return text;
}

// One table for all names with the same keys and defaults.
std::string named_tables(const std::vector<NamedKeys>& all, int level) {
  std::string text;
  for (std::size_t i = 0; i < all.size();) {
    std::string names;
    std::size_t next = i;
    for (; next < all.size() && all[next].keys == all[i].keys; ++next)
      names += (names.empty() ? "`" : ", `") + all[next].name + "`";
    text += heading(level, names) + table(all[i].keys);
    i = next;
  }
  return text;
}

std::string scenario_text(const FileKeys& keys) {
  return heading(2, "Scenarios") +
         "An entry of `scenarios`, or the root of a scenario file. It is one of the following, "
         "with "
         "these keys beside:\n\n" +
         table(keys.task) + heading(3, "A scenario file") + table(keys.file) +
         heading(3, "A world in the file itself") + with_sections(keys.world, 4) +
         heading(3, "A file of another project") + table(keys.world_file) +
         "`queries` as a map:\n\n" + table(keys.query_file) + table(keys.query_selection) +
         "As the format needs them ([formats.md](formats.md)):\n\n" + table(keys.foreign_options) +
         heading(3, "A data set") + table(keys.data_set) + heading(3, "Random worlds") +
         table(keys.generator) +
         "`generator: {name: ...}` with the keys of the family of that name:\n\n" +
         named_tables(keys.generators, 4);
}

// All other sections of a vehicle are the suite's.
std::string footprint_text(const FileKeys& keys) {
  for (const KeyFact& fact : keys.vehicle)
    if (fact.key == "footprint")
      return heading(3, "`footprint`") + fact.sentence + ".\n\n" + table(fact.keys);
  return "";
}

std::string vehicle_text(const FileKeys& keys) {
  return heading(2, "Vehicles") +
         "An entry of `vehicles` is a name or a map; its sections hold instead of the suite's, key "
         "by key:\n\n" +
         table(keys.vehicle) + footprint_text(keys) + heading(3, "`params`") +
         named_tables(keys.vehicle_params, 4) + heading(3, "`model`") +
         named_tables(keys.vehicle_models, 4) + heading(3, "`regulator`") + "A name or a map:\n\n" +
         table(keys.regulator) + named_tables(keys.regulators, 4);
}

std::string planner_text(const FileKeys& keys) {
  return heading(2, "Planners") + "An entry of `planners` is a name or a map:\n\n" +
         table(keys.planner) + heading(3, "`params`") +
         "OMPL's planners have OMPL's parameters: bounds and defaults are those that OMPL "
         "declares, "
         "bounds wider where a value beyond them makes sense. [ompl.md](ompl.md) says more.\n\n" +
         named_tables(keys.planners, 4);
}

std::string renamed_keys_text() {
  std::string text = heading(2, "Old names") +
                     "A file that still has one of them gets an error that says the new one.\n\n"
                     "| old | new |\n|---|---|\n";
  for (const auto& [old, now] : renamings())
    text += "| " + code(std::string(old)) + " | " + code(std::string(now)) + " |\n";
  return text;
}

}  // namespace

std::string keys_page(const FileKeys& keys) {
  return heading(1, "Keys of suite and scenario files") +
         "`voronaut schema --format md` prints this page. `voronaut schema suite` and `voronaut "
         "schema scenario` print the same as JSON Schema, installed as "
         "`share/voronaut/schema/*.json`; a comment line in a YAML file names it, so that editors "
         "complete and check what is written:\n\n"
         "    # yaml-language-server: $schema=../schema/suite.json\n\n"
         "A file that says nothing of a key gets the default. Bounds are inclusive.\n\n" +
         heading(2, "Suites") + with_sections(keys.suite, 3) + heading(3, "`acceptance`") +
         "Each entry says what the results must show:\n\n" + table(keys.criterion) +
         heading(3, "`sweep`") + "Values by path, a list or a map ([sweeps.md](sweeps.md)):\n\n" +
         table(keys.sweep_range) + scenario_text(keys) + vehicle_text(keys) + planner_text(keys) +
         renamed_keys_text();
}

}  // namespace voronaut
