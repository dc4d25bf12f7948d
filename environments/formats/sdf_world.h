#pragma once

#include <string>
#include <string_view>

#include "voronaut/environments/formats/foreign_world.h"

namespace voronaut {

// A Gazebo world (SDF, http://sdformat.org/spec), as BARN has them: every collision of every link
// of every <model> of the <world>, models in models too: an upright <cylinder>, a <box> or a
// <sphere>, where poses, named frames and `placement_frame` put it. The <state> that a simulator
// saved moves and scales models and links, inserts and deletes models, as Gazebo does when it loads
// the file. With `cut: plane` a body counts where it meets the plane at height_m, and a sphere is
// the circle in which it does; with `columns` all bodies count, as seen from above.
//
// Level planes, lights, actors, plug-ins, visuals and the included models sun and ground_plane are
// no obstacles. Whatever else could be one is an error: other shapes, other included models,
// populations, what is tilted or relative to a frame that is not there. Throws ConfigError with the
// line.
ForeignWorld parse_sdf_world(std::string_view text, const std::string& file,
                             const ForeignOptions& options);

}  // namespace voronaut
