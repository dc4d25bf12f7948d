#include "voronaut/benchmarks/episode/barn_challenge.h"

#include <algorithm>
#include <cmath>

namespace voronaut {

namespace {

constexpr double kHasMoved_m = 0.1;
constexpr double kOptimalSpeed_m_s = 2;

}  // namespace

double barn_time_s(std::span<const Tick> ticks, double end_s) {
  const auto moved = std::ranges::find_if(ticks, [&](const Tick& tick) {
    return (tick.state.p_world - ticks.front().state.p_world).head<2>().norm() >= kHasMoved_m;
  });
  return moved == ticks.end() ? kAbsent : end_s - moved->t_s;
}

void add_barn(RunRecord& record, std::span<const Tick> ticks, double course_length_m) {
  record.barn_score = 0;
  if (record.outcome != Outcome::goal_reached) return;
  const double optimal_s = course_length_m / kOptimalSpeed_m_s;
  record.barn_time_s = barn_time_s(ticks, record.duration_s);
  if (std::isnan(record.barn_time_s)) {
    record.barn_score = 0.5;
    return;
  }
  record.barn_score = optimal_s / std::clamp(record.barn_time_s, 2 * optimal_s, 8 * optimal_s);
  record.barn_pace = optimal_s / record.barn_time_s;
}

}  // namespace voronaut
