#include "voronaut/environments/formats/ros_map.h"

#include "voronaut/environments/formats/csv_table.h"
#include "voronaut/environments/formats/foreign_yaml.h"
#include "voronaut/environments/formats/png_image.h"

namespace voronaut {
namespace {

// A number or, as nav2 has it, a flag.
bool read_negate(const ConfigNode& negate) {
  const bool is_number = negate.is_scalar() && parse_whole(negate.text());
  return is_number ? negate.whole_number(0, 1) == 1 : read_yaml_flag(negate);
}

}  // namespace

RosMapDescription read_ros_map_description(const ConfigNode& root) {
  refuse_misspelt(
      root, {"image", "resolution", "origin", "negate", "occupied_thresh", "free_thresh", "mode"});
  RosMapDescription map;
  map.image = root.beside(root.child("image").text());
  map.resolution_m = root.child("resolution").number(0.001, 100);
  const ConfigNode origin = root.child("origin");
  const auto pose = origin.numbers(3, "[x, y, yaw]", -kFarthestCoordinate, kFarthestCoordinate);
  if (pose[2] != 0) throw origin.error("a yaw other than 0 is not supported");
  map.origin = {pose[0], pose[1]};
  if (const auto negate = root.find("negate")) map.negate = read_negate(*negate);
  map.occupied_thresh = root.child("occupied_thresh").number(0, 1);
  map.free_thresh = root.child("free_thresh").number(0, map.occupied_thresh);
  if (const auto mode = root.find("mode")) map.scale = mode->choice({"trinary", "scale"}) == 1;
  return map;
}

GreyImage read_ros_map_image(const RosMapDescription& map) {
  const std::string bytes = read_bytes(map.image);
  if (!is_png(bytes)) return parse_pgm(bytes, map.image);
  return parse_png(bytes, map.image, map.scale ? PngAlpha::unknown : PngAlpha::channel);
}

BlockedCells ros_map_cells(const RosMapDescription& map, const GreyImage& image,
                           UnknownCells unknown) {
  BlockedCells cells(image.columns, image.rows);
  for (int row = 0; row < image.rows; ++row) {
    for (int column = 0; column < image.columns; ++column) {
      const int value = image.value(column, row);
      const int dark = map.negate ? value : image.white - value;
      const double occupancy = static_cast<double>(dark) / image.white;
      const bool seen = !image.is_unknown(column, row);
      const bool occupied = seen && occupancy >= map.occupied_thresh;
      const bool is_free = seen && !occupied && occupancy <= map.free_thresh;
      if (occupied || (!is_free && unknown == UnknownCells::blocked))
        cells.block(column, image.rows - 1 - row);
    }
  }
  return cells;
}

}  // namespace voronaut
