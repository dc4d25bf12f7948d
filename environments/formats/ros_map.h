#pragma once

#include <string>

#include "voronaut/environments/config/config_node.h"
#include "voronaut/environments/formats/blocked_cells.h"
#include "voronaut/environments/formats/pgm.h"

// Occupancy maps of ROS map_server: a YAML file that names a grey image
// (https://docs.ros.org/api/map_server/html/index.html; nav2_map_server/src/map_io.cpp).
namespace voronaut {

struct RosMapDescription {
  std::string image;           // path, complete
  double resolution_m = 0.05;  // per pixel
  Vec2 origin = Vec2::Zero();  // lower left corner of the lower left pixel
  bool negate = false;
  double occupied_thresh = 0.65;
  double free_thresh = 0.25;
  bool scale = false;  // mode scale: a pixel that is not wholly opaque is unknown
};

// Keys image, resolution (m per pixel), origin ([x, y, yaw] of the lower left pixel's corner, yaw
// 0), negate (0, 1, false or true), occupied_thresh, free_thresh, mode (trinary or scale: in both a
// pixel is occupied, free or unknown here; they differ in what they make of an image's opacity).
// Other keys are not read, as map_server does not; one that looks like a misspelt one of these is
// refused.
RosMapDescription read_ros_map_description(const ConfigNode& root);

// PGM or PNG, by its first bytes. Throws ConfigError.
GreyImage read_ros_map_image(const RosMapDescription& map);

// A pixel's occupancy is 1 - value / white (value / white if negated): occupied from
// occupied_thresh on, free up to free_thresh, unknown between.
BlockedCells ros_map_cells(const RosMapDescription& map, const GreyImage& image,
                           UnknownCells unknown);

}  // namespace voronaut
