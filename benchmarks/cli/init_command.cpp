#include <cctype>
#include <filesystem>
#include <ostream>
#include <stdexcept>
#include <utility>
#include <vector>

#include "voronaut/benchmarks/cli/commands.h"
#include "voronaut/benchmarks/suite/shipped_files.h"
#include "voronaut/reports/store/atomic_file.h"

// A folder to begin with: a suite that says what each of its keys is for, a scenario, and a world
// drawn as text.
namespace voronaut {

namespace {

namespace fs = std::filesystem;

constexpr const char* kSuite =
    R"(# Where names stand, `voronaut list planners`, `vehicles`, `generators` ... prints those there are,
# `voronaut list planners RRTConnect` what one of them may be told. docs/keys.md has every key.

suite: SUITE_NAME   # results go to voronaut-results/SUITE_NAME
seed: 1             # the same seed gives the same flights, bit for bit, on every machine
repetitions: 4      # of each scenario, vehicle and planner; random worlds are new ones each time

scenarios:
  - {file: yard.yaml}                                    # a world in shapes: change it
  - {name: hall, world_file: hall.map, cell_size_m: 0.5, start: [1.75, 5.25], goal: [17.25, 5.25]}
  - {name: wood, generator: {name: forest, side_m: 12, density_per_m2: 0.1}}    # random trees

vehicles:
  - quadrotor
  # - {name: jackal, label: slow_jackal, params: {max_speed_m_s: 1}}

planners:
  - VoronoiRoadmap
  - RRTConnect
  # - {name: RRTConnect, label: short_steps, params: {range: 0.5}}

# What a vehicle sees by, unless said otherwise a fan of 90 degrees ahead:
# range_finder: {max_range_m: 5, noise_sigma_m: 0.01}

# Every flight is careful: a governor vetoes what could not be stopped in time, the vehicle looks
# around before it sets off, looks where it goes, and does something about it when it is stuck. As
# the papers flew, without all that:
# navigation: paper

# Each value makes a planner, vehicle or scenario of its own (docs/sweeps.md):
# sweep: {vehicle.max_speed_m_s: [1, 2]}

# What the results must show. `voronaut run` says what became of it and exits with 1 if it is broken.
acceptance:
  - {collision_share_max: 0}
  - {planner: VoronoiRoadmap, goal_reached_share_min: 1}
)";

constexpr const char* kScenario =
    R"(# Metres, x to the right, y up. `voronaut show yard.yaml -o yard.svg` draws it.
world:
  circles: [[3, 1, 0.5], [7.5, -0.6, 0.7]]             # x, y, radius
  boxes: [[4.5, -3, 5.5, 0.2]]                         # xmin, ymin, xmax, ymax
  polygons: [[[5.5, 2], [8, 1.6], [7, 3.4]]]           # corners
  segments: [[[2, -1], [3, -2.5]]]                     # walls without thickness
bounds: [[-2, -4], [12, 4]]                            # where the vehicle may be
start: [0, 0]
goal: [10, 0]
)";

// Nineteen metres by ten in cells of half a metre.
constexpr const char* kMap = R"(type octile
height 20
width 38
map
@@@@@@@@@@@@@@@@@@@@@@@@@@@@@@@@@@@@@@
@..........@............@............@
@..........@............@............@
@..........@............@............@
@..........@............@............@
@....................................@
@....................................@
@....................................@
@..........@............@............@
@..........@.....@@.....@............@
@..........@.....@@.....@............@
@..........@@@@@@@@@@@@@@............@
@..........@............@............@
@..........@............@............@
@....................................@
@....................................@
@....................................@
@..........@............@............@
@..........@............@............@
@@@@@@@@@@@@@@@@@@@@@@@@@@@@@@@@@@@@@@
)";

// A suite's name has letters, digits, '-', '_' and '.'.
std::string suite_name(const fs::path& folder) {
  std::string name = folder.filename().string();
  for (char& c : name)
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '_' && c != '.') c = '-';
  return name.empty() || name.front() == '.' ? "first" : name.substr(0, 100);
}

// With a line by which editors find the schema that ships.
std::string with_schema(const std::string& text, const std::string& of) {
  const fs::path schema = shipped_folder() / "schema" / (of + ".json");
  std::error_code ignored;
  if (!fs::exists(schema, ignored)) return text;
  return "# yaml-language-server: $schema=" + schema.string() + "\n" + text;
}

std::vector<std::pair<std::string, std::string>> first_files(const std::string& name) {
  std::string suite = kSuite;
  const std::string place = "SUITE_NAME";
  for (std::size_t at = 0; (at = suite.find(place)) != std::string::npos;)
    suite.replace(at, place.size(), name);
  return {{"suite.yaml", with_schema(suite, "suite")},
          {"yard.yaml", with_schema(kScenario, "scenario")},
          {"hall.map", kMap}};
}

}  // namespace

ExitCode execute(const InitOptions& options, const CommandContext& context) {
  fs::path folder = fs::absolute(options.folder).lexically_normal();
  if (!folder.has_filename()) folder = folder.parent_path();
  const bool is_there = fs::exists(folder);
  if (is_there && !fs::is_directory(folder))
    throw std::invalid_argument(options.folder + ": is no folder");
  if (is_there && !fs::is_empty(folder))
    throw std::invalid_argument(options.folder + ": is not empty; name a new folder");

  // All of it or nothing: written beside and moved when it is whole.
  const fs::path made = is_there ? folder / ".part" : fs::path(folder.string() + ".part");
  const auto files = first_files(suite_name(folder));
  fs::create_directories(made);
  try {
    for (const auto& [name, text] : files) write_file_atomically(made / name, text);
    if (is_there) {
      for (const auto& [name, text] : files) fs::rename(made / name, folder / name);
      fs::remove(made);
    } else {
      fs::rename(made, folder);
    }
  } catch (...) {
    std::error_code ignored;
    fs::remove_all(made, ignored);
    throw;
  }
  for (const auto& [name, text] : files)
    context.out << (fs::path(options.folder) / name).string() << "\n";
  context.out << "now: voronaut run " << (fs::path(options.folder) / "suite.yaml").string() << "\n";
  return ExitCode::success;
}

}  // namespace voronaut
