#pragma once

#include <string>
#include <string_view>

#include "voronaut/environments/formats/foreign_world.h"

namespace voronaut {

// A static_obstacles.csv of the DodgeDrone challenge (uzh-rpg/agile_flight): no header; prefab, x,
// y, z, qw, qx, qy, qz, sx, sy, sz; a sphere of diameter sx,
// to which sy and sz must be equal (the simulator's own collision test takes sx alone). Rows at
// 1000 m are parked, that is, absent. Of the spheres come the circles in which they meet the plane
// z = options.height_m, or, with BodyCut::columns, upright columns of their radii. Start (0, 0),
// goal (18, 0), the field with 2 m around it. Throws ConfigError with the line.
ForeignWorld parse_dodgedrone(std::string_view text, const std::string& file,
                              const ForeignOptions& options);

}  // namespace voronaut
