#include "voronaut/environments/generators/world_generators.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "voronaut/environments/config/nearest_name.h"
#include "voronaut/environments/generators/fields.h"
#include "voronaut/environments/generators/mazes.h"
#include "voronaut/environments/generators/paper_scene.h"
#include "voronaut/environments/generators/traps.h"
#include "voronaut/environments/generators/walls.h"
#include "voronaut/environments/shortest_path/shortest_path.h"
#include "voronaut/environments/world.h"

namespace voronaut {
namespace {

constexpr const char* kAdmissionKey = "admission_clearance_m";
// Times the planning clearance.
constexpr double kAdmitted = 1.05;
// Where nobody said who flies.
constexpr double kAdmitted_m = 0.42;
// Families about infeasibility: a world is admitted as it is drawn.
constexpr double kUnchecked = 0;
// After so many first draws of which none could be placed, what is asked is taken for impossible:
// it would otherwise cost draws_max times as much to say so.
constexpr int kMostUnplaced = 25;

template <class FamilyConfig>
struct GeneratorConfig {
  FamilyConfig family;
  AdmissionConfig admission;

  template <class Visitor>
  void visit(Visitor& v) {
    family.visit(v);
    admission.visit(v);
  }
};

// Every "..._max..." whose "..._min..." exceeds it is refused.
void require_ordered_ranges(const ConfigNode& node, const ConfigEntries& entries) {
  for (const auto& [low_key, low] : entries) {
    const std::size_t at = low_key.find("_min");
    if (at == std::string::npos) continue;
    std::string high_key = low_key;
    high_key.replace(at, 4, "_max");
    for (const auto& [key, high] : entries) {
      if (key != high_key || *parse_number(low) <= *parse_number(high)) continue;
      std::string problem = low_key;
      problem.append(" (").append(low).append(") is above ");
      problem.append(high_key).append(" (").append(high).append(")");
      throw node.find(high_key).value_or(node).error(problem);
    }
  }
}

}  // namespace

struct WorldGenerator::Family {
  std::string name;
  std::function<WorldGenerator(const ConfigNode*)> make;  // null: with the defaults
  std::vector<KeyFact> keys;
};

template <class Config>
WorldGenerator::Family WorldGenerator::family(std::string name, const Config& defaults,
                                              double admission_clearance_m) {
  GeneratorConfig<Config> own{defaults, {}};
  own.admission.admission_clearance_m = admission_clearance_m;
  const auto make = [name, own](const ConfigNode* node) {
    GeneratorConfig<Config> config = own;
    if (node != nullptr) {
      read_into(*node, config, {"name"});
      require_ordered_ranges(*node, config_entries(config));
    }
    WorldGenerator generator;
    generator.name_ = name;
    generator.entries_ = config_entries(config);
    generator.entries_.insert(generator.entries_.begin(), {"name", name});
    generator.admission_ = config.admission;
    generator.admission_is_given_ = node != nullptr && node->find(kAdmissionKey).has_value();
    generator.draw_ = [drawn = config.family](Random& random) { return draw_world(drawn, random); };
    if (node != nullptr) generator.place_ = *node;
    return generator;
  };
  return {name, make, key_facts(own)};
}

const std::vector<WorldGenerator::Family>& WorldGenerator::families() {
  MazeConfig braided;
  braided.opened = 0.2;
  static const std::vector<Family> all = {
      family("forest", ForestConfig{}, kAdmitted_m),
      family("paper_scene", PaperSceneConfig{}, kAdmitted_m),
      family("goal_side", GoalSideConfig{}, kAdmitted_m),
      family("grid", GridConfig{}, kAdmitted_m),
      family("walls", WallsConfig{}, kAdmitted_m),
      family("u_trap", UTrapConfig{}, kAdmitted_m),
      family("bug_trap", BugTrapConfig{}, kAdmitted_m),
      family("spiral", SpiralConfig{}, kAdmitted_m),
      family("rooms", RoomsConfig{}, kAdmitted_m),
      family("maze", MazeConfig{}, kAdmitted_m),
      family("braided_maze", braided, kAdmitted_m),
      family("narrow_gaps", NarrowGapsConfig{}, kUnchecked),
      family("thin_posts", ThinPostsConfig{}, kAdmitted_m),
      family("enclosed_goal", EnclosedGoalConfig{}, kUnchecked),
  };
  return all;
}

std::vector<std::string> WorldGenerator::names() {
  std::vector<std::string> names;
  for (const Family& family : families()) names.push_back(family.name);
  return names;
}

WorldGenerator WorldGenerator::read(const ConfigNode& node) {
  return families()[node.child("name").choice(names())].make(&node);
}

WorldGenerator WorldGenerator::named(std::string_view name) {
  return family_named(name).make(nullptr);
}

std::vector<KeyFact> WorldGenerator::keys(std::string_view name) { return family_named(name).keys; }

const WorldGenerator::Family& WorldGenerator::family_named(std::string_view name) {
  for (const Family& family : families())
    if (family.name == name) return family;
  throw std::invalid_argument("no generator " + in_quotes(name) + allowed_names(name, names()));
}

bool WorldGenerator::admits(const GeneratedWorld& drawn) const {
  if (admission_.admission_clearance_m == 0) return true;
  const World world(drawn.bounds, drawn.shapes);
  return shortest_path(world, drawn.start, drawn.goal, admission_.admission_clearance_m)
      .has_value();
}

void WorldGenerator::admit_for(double planning_clearance_m) {
  if (admission_is_given_ || admission_.admission_clearance_m == kUnchecked) return;
  // Up to whole millimetres, or a product's last digits would stand in names of worlds.
  constexpr double kRounding_mm = 1e-6;
  const double admitted_mm = std::ceil(1000 * kAdmitted * planning_clearance_m - kRounding_mm);
  admission_.admission_clearance_m = admitted_mm / 1000;
  for (auto& [key, value] : entries_)
    if (key == kAdmissionKey) value = number_text(admission_.admission_clearance_m);
}

GeneratedWorld WorldGenerator::generate(std::uint64_t seed) const {
  Random random(seed);
  int draws = 0;
  int unplaced = 0;
  while (draws < admission_.draws_max && (unplaced < draws || unplaced < kMostUnplaced)) {
    WorldDraw drawn = draw_(random);
    ++draws;
    if (!drawn)
      ++unplaced;
    else if (admits(*drawn))
      return *std::move(drawn);
  }
  throw error("no '" + name_ + "' world in " + std::to_string(draws) + " draws from seed " +
              std::to_string(seed) + ": " + std::to_string(unplaced) + " could not be placed, " +
              std::to_string(draws - unplaced) + " have no path for a disc of radius " +
              number_text(admission_.admission_clearance_m) + " m");
}

ConfigError WorldGenerator::error(const std::string& problem) const {
  return place_ ? place_->error(problem) : ConfigError("generator " + name_, 0, "", problem);
}

}  // namespace voronaut
