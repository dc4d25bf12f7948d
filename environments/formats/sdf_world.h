#pragma once

#include <string>
#include <string_view>

#include "voronaut/environments/formats/foreign_world.h"

namespace voronaut {

// A Gazebo world (SDF, http://sdformat.org/spec), as BARN has them: of each <model> of the <world>
// with a collision of upright <cylinder> or <box> that shape at the model's pose. Planes, lights,
// plug-ins, visuals, the recorded <state> and models that are only included are not read; heights
// are not compared. A link or collision with a pose of its own, or a model that is tilted, is an
// error. Throws ConfigError with the line.
ForeignWorld parse_sdf_world(std::string_view text, const std::string& file);

}  // namespace voronaut
