#include "voronaut/environments/formats/foreign_formats.h"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "voronaut/tests/support/error_of.h"

namespace voronaut {
namespace {

class ForeignFormats : public ::testing::Test {
 protected:
  ForeignFormats() { std::filesystem::create_directories(folder_); }
  ~ForeignFormats() override { std::filesystem::remove_all(folder_); }

  std::string write(const std::string& name, const std::string& text) const {
    const std::string path = (folder_ / name).string();
    std::ofstream(path, std::ios::binary) << text;
    return path;
  }

  std::string format_of(const std::string& name, const std::string& text) const {
    return foreign_format("", write(name, text)).name;
  }

  // Without the folder.
  std::string error_in(const std::string& name, const std::string& text) const {
    const std::string path = write(name, text);
    std::string line = error_of<ConfigError>([&] {
      const ForeignFormat& format = foreign_format("", path);
      format.read(path, format.defaults);
    });
    const std::string folder = folder_.string() + "/";
    for (auto at = line.find(folder); at != std::string::npos; at = line.find(folder))
      line.erase(at, folder.size());
    return line;
  }

  std::filesystem::path folder_ = std::filesystem::path(::testing::TempDir()) /
                                  ::testing::UnitTest::GetInstance()->current_test_info()->name();
};

TEST_F(ForeignFormats, AreRecognisedByTheKeysOfTheirYaml) {
  EXPECT_EQ(format_of("m.yaml", "{image: m.pgm, resolution: 1}\n"), "ros_map");
  EXPECT_EQ(format_of("m.yml", "---\n\"image\": m.pgm\n"), "ros_map");
  EXPECT_EQ(format_of("i.yaml", "{world: {height: 1, width: 1}, robot: {}}\n"), "ir_sim");
  EXPECT_EQ(format_of("i.yaml", "world: {height: 1}\nobstacle: []\n"), "ir_sim");
  EXPECT_EQ(format_of("i.yaml", "obstacle: []\n"), "ir_sim");
  EXPECT_TRUE(is_foreign_file(write("i.yaml", "world: {width: 3}\n")));
  EXPECT_FALSE(is_foreign_file(
      write("ours.yaml", "# image: none\nworld: {circles: []}\nname: |\n  robot:\n")));
}

TEST_F(ForeignFormats, MayBeginWithAByteOrderMark) {
  EXPECT_EQ(format_of("e.txt", "\xef\xbb\xbfunits: meter\n"), "ompl_circles");
  EXPECT_EQ(error_in("a.map", "\xef\xbb\xbftype octile\nheight 1\nwidth 1\nmap\n.\n"), "no error");
  EXPECT_EQ(error_in("c.csv", "\xef\xbb\xbfx,y,r\n1,2,3\n"), "no error");
}

TEST_F(ForeignFormats, SayInWhichLineEvenAnEmptyFileIsWrong) {
  EXPECT_EQ(error_in("a.map", ""), "a.map:1: the file ends before 'type'");
  EXPECT_EQ(error_in("a.json", ""), "a.json:1: the file is empty");
  EXPECT_EQ(error_in("a.world", ""), "a.world:1: no <world> in <sdf>");
  EXPECT_EQ(error_in("a.csv", ""), "a.csv:1: the file is empty");
  EXPECT_EQ(error_in("a.yaml", "world: [\n"),
            "a.yaml:1: not valid YAML: end of sequence flow not found");
  EXPECT_EQ(error_in("a.txt", "hello\n").substr(0, 40), "a.txt:1: not recognised as one of the fo");
}

TEST_F(ForeignFormats, SayWhereAMapNamesAnImageThatCannotBeRead) {
  const std::string map =
      "resolution: 1\nimage: m.pgm\norigin: [0, 0, 0]\noccupied_thresh: 0.6\nfree_thresh: 0.2\n";
  EXPECT_EQ(error_in("m.yaml", map),
            "m.yaml:2: key 'image': m.pgm: cannot be read (No such file or directory)");
  write("m.pgm", "P6\n");
  EXPECT_EQ(error_in("m.yaml", map),
            "m.yaml:2: key 'image': m.pgm:1: expected a PGM image (P2 or P5), got 'P6'");
}

TEST_F(ForeignFormats, RefuseTheQueriesOfAnotherMap) {
  const std::string world_path = write("a.map", "type octile\nheight 1\nwidth 2\nmap\n..\n");
  const std::string queries = write("b.scen", "version 1\n0 maps/b.map 2 1 0 0 1 0 1\n");
  const ForeignFormat& format = foreign_format("movingai", world_path);
  const ForeignWorld world = format.read(world_path, format.defaults);
  EXPECT_THROW(read_queries(queries, world_path, world), ConfigError);
  EXPECT_EQ(read_queries(queries, "elsewhere/b.map", world).size(), 1U);
}

}  // namespace
}  // namespace voronaut
