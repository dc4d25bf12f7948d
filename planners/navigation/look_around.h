#pragma once

#include "voronaut/environments/shapes/geometry.h"

namespace voronaut {

// Turning on the spot until every direction has been in view once.
class LookAround {
 public:
  // Nothing to do for a range finder that sees the full circle.
  explicit LookAround(double field_of_view_rad);

  void begin(const Vec2& heading_world);
  bool active() const { return active_; }
  // Where there is no room to turn.
  void give_up() { active_ = false; }
  // Call with the heading at each scan while active; ends when all has been seen.
  void advance(const Vec2& heading_world);

 private:
  double to_turn_rad_;
  double turned_rad_ = 0;  // to the left
  Vec2 heading_ = Vec2::UnitX();
  bool active_ = false;
};

}  // namespace voronaut
