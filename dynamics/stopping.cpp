#include "voronaut/dynamics/stopping.h"

#include <cmath>

namespace voronaut {
namespace {

constexpr double kTiltTime_s = 0.1;

}  // namespace

double stopping_distance_m(double speed_m_s, double k_1_s, double a_m_s2) {
  const double knee_m_s = a_m_s2 / k_1_s;
  if (speed_m_s <= knee_m_s) return speed_m_s / k_1_s;
  return speed_m_s * speed_m_s / (2 * a_m_s2) + a_m_s2 / (2 * k_1_s * k_1_s) +
         kTiltTime_s * (speed_m_s - knee_m_s);
}

double safe_speed_m_s(double free_distance_m, double gamma_m, double reaction_time_s, double k_1_s,
                      double a_m_s2) {
  const double room_m = free_distance_m - gamma_m;
  if (!(room_m > 0)) return 0;
  const double knee_m_s = a_m_s2 / k_1_s;
  const double linear_m_s = k_1_s * room_m / (1 + k_1_s * reaction_time_s);
  if (linear_m_s <= knee_m_s) return linear_m_s;
  const double b_s = reaction_time_s + kTiltTime_s;
  const double rest_m = room_m - a_m_s2 / (2 * k_1_s * k_1_s) + kTiltTime_s * knee_m_s;
  return a_m_s2 * (std::sqrt(b_s * b_s + 2 / a_m_s2 * rest_m) - b_s);
}

}  // namespace voronaut
