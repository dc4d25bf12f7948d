#pragma once

#include <optional>

#include "voronaut/environments/random.h"
#include "voronaut/environments/shapes/geometry.h"
#include "voronaut/environments/shapes/shapes.h"

namespace voronaut {

// What a generator draws: true obstacles, the area, and a task in it. Metres, world frame W.
struct GeneratedWorld {
  Shapes shapes;
  Bounds bounds;
  Vec2 start = Vec2::Zero();
  Vec2 goal = Vec2::Zero();
};

// One draw; empty if this draw could not place what was asked, so that another is due.
using WorldDraw = std::optional<GeneratedWorld>;

}  // namespace voronaut
