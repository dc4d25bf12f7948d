#pragma once

#include <optional>

#include "voronaut/environments/formats/foreign_world.h"
#include "voronaut/environments/formats/sdf_frames.h"

namespace voronaut {

// What a <collision> of SDF is made of, around its own origin. Metres.
struct SdfBody {
  enum class Kind { cylinder, box, sphere } kind = Kind::box;
  Eigen::Vector3d size = Eigen::Vector3d::Zero();  // of the box around it
};

// None of a <collision> that is no obstacle: level planes and what is empty. `scale` is along the
// body's own axes. Throws ConfigError for shapes that cannot be read.
std::optional<SdfBody> read_body(const XmlElement& collision, const Eigen::Vector3d& scale);

// Adds what the body at that pose is on the plane of flight: see parse_sdf_world. Throws
// ConfigError at `place` where it is tilted.
void add_footprint(const SdfBody& body, const SdfPose& T_world_body, const ForeignOptions& options,
                   const XmlElement& place, ForeignWorld& world);

}  // namespace voronaut
