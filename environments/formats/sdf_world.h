#pragma once

#include <string>
#include <string_view>

#include "voronaut/environments/formats/foreign_world.h"

namespace voronaut {

// A Gazebo world (SDF, http://sdformat.org/spec), as BARN has them: every collision of every link
// of every <model> of the <world>, an upright <cylinder>, a <box> or a <sphere> (its disc at the
// equator) at the composed poses of model, link and collision; heights are not compared. Level
// planes, lights, actors, plug-ins, visuals, the recorded <state> and the included models sun and
// ground_plane are no obstacles. Whatever else could be one is an error: other shapes, other
// included models, populations, nested models, what is tilted or stands relative to a frame that
// is not its own parent. Throws ConfigError with the line.
ForeignWorld parse_sdf_world(std::string_view text, const std::string& file);

}  // namespace voronaut
