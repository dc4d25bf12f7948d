#pragma once

#include <optional>
#include <span>
#include <vector>

#include "voronaut/environments/shapes/geometry.h"

namespace voronaut {

// A vehicle that comes to rest a little beyond where it was predicted to stands closer to a wall
// than any tube may be, for no cell on a wall is ever known free. It must be able to leave again.
//
// Slower than this, a flight strays so little from its predicted direction that leaving is safe.
inline constexpr double kDepartureSpeed_m_s = 0.4;
// A command leads away from a place if each step along it takes it this fraction of its length
// farther from the plane through the body's centre that faces the place.
inline constexpr double kDepartureFraction = 0.3;
// A track may first drift so far with what speed there is.
inline constexpr double kDepartureDrift_m = 0.003;

// Whether the command [m/s] leads away from every place and so does the track [m, world] predicted
// for it, whose first corner is the body's centre now: no disc around a place comes closer to it,
// up to the drift. The flight comes at most 1 cm closer to any of them, see
// tests/planners/navigation/departure_test.cpp. O(places x corners).
bool leads_away(const Vec2& v_command_m_s, std::span<const Vec2> track,
                std::span<const Vec2> places);

// The direction (unit vector) nearest to `towards` (unit vector), to 5 degrees, in which a body at
// p leaves all places behind by a good deal more than kDepartureFraction; none if they lie all
// around. O(places x directions).
std::optional<Vec2> departing_direction(const Vec2& towards, const Vec2& p_world,
                                        std::span<const Vec2> places);

}  // namespace voronaut
