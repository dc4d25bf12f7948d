#include "voronaut/environments/formats/ros_map.h"

#include <algorithm>
#include <vector>

#include "voronaut/environments/config/nearest_name.h"
#include "voronaut/environments/formats/csv_table.h"
#include "voronaut/environments/formats/yaml_flag.h"

namespace voronaut {
namespace {

void refuse_misspelt(const ConfigNode& root, const std::vector<std::string>& known) {
  for (const std::string& key : root.keys())
    if (std::find(known.begin(), known.end(), key) == known.end() && nearest_name(key, known))
      throw root.child(key).error("unknown key" + allowed_names(key, known));
}

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
  if (const auto mode = root.find("mode")) mode->choice({"trinary", "scale"});
  return map;
}

BlockedCells ros_map_cells(const RosMapDescription& map, const GreyImage& image,
                           UnknownCells unknown) {
  BlockedCells cells(image.columns, image.rows);
  for (int row = 0; row < image.rows; ++row) {
    for (int column = 0; column < image.columns; ++column) {
      const int value = image.value(column, row);
      const int dark = map.negate ? value : image.white - value;
      const double occupancy = static_cast<double>(dark) / image.white;
      const bool occupied = occupancy >= map.occupied_thresh;
      const bool is_free = !occupied && occupancy <= map.free_thresh;
      if (occupied || (!is_free && unknown == UnknownCells::blocked))
        cells.block(column, image.rows - 1 - row);
    }
  }
  return cells;
}

}  // namespace voronaut
