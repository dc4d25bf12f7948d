#include "voronaut/environments/scenario_files/scenario_reader.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "voronaut/environments/world.h"

namespace voronaut {
namespace {

const std::string kTail = "bounds: [[-2, -4], [10, 4]]\nstart: [0, 0]\ngoal: [8, 6e-1]\n";

std::vector<ScenarioSpec> read(const std::string& yaml, const DataLocation& data = {},
                               const std::string& file = "pillar.yaml") {
  return read_scenarios(ConfigNode::parse(yaml, file), data);
}

std::string error_of(const std::string& yaml, const DataLocation& data) {
  try {
    read(yaml, data);
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "no error";
}

// A folder that goes away with the test.
class Folder {
 public:
  explicit Folder(const std::string& name) : path_(testing::TempDir() + "/voronaut_" + name) {
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
  }
  ~Folder() { std::filesystem::remove_all(path_); }

  void write(const std::string& file, const std::string& text) const {
    const std::filesystem::path path = path_ / file;
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path) << text;
  }
  std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

TEST(Scenario, ReadsAWorldOfEveryShape) {
  const auto specs = read(
      "group: mine\ncruise_height_m: 1.5\nstart_heading_rad: 1.5707963267948966\n"
      "world:\n  circles: [[4, 0, 0.5]]\n  boxes: [[5, 1, 6, 3]]\n"
      "  polygons: [[[2, 2], [2, 3], [3, 3]]]\n  segments: [[[1, -1], [1, -2]]]\n" +
      kTail);
  ASSERT_EQ(specs.size(), 1U);
  EXPECT_FALSE(specs[0].random());
  const Scenario scenario = specs[0].instantiate(7);
  EXPECT_EQ(scenario.name, "pillar");
  EXPECT_EQ(scenario.group, "mine");
  EXPECT_EQ(scenario.cruise_height_m, 1.5);
  EXPECT_EQ(scenario.goal_world, Vec2(8, 0.6));
  EXPECT_NEAR(scenario.start_heading.x(), 0, 1e-15);
  EXPECT_NEAR(scenario.start_heading.y(), 1, 1e-15);
  EXPECT_EQ(scenario.world->shapes().circles.size(), 1U);
  EXPECT_EQ(scenario.world->shapes().segments.size(), 1U);
  EXPECT_NEAR(scenario.world->clearance_m({5.5, 2}), -0.5, 1e-12);
  EXPECT_EQ(scenario.world->bounds().max, Vec2(10, 4));
  EXPECT_EQ(specs[0].instantiate(8).world, scenario.world);
}

TEST(Scenario, LooksTowardsTheGoalUnlessTold) {
  const Scenario scenario = read("world: {}\n" + kTail)[0].instantiate(0);
  EXPECT_NEAR(scenario.start_heading.norm(), 1, 1e-15);
  EXPECT_NEAR(cross(scenario.start_heading, scenario.goal_world), 0, 1e-14);
}

TEST(Scenario, NeedsANameInsideAList) {
  const ConfigNode suite = ConfigNode::parse(
      "scenarios:\n  - {world: {}, bounds: [[-1, -1], [3, 3]], start: [0, 0], "
      "goal: [2, 0]}\n",
      "suite.yaml");
  try {
    read_scenarios(suite.child("scenarios").items()[0], {});
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_STREQ(error.what(), "suite.yaml:2: key 'scenarios[0].name': missing");
  }
}

TEST(Scenario, IsFoundBesideTheFileThatNamesIt) {
  const Folder folder("beside");
  folder.write("worlds/pillar.yaml", "world_file: circles.csv\nname: post\n" + kTail);
  folder.write("worlds/circles.csv", "x, y, r\r\n4,0,0.5\r\n\r\n5,+1,2.5e-1\r\n");
  folder.write("suites/suite.yaml", "scenarios:\n  - file: ../worlds/pillar.yaml\n");
  const ConfigNode suite = ConfigNode::read_file(folder.path() + "/suites/suite.yaml");
  const auto specs = read_scenarios(suite.child("scenarios").items()[0], {});
  ASSERT_EQ(specs.size(), 1U);
  EXPECT_EQ(specs[0].name(), "post");
  const auto& circles = specs[0].instantiate(0).world->shapes().circles;
  ASSERT_EQ(circles.size(), 2U);
  EXPECT_EQ(circles[1].center, Vec2(5, 1));
  EXPECT_EQ(circles[1].radius_m, 0.25);
}

TEST(Scenario, OfAGeneratorIsNewForEverySeed) {
  const auto specs = read("generator: {name: forest, side_m: 10}\nname: grove\n");
  ASSERT_EQ(specs.size(), 1U);
  EXPECT_TRUE(specs[0].random());
  EXPECT_EQ(specs[0].name(), "grove");
  const auto first = specs[0].instantiate(1);
  const auto& circles = first.world->shapes().circles;
  ASSERT_EQ(circles.size(), 10U);
  EXPECT_EQ(specs[0].instantiate(1).world->shapes().circles[3].center, circles[3].center);
  EXPECT_NE(specs[0].instantiate(2).world->shapes().circles[3].center, circles[3].center);
}

TEST(Scenario, HasADefinitionThatChangesWithAnythingButTheGroup) {
  const std::string definition = read("world: {circles: [[4, 0, 0.5]]}\n" + kTail)[0].definition();
  EXPECT_EQ(definition,
            read("group: g\nworld: {circles: [[4.0, 0, 0.5]]}\n" + kTail)[0].definition());
  EXPECT_NE(definition, read("world: {circles: [[4, 0, 0.6]]}\n" + kTail)[0].definition());
  EXPECT_NE(definition,
            read("goal_tolerance_m: 1\nworld: {circles: [[4, 0, 0.5]]}\n" + kTail)[0].definition());
  EXPECT_NE(read("generator: {name: forest}")[0].definition(),
            read("generator: {name: forest, gap_min_m: 0.3}")[0].definition());
}

TEST(DataSets, GiveOneScenarioForEachWorld) {
  const Folder data("data");
  data.write("barn/worlds.csv",
             "world,n_cylinders,start_x,start_y,goal_x,goal_y,ref_path_len_m\n1,2,-2.25,3,-2.25,13,"
             "12.4312\n"
             "20,2,-2.25,3,-2.25,13,11.95\n");
  data.write("barn/obstacles/world_001.csv", "x,y,r\n-2,6,0.075\n");
  data.write("barn/obstacles/world_020.csv", "x,y,r\n-2,7,0.075\n-3,7,0.075\n");
  data.write("dodgedrone/index.csv", "env,n_spheres\neasy_0,2\nhard_1,1\n");
  data.write("dodgedrone/easy_0/slice_z1.csv", "x,y,r\n5,0,1\n");
  data.write("dodgedrone/hard_1/slice_z1.csv", "x,y,r\n5,1,1\n");
  const DataLocation location{data.path(), "--data"};

  const auto barn = read("dataset: barn", location);
  ASSERT_EQ(barn.size(), 2U);
  EXPECT_EQ(barn[0].name(), "barn_001");
  EXPECT_EQ(barn[1].name(), "barn_020");
  EXPECT_EQ(barn[1].group(), "barn");
  const Scenario world = barn[1].instantiate(0);
  EXPECT_EQ(world.barn_length_m, 11.95);
  EXPECT_EQ(world.world->shapes().circles.size(), 2U);
  EXPECT_EQ(world.start_heading, Vec2(0, 1));
  EXPECT_EQ(world.goal_world, Vec2(-2.25, 13));

  EXPECT_EQ(read("dataset: barn\nlimit: 1", location).size(), 1U);
  const auto picked = read("dataset: dodgedrone\npick: [dodgedrone_hard_1]", location);
  ASSERT_EQ(picked.size(), 1U);
  EXPECT_EQ(picked[0].name(), "dodgedrone_hard_1");
  EXPECT_EQ(picked[0].instantiate(0).goal_world, Vec2(18, 0));

  EXPECT_EQ(
      error_of("dataset: barn\npick: [barn_02]", location),
      "pillar.yaml:1: key 'dataset': no world 'barn_02' among the 2 of this data set (did you mean "
      "'barn_020'?)");
  EXPECT_EQ(error_of("dataset: barn\npick: [barn_001]\nlimit: 1", location),
            "pillar.yaml:3: key 'limit': cannot stand beside 'pick'");
  EXPECT_EQ(error_of("name: x\ndataset: barn", location),
            "pillar.yaml:1: key 'name': the worlds of a data set have names of their own; use "
            "group");
}

TEST(DataSets, OfMapsGiveOneScenarioForEachSelectedQuery) {
  const Folder data("maps");
  data.write("mrpb/queries.csv",
             "map,query,xmin,xmax,ymin,ymax,start_x,start_y,goal_x,goal_y\n"
             "room,0,-1,1,-1,1,-0.75,0.75,0.75,0.75\nroom,1,-1,1,-1,1,0.75,0.75,-0.75,0.75\n");
  data.write("mrpb/room/map.yaml",
             "image: map.pgm\nresolution: 0.5\norigin: [-1, -1, 0]\noccupied_thresh: 0.65\n"
             "free_thresh: 0.196\n");
  data.write("mrpb/room/map.pgm",
             "P2 4 4 255\n254 254 254 254\n254 254 254 254\n254 0 205 254\n254 0 0 254\n");
  data.write("movingai/index.csv", "family,map,width,height\nmazes,m,20,4\n");
  std::string rows;
  for (int i = 0; i < 4; ++i) rows += "....................\n";
  data.write("movingai/mazes/m.map", "type octile\nheight 4\nwidth 20\nmap\n" + rows);
  std::string queries = "version 1\n";
  for (int x = 0; x < 10; ++x)
    queries += "0\tm\t20\t4\t" + std::to_string(x) + "\t1\t19\t2\t" + std::to_string(19 - x) + "\n";
  data.write("movingai/mazes/m.map.scen", queries);
  const DataLocation location{data.path(), "--data"};

  const auto rooms = read("dataset: mrpb", location);
  ASSERT_EQ(rooms.size(), 2U);
  EXPECT_EQ(rooms[1].name(), "mrpb_room_1");
  const Scenario room = rooms[0].instantiate(0);
  EXPECT_EQ(room.world, rooms[1].instantiate(0).world);  // shared
  EXPECT_EQ(room.world->shapes().polygons.size(), 1U);   // with the unknown one a square
  EXPECT_LT(room.world->clearance_m({0.25, -0.25}), 0);
  EXPECT_GT(read("dataset: mrpb\nunknown: free", location)[0].instantiate(0).world->clearance_m(
                {0.25, -0.25}),
            0);

  const auto sampled = read("dataset: movingai\ncell_size_m: 1", location);
  ASSERT_EQ(sampled.size(), 2U);  // two a map unless told otherwise
  EXPECT_EQ(sampled[0].name(), read("dataset: movingai\ncell_size_m: 1", location)[0].name());
  const auto all =
      read("dataset: movingai\nqueries: {sample: 0, clearance_m: 0, shortest_m: 0}", location);
  ASSERT_EQ(all.size(), 10U);
  EXPECT_EQ(all[3].name(), "movingai_m_3");
  EXPECT_EQ(all[3].instantiate(0).start_world, Vec2(0.875, 0.625));
  const auto long_ones =
      read("dataset: movingai\nqueries: {sample: 0, clearance_m: 0.2, shortest_m: 0, longest_m: 3}",
           location);
  EXPECT_EQ(long_ones.size(), 3U);  // 10, 11 and 12 cells of 0.25 m
  EXPECT_EQ(read("dataset: movingai\npick: [movingai_m_7]", location)[0].name(), "movingai_m_7");
}

TEST(WorldFiles, AreCutAtTheHeightThatTheScenarioFlies) {
  const Folder folder("heights");
  const auto body = [](const std::string& pose, const std::string& size) {
    return "<model name='m'><pose>" + pose +
           " 0 0 0</pose><link name='l'><collision name='c'><geometry>" + "<box><size>" + size +
           "</size></box></geometry></collision></link></model>";
  };
  const auto sdf = [](const std::string& models) {
    return "<sdf version='1.6'><world name='w'>" + models + "</world></sdf>";
  };
  const std::string kerb = body("4 0 0.1", "1 6 0.2");
  folder.write("door.world", sdf(kerb + body("4 0 2.4", "1 6 0.4") + body("4 3 1", "1 1 2")));
  folder.write("kerb.world", sdf(kerb));
  const auto clearance_m = [&](const std::string& keys) {
    return read(keys + "\n" + kTail, {}, folder.path() + "/s.yaml")[0]
        .instantiate(0)
        .world->clearance_m({4, 0});
  };
  EXPECT_EQ(clearance_m("world_file: door.world"), 2.5);
  EXPECT_LT(clearance_m("world_file: door.world\ncruise_height_m: 2.3"), 0);
  EXPECT_LT(clearance_m("world_file: door.world\ncruise_height_m: 0.15"), 0);
  EXPECT_LT(clearance_m("world_file: door.world\nheight_m: 0.15"), 0);
  EXPECT_LT(clearance_m("world_file: door.world\ncut: columns"), 0);
  EXPECT_EQ(clearance_m("world_file: kerb.world\ncruise_height_m: 1"),
            std::numeric_limits<double>::infinity());
  // All bodies below a height that nobody gave.
  try {
    clearance_m("world_file: kerb.world");
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_EQ(std::string(error.what()).substr(folder.path().size()),
              "/s.yaml:1: key 'world_file': none of its 1 bodies reaches the height of flight, 1 m "
              "unless cruise_height_m is given (or height_m, or cut: columns for all of them)");
  }
}

TEST(WorldFiles, GiveTheHeadingOfTheirStart) {
  const Folder folder("headings");
  folder.write("back.yaml", "robot: {state: [2, 3, 1.5707963267948966], goal: [8, 3]}\n");
  const auto heading = [&](const std::string& keys) {
    return read("world_file: back.yaml\n" + keys, {}, folder.path() + "/s.yaml")[0]
        .instantiate(0)
        .start_heading;
  };
  EXPECT_NEAR((heading("") - Vec2(0, 1)).norm(), 0, 1e-12);
  EXPECT_EQ(heading("start_heading_rad: 0"), Vec2(1, 0));
  EXPECT_EQ(heading("goal: [2, 9]\nstart: [4, 9]"), Vec2(-1, 0));  // the file's start is not flown
}

TEST(DataSets, SayHowToNameTheFolderThatIsMissing) {
  EXPECT_EQ(error_of("dataset: barn", {}),
            "pillar.yaml:1: key 'dataset': 'barn' lies in the data folder, which is not known: "
            "give --data DIR or set VORONAUT_DATA");
  EXPECT_EQ(error_of("dataset: barn", {"/nowhere", "VORONAUT_DATA"}),
            "pillar.yaml:1: key 'dataset': no folder '/nowhere/barn' (data folder from "
            "VORONAUT_DATA; give --data DIR or set VORONAUT_DATA)");
}

TEST(DataSets, AreLookedForWhereTheArgumentOrElseTheEnvironmentSays) {
  setenv("VORONAUT_DATA", "/from/environment", 1);
  EXPECT_EQ(DataLocation::find("/given").folder, "/given");
  EXPECT_EQ(DataLocation::find("").folder, "/from/environment");
  EXPECT_EQ(DataLocation::find("").origin, "VORONAUT_DATA");
  unsetenv("VORONAUT_DATA");
  EXPECT_EQ(DataLocation::find("").folder, "");
}

TEST(ShippedScenarios, AreAllReadable) {
  int files = 0;
  const std::string folder = std::string(VORONAUT_SOURCE_DIR) + "/benchmarks/scenarios";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".yaml") continue;
    ++files;
    const auto specs = read_scenarios(ConfigNode::read_file(entry.path().string()), {});
    ASSERT_EQ(specs.size(), 1U) << entry.path();
    EXPECT_NO_THROW(specs[0].instantiate(1)) << entry.path();
  }
  EXPECT_GE(files, 3);
}

}  // namespace
}  // namespace voronaut
