#pragma once

#include <variant>

#include "voronaut/dynamics/drive_response.h"
#include "voronaut/dynamics/velocity_response.h"

namespace voronaut {

// How a vehicle under its regulator answers commands: velocities in any direction, or arcs along
// its heading.
using MotionResponse = std::variant<VelocityResponse, DriveResponse>;

}  // namespace voronaut
