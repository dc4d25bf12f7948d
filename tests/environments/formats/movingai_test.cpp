#include "voronaut/environments/formats/movingai.h"

#include <gtest/gtest.h>

#include "voronaut/environments/config/config_error.h"
#include "voronaut/tests/support/error_of.h"

namespace voronaut {
namespace {

const std::string kMap = "type octile\nheight 3\nwidth 4\nmap\n.@..\nGOTW\nS...\n";

std::string map_error(const std::string& text) {
  return error_of<ConfigError>([&] { parse_movingai_map(text, "a.map"); });
}

std::string scen_error(const std::string& text) {
  return error_of<ConfigError>([&] { parse_movingai_scen(text, "a.scen", {4, 3, 0.25}, "a.map"); });
}

TEST(MovingAiMap, HasItsFirstRowOnTop) {
  const BlockedCells cells = parse_movingai_map(kMap, "a.map");
  ASSERT_EQ(cells.columns(), 4);
  ASSERT_EQ(cells.rows(), 3);
  std::string seen;
  for (int row = 2; row >= 0; --row)
    for (int column = 0; column < 4; ++column) seen += cells.blocked(column, row) ? '#' : '.';
  EXPECT_EQ(seen, ".#...###....");
}

TEST(MovingAiMap, MayEndItsLinesAsWindowsDoes) {
  std::string text = kMap;
  for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2)
    text.insert(at, "\r");
  EXPECT_TRUE(parse_movingai_map(text, "a.map").blocked(1, 2));
}

TEST(MovingAiMap, MayHaveBlanksAfterItsLines) {
  const BlockedCells cells =
      parse_movingai_map("\xef\xbb\xbftype octile \nheight 1\nwidth 3\nmap \n.@. \t\n", "a.map");
  EXPECT_TRUE(cells.blocked(1, 0));
}

TEST(MovingAiMap, IsRefusedWithTheLineAndTheReason) {
  EXPECT_EQ(map_error(""), "a.map:1: the file ends before 'type'");
  EXPECT_EQ(map_error("type tile\n"), "a.map:1: expected the type octile, got 'tile'");
  EXPECT_EQ(map_error("type octile\nheight x\n"),
            "a.map:2: height: expected a whole number from 1 to 10000, got 'x'");
  EXPECT_EQ(map_error("type octile\nwidth 3\n"),
            "a.map:2: expected 'height' and its value, got 'width 3'");
  EXPECT_EQ(map_error("type octile\nheight 10000\nwidth 10000\nmap\n"),
            "a.map:3: more than 20000000 cells");
  EXPECT_EQ(map_error("type octile\nheight 3\nwidth 4\n....\n"),
            "a.map:4: expected the line 'map', got '....'");
  EXPECT_EQ(map_error("type octile\nheight 2\nwidth 4\nmap\n....\n...\n"),
            "a.map:6: expected a row of 4 cells, got 3");
  EXPECT_EQ(map_error("type octile\nheight 2\nwidth 4\nmap\n....\n"),
            "a.map:5: the file ends after 1 of 2 rows");
  EXPECT_EQ(map_error("type octile\nheight 1\nwidth 4\nmap\n.x..\n"),
            "a.map:5: column 1: expected one of .GS@OTW, got 'x'");
  EXPECT_EQ(map_error("type octile\nheight 1\nwidth 4\nmap\n....\n....\n"),
            "a.map:6: expected the end of the file, got '....'");
}

TEST(MovingAiScen, GivesCentresOfCells) {
  const auto queries = parse_movingai_scen(
      "version 1.0\n0\tsome/a.map\t4\t3\t0\t0\t3\t2\t3.5\n2\tmaps\\a.map\t4\t3\t3\t2\t2\t0\t8\n",
      "a.scen", {4, 3, 0.5, {10, 20}}, "a.map");
  ASSERT_EQ(queries.size(), 2U);
  EXPECT_EQ(queries[0].name, "0");
  EXPECT_EQ(queries[0].start, Vec2(10.25, 21.25));
  EXPECT_EQ(queries[0].goal, Vec2(11.75, 20.25));
  EXPECT_EQ(queries[0].length_m, 1.75);
  EXPECT_EQ(queries[1].bucket, 2);
  EXPECT_EQ(queries[1].goal, Vec2(11.25, 21.25));
}

TEST(MovingAiScen, IsRefusedWithTheLineAndTheReason) {
  EXPECT_EQ(scen_error(""), "a.scen:1: the file ends before 'version'");
  EXPECT_EQ(scen_error("version 1\n0 a.map 4 3 0 0 3 2 1\n0 maps/b.map 4 3 0 0 3 2 1\n"),
            "a.scen:3: a query of the map 'maps/b.map', not of 'a.map'");
  EXPECT_EQ(scen_error("version 2\n"), "a.scen:1: expected version 1, got '2'");
  EXPECT_EQ(scen_error("version 1\n"), "a.scen:1: no query in the file");
  EXPECT_EQ(scen_error("version 1\n0 a.map 4 3 0 0 3 2\n"),
            "a.scen:2: expected 9 columns (bucket, map, width, height, start x, start y, goal x, "
            "goal y, length), got 8");
  EXPECT_EQ(scen_error("version 1\n0 a.map 5 3 0 0 3 2 1\n"),
            "a.scen:2: width of the map: expected a whole number from 4 to 4, got '5'");
  EXPECT_EQ(scen_error("version 1\n0 a.map 4 3 0 0 4 2 1\n"),
            "a.scen:2: goal x: expected a whole number from 0 to 3, got '4'");
  EXPECT_EQ(scen_error("version 1\n0 a.map 4 3 0 0 3 2 nan\n"),
            "a.scen:2: length: expected a number from 0 to 1000000000, got 'nan'");
}

}  // namespace
}  // namespace voronaut
