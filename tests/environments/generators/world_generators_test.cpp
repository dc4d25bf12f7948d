#include "voronaut/environments/generators/world_generators.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "voronaut/environments/scenario/scenario_spec.h"
#include "voronaut/environments/world.h"

namespace voronaut {
namespace {

WorldGenerator generator_of(const std::string& yaml) {
  return WorldGenerator::read(ConfigNode::parse(yaml, "generator.yaml"));
}

// Every coordinate of a world to its last bit.
std::uint64_t fingerprint(const GeneratedWorld& world) {
  const auto spec = ScenarioSpec::fixed(
      {}, std::make_shared<const World>(world.bounds, world.shapes), world.start, world.goal);
  return derive_seed(0, {spec.definition()}, 0);
}

// Smallest distance between the surfaces of any two circles.
double smallest_gap_m(const std::vector<Circle>& circles) {
  double gap_m = 1e9;
  for (std::size_t i = 0; i < circles.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      gap_m = std::min(gap_m, (circles[i].center - circles[k].center).norm() - circles[i].radius_m -
                                  circles[k].radius_m);
  return gap_m;
}

// A lattice of this spacing, 8 neighbours: if the centre of a disc of radius c has any path at all,
// the lattice points nearest to it make one with a clearance of c - spacing / sqrt(2).
bool lattice_path_exists(const GeneratedWorld& generated, double clearance_m) {
  constexpr double kSpacing = 0.1;
  const World world(generated.bounds, generated.shapes);
  const Vec2 size = generated.bounds.max - generated.bounds.min;
  const int columns = static_cast<int>(size.x() / kSpacing) + 2;
  const int rows = static_cast<int>(size.y() / kSpacing) + 2;
  const auto index_near = [&](const Vec2& p) {
    const Vec2 cell = (p - generated.bounds.min) / kSpacing;
    return static_cast<int>(std::lround(cell.y())) * columns +
           static_cast<int>(std::lround(cell.x()));
  };
  std::vector<bool> seen(static_cast<std::size_t>(columns) * rows, false);
  std::vector<int> open = {index_near(generated.start)};
  seen[open[0]] = true;
  while (!open.empty()) {
    const int at = open.back();
    open.pop_back();
    if (at == index_near(generated.goal)) return true;
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        const int column = at % columns + dx;
        const int row = at / columns + dy;
        if (column < 0 || column >= columns || row < 0 || row >= rows) continue;
        const int next = row * columns + column;
        if (seen[next]) continue;
        seen[next] = true;
        const Vec2 p = generated.bounds.min + kSpacing * Vec2(column, row);
        if (world.clearance_m(p) >= clearance_m - kSpacing * std::numbers::sqrt2 / 2)
          open.push_back(next);
      }
  }
  return false;
}

TEST(WorldGenerators, DrawTheSameWorldEverywhere) {
  const std::map<std::string, std::uint64_t> golden = {
      {"forest", 2973954188531019210U},       {"paper_scene", 3700537497959087048U},
      {"goal_side", 1948422238153393058U},    {"grid", 405858757016234566U},
      {"walls", 191190340412144861U},         {"u_trap", 4258767817600724485U},
      {"bug_trap", 1798105316034852545U},     {"spiral", 1047582761807063031U},
      {"rooms", 9971088016213874U},           {"maze", 113929621414105412U},
      {"braided_maze", 1264436531921083751U}, {"narrow_gaps", 888876935191077223U},
      {"thin_posts", 2164538031091591122U},   {"enclosed_goal", 4052741352449514940U},
  };
  for (const std::string& name : WorldGenerator::names()) {
    const WorldGenerator generator = WorldGenerator::named(name);
    ASSERT_EQ(golden.count(name), 1U) << name << " " << fingerprint(generator.generate(1));
    EXPECT_EQ(fingerprint(generator.generate(1)), golden.at(name)) << name;
    EXPECT_NE(fingerprint(generator.generate(2)), golden.at(name)) << name;
  }
}

TEST(WorldGenerators, DrawEqualWorldsFromEqualSeedsAndOthersFromOthers) {
  for (const std::string& name : WorldGenerator::names()) {
    std::set<std::uint64_t> worlds;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      const std::uint64_t world = fingerprint(WorldGenerator::named(name).generate(seed));
      EXPECT_EQ(fingerprint(WorldGenerator::named(name).generate(seed)), world) << name << seed;
      EXPECT_TRUE(worlds.insert(world).second) << name << " seed " << seed;
    }
  }
}

TEST(WorldGenerators, PlaceStartAndGoalInTheOpen) {
  for (const std::string& name : WorldGenerator::names()) {
    const WorldGenerator generator = WorldGenerator::named(name);
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      const GeneratedWorld generated = generator.generate(seed);
      const World world(generated.bounds, generated.shapes);
      for (const Vec2& p : {generated.start, generated.goal}) {
        EXPECT_EQ(placement_problem(world, p), "") << name << " seed " << seed;
        EXPECT_GE(world.clearance_m(p), 0.42) << name << " seed " << seed;
      }
      EXPECT_GT((generated.goal - generated.start).norm(), 2) << name << " seed " << seed;
    }
  }
}

TEST(WorldGenerators, AdmitOnlyWorldsWithAPath) {
  for (const std::string& name : WorldGenerator::names()) {
    const WorldGenerator generator = WorldGenerator::named(name);
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
      const bool path = lattice_path_exists(generator.generate(seed), 0.42);
      EXPECT_EQ(path, name != "enclosed_goal") << name << " seed " << seed;
    }
  }
}

TEST(WorldGenerators, AdmitWhatADiscATwentiethLargerThanThePlanningClearanceCanCross) {
  const auto admitted = [](const std::string& text, double planning_clearance_m) {
    WorldGenerator generator = generator_of(text);
    generator.admit_for(planning_clearance_m);
    for (const auto& [key, value] : generator.entries())
      if (key == "admission_clearance_m") return value;
    return std::string();
  };
  EXPECT_EQ(admitted("{name: forest}", 0.4), "0.42");
  EXPECT_EQ(admitted("{name: forest}", 0.31), "0.326") << "rounded up";
  EXPECT_EQ(admitted("{name: forest, admission_clearance_m: 0.5}", 0.31), "0.5") << "given";
  EXPECT_EQ(admitted("{name: narrow_gaps}", 0.31), "0") << "every draw is admitted";
  // A gap of 0.75 m, for 0.4 m and for 0.35 m.
  WorldGenerator walls = generator_of("{name: walls, gap_m: 0.75, draws_max: 3}");
  walls.admit_for(0.4);
  EXPECT_THROW(walls.generate(1), ConfigError);
  walls.admit_for(0.35);
  EXPECT_NO_THROW(walls.generate(1));
}

TEST(WorldGenerators, RefuseWorldsThatNobodyCanCross) {
  const WorldGenerator hopeless = generator_of("{name: walls, gap_m: 0.8, draws_max: 3}");
  EXPECT_THROW(hopeless.generate(1), ConfigError);
  const WorldGenerator passable = generator_of("{name: walls, gap_m: 0.86, draws_max: 3}");
  EXPECT_NO_THROW(passable.generate(1));
  const WorldGenerator unchecked =
      generator_of("{name: walls, gap_m: 0.8, draws_max: 1, admission_clearance_m: 0}");
  EXPECT_NO_THROW(unchecked.generate(1));
}

TEST(WorldGenerators, SayThatNothingCanBePlacedWithoutTryingAllDraws) {
  const WorldGenerator crowded =
      generator_of("{name: forest, side_m: 30, density_per_m2: 1, draws_max: 100000}");
  try {
    crowded.generate(1);
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_NE(std::string(error.what()).find("in 25 draws from seed 1: 25 could not be placed"),
              std::string::npos)
        << error.what();
  }
}

TEST(WorldGenerators, NameTheFamilyThatWasMeant) {
  try {
    WorldGenerator::named("forrest");
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("did you mean 'forest'?"), std::string::npos);
  }
}

TEST(Forest, KeepsItsDensityAndItsGaps) {
  for (const double density : {0.05, 0.1, 0.15, 0.2, 0.25})
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      const auto generated =
          generator_of("{name: forest, density_per_m2: " + number_text(density) + "}")
              .generate(seed);
      const auto& trees = generated.shapes.circles;
      EXPECT_EQ(trees.size(), static_cast<std::size_t>(std::lround(density * 400)));
      EXPECT_GE(smallest_gap_m(trees), 0.2 - 1e-12) << density << " seed " << seed;
      for (const Circle& tree : trees) {
        EXPECT_GE(tree.radius_m, 0.3);
        EXPECT_LE(tree.radius_m, 0.6);
        EXPECT_TRUE((Bounds{{0, 0}, {20, 20}}).contains(tree.center));
      }
    }
}

TEST(PaperScene, KeepsItsGapsAndRadii) {
  const WorldGenerator generator = WorldGenerator::named("paper_scene");
  std::map<std::size_t, int> counts;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const GeneratedWorld scene = generator.generate(seed);
    const auto& circles = scene.shapes.circles;
    ++counts[circles.size()];
    EXPECT_GE(smallest_gap_m(circles), 1.2 - 1e-12) << "seed " << seed;
    for (const Circle& circle : circles) {
      EXPECT_TRUE(circle.radius_m == 0.5 || circle.radius_m == 1);
      EXPECT_LE(std::abs(circle.center.y()), 2.5);
      for (const Vec2& end : {scene.start, scene.goal})
        EXPECT_GE((circle.center - end).norm() - circle.radius_m, 1 - 1e-12) << "seed " << seed;
    }
  }
  EXPECT_EQ(counts.begin()->first, 2U);
  EXPECT_EQ(counts.rbegin()->first, 7U);
}

TEST(PaperScene, IsTheSameSceneTurnedAtEveryBearing) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    const GeneratedWorld straight = WorldGenerator::named("paper_scene").generate(seed);
    for (int eighth = 1; eighth < 8; ++eighth) {
      const double bearing = eighth * std::numbers::pi / 4;
      const GeneratedWorld scene =
          generator_of("{name: paper_scene, bearing_rad: " + number_text(bearing) + "}")
              .generate(seed);
      const Eigen::Rotation2Dd turn(bearing);
      ASSERT_EQ(scene.shapes.circles.size(), straight.shapes.circles.size());
      EXPECT_LT((scene.goal - turn * straight.goal).norm(), 1e-12);
      for (std::size_t i = 0; i < scene.shapes.circles.size(); ++i)
        EXPECT_LT(
            (scene.shapes.circles[i].center - turn * straight.shapes.circles[i].center).norm(),
            1e-12)
            << "seed " << seed;
    }
  }
}

TEST(NarrowGaps, HaveTheStatedFreeWidth) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const auto world = generator_of("{name: narrow_gaps, gap_m: 0.72, walls: 2}").generate(seed);
    ASSERT_EQ(world.shapes.polygons.size(), 4U);
    for (std::size_t i = 0; i < 4; i += 2) {
      const double below_m = bounds_of(world.shapes.polygons[i]).max.y();
      const double above_m = bounds_of(world.shapes.polygons[i + 1]).min.y();
      EXPECT_NEAR(above_m - below_m, 0.72, 1e-12);
    }
  }
}

TEST(Walls, HaveGapsOfTheStatedFreeWidthBetweenCaps) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const auto world = generator_of("{name: walls, walls: 1, gap_m: 1.5}").generate(seed);
    // The only two circles that stand on the wall but not on the side walls.
    std::vector<Circle> caps;
    for (const Circle& cap : world.shapes.circles)
      if (cap.center.x() == 4 && cap.center.y() > 0 && cap.center.y() < 10) caps.push_back(cap);
    ASSERT_EQ(caps.size(), 2U);
    EXPECT_NEAR(smallest_gap_m(caps), 1.5, 1e-12);
  }
}

TEST(Maze, JoinsAnyTwoCellsByOnePathOnly) {
  constexpr int kCells = 6;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const auto generated = generator_of("{name: maze, cells: 6}").generate(seed);
    const World world(generated.bounds, generated.shapes);
    const auto center = [](int cell) {
      return Vec2(2 * (cell % kCells) + 1, 2 * (cell / kCells) + 1);
    };
    // Cells joined to cell 0 through open walls, and how many walls are open: a tree of n cells has
    // n - 1 edges.
    int open_walls = 0;
    std::vector<int> joined(kCells * kCells);
    for (int cell = 0; cell < kCells * kCells; ++cell) joined[cell] = cell;
    for (int cell = 0; cell < kCells * kCells; ++cell)
      for (const int next : {cell + 1, cell + kCells}) {
        const bool inside = next == cell + 1 ? next % kCells != 0 : next < kCells * kCells;
        if (!inside || !world.segment_is_clear(center(cell), center(next), 0.3)) continue;
        ++open_walls;
        std::replace(joined.begin(), joined.end(), int{joined[next]}, int{joined[cell]});
      }
    EXPECT_EQ(open_walls, kCells * kCells - 1) << "seed " << seed;
    EXPECT_EQ(std::count(joined.begin(), joined.end(), joined[0]), kCells * kCells)
        << "seed " << seed;
  }
}

}  // namespace
}  // namespace voronaut
