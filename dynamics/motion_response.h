#pragma once

#include <variant>

#include "voronaut/dynamics/car_response.h"
#include "voronaut/dynamics/drive_response.h"
#include "voronaut/dynamics/velocity_response.h"

namespace voronaut {

// How a vehicle under its regulator answers commands: velocities in any direction, arcs along
// its heading and turns on the spot, or arcs that must be steered to.
using MotionResponse = std::variant<VelocityResponse, DriveResponse, CarResponse>;

}  // namespace voronaut
