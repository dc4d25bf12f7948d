#include "voronaut/environments/formats/ros_map.h"

#include <gtest/gtest.h>

#include "voronaut/tests/support/error_of.h"

namespace voronaut {
namespace {

const std::string kYaml =
    "image: m.pgm\nresolution: 0.05\norigin: [-1, -2, 0]\nnegate: 0\noccupied_thresh: 0.65\n"
    "free_thresh: 0.196\n";

std::string pgm_error(const std::string& bytes) {
  return error_of<ConfigError>([&] { parse_pgm(bytes, "m.pgm"); });
}

std::string yaml_error(const std::string& yaml) {
  return error_of<ConfigError>(
      [&] { read_ros_map_description(ConfigNode::parse(yaml, "m.yaml")); });
}

std::string seen(const BlockedCells& cells) {
  std::string text;
  for (int row = cells.rows() - 1; row >= 0; --row)
    for (int column = 0; column < cells.columns(); ++column)
      text += cells.blocked(column, row) ? '#' : '.';
  return text;
}

TEST(RosMap, TakesPixelsForOccupiedFreeOrUnknown) {
  auto map = read_ros_map_description(ConfigNode::parse(kYaml, "maps/m.yaml"));
  EXPECT_EQ(map.image, "maps/m.pgm");
  EXPECT_EQ(map.origin, Vec2(-1, -2));
  EXPECT_EQ(map.resolution_m, 0.05);
  const GreyImage image =
      parse_pgm("P2\n# made by hand\n3 2\n255\n0 205 254\n255 0 205\n", "m.pgm");
  EXPECT_EQ(seen(ros_map_cells(map, image, UnknownCells::blocked)), "##..##");
  EXPECT_EQ(seen(ros_map_cells(map, image, UnknownCells::free)), "#...#.");
  map.negate = true;
  EXPECT_EQ(seen(ros_map_cells(map, image, UnknownCells::free)), ".###.#");
}

// As map_server: from the threshold on, not above it. 192 of 256 is three quarters to the bit.
TEST(RosMap, TakesAPixelAtAThresholdForOccupiedOrFree) {
  RosMapDescription map;
  map.occupied_thresh = 0.75;
  map.free_thresh = 0.25;
  map.negate = true;
  const GreyImage image = parse_pgm("P2\n4 1\n256\n192 191 64 65\n", "m.pgm");
  EXPECT_EQ(seen(ros_map_cells(map, image, UnknownCells::free)), "#...");
  EXPECT_EQ(seen(ros_map_cells(map, image, UnknownCells::blocked)), "##.#");
}

TEST(RosMap, MayHaveKeysOfItsOwnAndAFlagForNegate) {
  const std::string rest =
      "image: m.pgm\nresolution: 1\norigin: [0, 0, 0]\noccupied_thresh: 0.6\nfree_thresh: 0.2\n"
      "uuid: 7\n";
  const auto negates = [&](const std::string& value) {
    return read_ros_map_description(ConfigNode::parse("negate: " + value + "\n" + rest, "m.yaml"))
        .negate;
  };
  EXPECT_TRUE(negates("true"));
  EXPECT_FALSE(negates("False"));
  EXPECT_TRUE(negates("1"));
  EXPECT_EQ(yaml_error("negate: 2\n" + rest),
            "m.yaml:1: key 'negate': expected a whole number from 0 to 1, got '2'");
  EXPECT_EQ(yaml_error("negate: maybe\n" + rest),
            "m.yaml:1: key 'negate': expected true or false, got 'maybe'");
}

TEST(RosMap, IsRefusedWithTheKeyAndTheReason) {
  EXPECT_EQ(yaml_error("image: m.pgm\nresolution: 0\norigin: [0, 0, 0]\noccupied_thresh: 0.6\n"
                       "free_thresh: 0.2\n"),
            "m.yaml:2: key 'resolution': expected a number from 0.001 to 100, got '0'");
  EXPECT_EQ(yaml_error("image: m.pgm\nresolution: 1\norigin: [0, 0, 0.1]\noccupied_thresh: 0.6\n"
                       "free_thresh: 0.2\n"),
            "m.yaml:3: key 'origin': a yaw other than 0 is not supported");
  EXPECT_EQ(yaml_error("image: m.pgm\nresolution: 1\norigin: [0, 0, 0]\noccupied_thresh: 0.6\n"
                       "free_thresh: 0.7\n"),
            "m.yaml:5: key 'free_thresh': expected a number from 0 to 0.6, got '0.7'");
  EXPECT_EQ(yaml_error("image: m.pgm\nresolution: 1\norigin: [0, 0]\n"),
            "m.yaml:3: key 'origin': expected [x, y, yaw], got a list of 2");
  EXPECT_EQ(yaml_error(kYaml + "mode: Trinary\n"),
            "m.yaml:7: key 'mode': expected one of trinary, scale, got 'Trinary' (did you mean "
            "'trinary'?)");
  EXPECT_EQ(yaml_error(kYaml + "map_id: 7\nmod: raw\n"),
            "m.yaml:8: key 'mod': unknown key (allowed: image, resolution, origin, negate, "
            "occupied_thresh, free_thresh, mode; did you mean 'mode'?)");
  EXPECT_EQ(yaml_error(kYaml + "mode: raw\n"),
            "m.yaml:7: key 'mode': expected one of trinary, scale, got 'raw'");
}

TEST(Pgm, IsReadRawWithOneOrTwoBytes) {
  const GreyImage one = parse_pgm(std::string("P5\n2 1\n255\n\x07\xff", 13), "m.pgm");
  EXPECT_EQ(one.value(0, 0), 7);
  EXPECT_EQ(one.value(1, 0), 255);
  const GreyImage two = parse_pgm(std::string("P5 1 1 1000 \x01\x02", 14), "m.pgm");
  EXPECT_EQ(two.value(0, 0), 258);
}

TEST(Pgm, MayEndAsMapSaverDoes) {
  EXPECT_EQ(parse_pgm("P5\n2 1\n255\nab\n", "m.pgm").value(1, 0), 'b');
  EXPECT_EQ(parse_pgm("P2\n2 1\n255\n1 2 # end\n", "m.pgm").value(1, 0), 2);
}

TEST(Pgm, IsRefusedWhereItsPixelsWouldBeMovedOrLeftOver) {
  EXPECT_EQ(pgm_error("P5\r\n2 1\r\n255\r\nab"),
            "m.pgm:3: expected 2 bytes of pixels, got 3 (the header ends in \\r\\n; one blank must "
            "end it)");
  EXPECT_NE(pgm_error("P5\r\n2 1\r\n255\r\na\n"), "no error");  // a pixel of 10 at the end
  EXPECT_EQ(pgm_error("P5\n2 1\n255\nabc"), "m.pgm:3: expected 2 bytes of pixels, got 3");
  EXPECT_EQ(pgm_error("P2\n2 1\n255\n1 2 3\n"), "m.pgm:4: more pixels than width and height say");
}

TEST(Pgm, IsRefusedWithTheReason) {
  EXPECT_EQ(pgm_error(""), "m.pgm:1: the file ends before the sign P2 or P5");
  EXPECT_EQ(pgm_error("P6\n1 1\n255\nabc"), "m.pgm:1: expected a PGM image (P2 or P5), got 'P6'");
  EXPECT_EQ(pgm_error("P5\n0 1\n255\n"),
            "m.pgm:2: width: expected a whole number from 1 to 10000, got '0'");
  EXPECT_EQ(pgm_error("P5\n9999 9999\n255\n"), "m.pgm:2: more than 20000000 pixels");
  EXPECT_EQ(pgm_error("P5\n2 2\n255\nabc"), "m.pgm:3: expected 4 bytes of pixels, got 3");
  EXPECT_EQ(pgm_error("P5\n1 1\n9\nz"), "m.pgm:3: pixel 0 is 122, above the maximum 9");
  EXPECT_EQ(pgm_error("P2\n2 1\n255\n1\n"), "m.pgm:5: the file ends before the pixels");
  EXPECT_EQ(pgm_error("P2\n2 1\n255\n1 256\n"),
            "m.pgm:4: pixels: expected a whole number from 0 to 255, got '256'");
}

}  // namespace
}  // namespace voronaut
