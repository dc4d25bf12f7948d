#include "voronaut/planners/navigation/departure.h"

namespace voronaut {

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

}  // namespace voronaut
