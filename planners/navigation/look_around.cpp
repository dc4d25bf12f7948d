#include "voronaut/planners/navigation/look_around.h"

#include <numbers>

#include "voronaut/dynamics/heading.h"

namespace voronaut {

namespace {

constexpr double kOverlap_rad = 0.1;  // seen twice, so that no wedge between two beams is left out

}  // namespace

LookAround::LookAround(double field_of_view_rad)
    : to_turn_rad_(2 * std::numbers::pi - field_of_view_rad + kOverlap_rad) {
  if (field_of_view_rad >= 2 * std::numbers::pi - kOverlap_rad) to_turn_rad_ = 0;
}

void LookAround::begin(const Vec2& heading_world) {
  heading_ = heading_world;
  turned_rad_ = 0;
  active_ = to_turn_rad_ > 0;
}

void LookAround::advance(const Vec2& heading_world) {
  if (!active_) return;
  turned_rad_ += heading_error_rad(heading_, heading_world);
  heading_ = heading_world;
  active_ = turned_rad_ < to_turn_rad_;
}

}  // namespace voronaut
