#include "voronaut/planners/navigation/command_ladder.h"

#include "voronaut/planners/navigation/arc_ladder.h"
#include "voronaut/planners/navigation/car_ladder.h"
#include "voronaut/planners/navigation/velocity_ladder.h"

namespace voronaut {

std::unique_ptr<CommandLadder> ladder_of(const MotionResponse& response, bool turns_in_steps) {
  if (const auto* drive = std::get_if<DriveResponse>(&response))
    return std::make_unique<ArcLadder>(*drive, turns_in_steps);
  if (const auto* car = std::get_if<CarResponse>(&response))
    return std::make_unique<CarLadder>(*car);
  return std::make_unique<VelocityLadder>(std::get<VelocityResponse>(response));
}

}  // namespace voronaut
