#pragma once

#include <optional>

#include "voronaut/planners/mapping/free_space/free_space.h"
#include "voronaut/planners/navigation/navigator_config.h"
#include "voronaut/planners/navigation/safety_governor.h"

// What a navigator governs with, as its configuration asks for it.
namespace voronaut {

// None if none is asked for. Throws std::invalid_argument if the vehicle has no motion response or
// one of another kind than its steering.
std::optional<SafetyGovernor> governor_of(const NavigatorConfig& config);

// Known-free space that knows nothing yet, as fine as the planning clearance needs it. Throws as
// governor_of() and FreeSpace do.
FreeSpace free_space_of(const NavigatorConfig& config);

}  // namespace voronaut
