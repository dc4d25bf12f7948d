#include "voronaut/planners/navigation/departure.h"

#include <algorithm>

namespace voronaut {

namespace {

// A heading within 10 deg of it still departs.
constexpr double kGoodFraction = 0.45;
// Directions are looked at every 5 deg.
constexpr double kCosTurn = 0.9961946980917455;
constexpr double kSinTurn = 0.0871557427476582;
constexpr int kHalfATurn = 36;

}  // namespace

bool leads_away(const Vec2& v_command_m_s, std::span<const Vec2> track,
                std::span<const Vec2> places) {
  const Vec2& start = track.front();
  for (const Vec2& place : places) {
    const Vec2 from_place = start - place;
    const double distance_m = from_place.norm();
    if (distance_m == 0) return false;
    const double away_m_s = v_command_m_s.dot(from_place) / distance_m;
    if (away_m_s < kDepartureFraction * v_command_m_s.norm()) return false;
    for (const Vec2& corner : track.subspan(1)) {
      const Vec2 way = corner - start;
      const double away_m = way.dot(from_place) / distance_m;
      if (away_m < kDepartureFraction * way.norm() - kDepartureDrift_m) return false;
    }
  }
  return true;
}

std::optional<Vec2> departing_direction(const Vec2& towards, const Vec2& p_world,
                                        std::span<const Vec2> places) {
  const auto departs = [&](const Vec2& way) {
    return std::ranges::all_of(places, [&](const Vec2& place) {
      const Vec2 from_place = p_world - place;
      return way.dot(from_place) > kGoodFraction * from_place.norm();
    });
  };
  Vec2 to_left = towards, to_right = towards;
  for (int turns = 0; turns <= kHalfATurn; ++turns) {
    if (departs(to_left)) return to_left;
    if (departs(to_right)) return to_right;
    to_left = kCosTurn * to_left + kSinTurn * left_of(to_left);
    to_right = kCosTurn * to_right - kSinTurn * left_of(to_right);
  }
  return std::nullopt;
}

}  // namespace voronaut
