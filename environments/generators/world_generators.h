#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "voronaut/environments/config/config_node.h"
#include "voronaut/environments/config/config_reader.h"
#include "voronaut/environments/config/key_facts.h"
#include "voronaut/environments/generators/generated_world.h"

// The families of random worlds by name. Each has its Config in generators/.
namespace voronaut {

// Which draws become worlds: no planner shall be blamed for the impossible.
struct AdmissionConfig {
  // A disc of this radius must have a path from start to goal; 0 admits every draw. Where vehicles
  // are known and nobody said otherwise it is WorldGenerator::admit_for()'s.
  double admission_clearance_m = 0.42;
  int draws_max = 200;

  template <class Visitor>
  void visit(Visitor& v) {
    v.number("admission_clearance_m", admission_clearance_m, 0, 10,
             "A disc of this radius must have a path from start to goal; 0 admits every draw. Not "
             "given in a suite: 1.05 times the largest planning_clearance_m of its vehicles, in "
             "whole mm");
    v.count("draws_max", draws_max, 1, 100'000, "So many draws without an admissible world: none");
  }
};

class WorldGenerator {
 public:
  // The families there are.
  static std::vector<std::string> names();
  // Reads {name: forest, <keys of its Config and of AdmissionConfig>}. Throws ConfigError.
  static WorldGenerator read(const ConfigNode& node);
  // A family with its defaults. Throws std::invalid_argument for a name that there is not.
  static WorldGenerator named(std::string_view name);
  // What can be said of a family, with its defaults. Throws the same.
  static std::vector<KeyFact> keys(std::string_view name);

  const std::string& name() const { return name_; }
  // The name and every parameter.
  const ConfigEntries& entries() const { return entries_; }

  // What flies there keeps this clearance when planning: unless what was read says which draws are
  // admitted, or the family admits every draw, a disc a twentieth larger must have a path.
  void admit_for(double planning_clearance_m);

  // The same world for the same seed, everywhere. Draws until one is admitted; throws ConfigError
  // after draws_max, or after the first 25 if none of them could be placed.
  GeneratedWorld generate(std::uint64_t seed) const;

  // For a problem with what it generates: names the place where it was read, else the family.
  ConfigError error(const std::string& problem) const;

 private:
  struct Family;
  static const std::vector<Family>& families();
  static const Family& family_named(std::string_view name);
  template <class Config>
  static Family family(std::string name, const Config& defaults, double admission_clearance_m);

  WorldGenerator() = default;
  bool admits(const GeneratedWorld& world) const;

  std::string name_;
  ConfigEntries entries_;
  std::function<WorldDraw(Random&)> draw_;
  AdmissionConfig admission_;
  bool admission_is_given_ = false;
  std::optional<ConfigNode> place_;  // where it was read
};

}  // namespace voronaut
