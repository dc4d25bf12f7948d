#include "voronaut/dynamics/car_response.h"

#include <algorithm>
#include <cmath>

#include <sleef.h>

namespace voronaut {

namespace {

constexpr double kCarHorizon_s = 4;
constexpr double kCarBendsCosine = 0.99875;  // 0.05 rad, as in drive_response.cpp
// A way left that is shorter than this is a straight line.
constexpr double kShortRest_m = 0.02;
// Of pure pursuit, as in arc_steering.cpp.
constexpr double kNearestPoint_m = 0.1;
constexpr double kFarthestPoint_m = 0.3;
constexpr double kFarthestPointPerSpeed_s = 0.5;

// Midpoint rule: the way of a step lies along the heading in its middle, on the curvature there.
void roll(const CarResponse& r, CarMotion& m, const CarResponse::Rates& rates) {
  const double t_s = r.period_s;
  const double way_m = t_s * (m.v_m_s + 0.5 * t_s * rates.v_dot_m_s2);
  const double steering_rad = m.steering_rad + 0.5 * t_s * rates.steering_dot_rad_s;
  const double turn_rad = way_m * Sleef_cinz_tand1_u10purec(steering_rad) / r.wheelbase_m;
  const auto turned = [&](double angle_rad) {
    const Sleef_double_2 turn = Sleef_cinz_sincosd1_u10purec(angle_rad);
    return Eigen::Vector2d(turn.y * m.heading.x() - turn.x * m.heading.y(),
                           turn.x * m.heading.x() + turn.y * m.heading.y());
  };
  m.p_m += way_m * turned(0.5 * turn_rad);
  m.heading = turned(turn_rad);
  m.v_m_s += t_s * rates.v_dot_m_s2;
  m.steering_rad = std::clamp(m.steering_rad + t_s * rates.steering_dot_rad_s, -r.steering_max_rad,
                              r.steering_max_rad);
}

}  // namespace

double CarResponse::turning_radius_m() const {
  return wheelbase_m / Sleef_cinz_tand1_u10purec(steering_max_rad);
}

double CarResponse::error_m(const CarMotion& now, const ArcCommand& commanded) const {
  return error_at_rest_m +
         error_per_speed_s * std::max(std::abs(now.v_m_s), std::abs(commanded.v_m_s));
}

CarMotion CarResponse::motion_of(const VehicleState& state) const {
  CarMotion m;
  m.p_m = state.p_world.head<2>();
  m.heading = state.heading_world();
  m.v_m_s = m.heading.dot(state.v_world.head<2>());
  m.steering_rad = state.actuators[0];
  return m;
}

CarResponse::Rates CarResponse::rates_asked(const CarMotion& now,
                                            const ArcCommand& commanded) const {
  double wanted_rad = now.steering_rad;
  if (commanded.v_m_s != 0) {
    wanted_rad =
        std::clamp(Sleef_cinz_atand1_u10purec(wheelbase_m * commanded.w_rad_s / commanded.v_m_s),
                   -steering_max_rad, steering_max_rad);
  }
  return {std::clamp(speed_gain_1_s * (commanded.v_m_s - now.v_m_s), -a_max_m_s2, a_max_m_s2),
          std::clamp(steering_gain_1_s * (wanted_rad - now.steering_rad), -steering_rate_max_rad_s,
                     steering_rate_max_rad_s)};
}

void CarResponse::predict_stop(const CarMotion& now, const ArcCommand& before,
                               const ArcCommand& commanded, double hold_s, double sample_s,
                               std::vector<Eigen::Vector2d>& track,
                               std::vector<Eigen::Vector2d>* headings) const {
  CarMotion m = now;
  track.assign(1, m.p_m);
  if (headings != nullptr) headings->assign(1, m.heading);
  const auto hold_steps = std::lround(hold_s / period_s);
  const long sample_steps = std::max(1L, std::lround(sample_s / period_s));
  const auto steps_max = static_cast<long>(kCarHorizon_s / period_s);
  Rates pending = rates_asked(m, before);
  Eigen::Vector2d heading_sampled = m.heading;
  double rest_m = 0;
  for (long step = 0; step < steps_max; ++step) {
    rest_m = m.v_m_s / speed_gain_1_s;
    if (step > hold_steps && std::abs(rest_m) < kShortRest_m) break;
    const Rates next = rates_asked(m, step >= hold_steps ? ArcCommand{} : commanded);
    roll(*this, m, pending);
    pending = next;
    if ((step + 1) % sample_steps == 0 || heading_sampled.dot(m.heading) < kCarBendsCosine) {
      track.push_back(m.p_m);
      if (headings != nullptr) headings->push_back(m.heading);
      heading_sampled = m.heading;
    }
  }
  track.push_back(m.p_m);
  track.push_back(m.p_m + rest_m * m.heading);
  if (headings != nullptr) headings->insert(headings->end(), 2, m.heading);
}

ArcCommand steered_towards(const CarMotion& now, const Eigen::Vector2d& way_m, double speed_m_s,
                           const CarResponse& response) {
  const double distance_m = way_m.norm();
  if (distance_m == 0) return {};
  const double ahead = now.heading.dot(way_m) / distance_m;
  const double left = (now.heading.x() * way_m.y() - now.heading.y() * way_m.x()) / distance_m;
  const double reach_m = std::clamp(distance_m, kNearestPoint_m,
                                    kFarthestPoint_m + kFarthestPointPerSpeed_s * speed_m_s);
  const double bend_max_1_m = 1 / response.turning_radius_m();
  const double bend_1_m =
      std::min(ahead > 0 ? 2 * std::abs(left) / reach_m : bend_max_1_m, bend_max_1_m);
  double v_m_s = std::min(speed_m_s, response.max_speed_m_s);
  if (v_m_s * v_m_s * bend_1_m > response.max_lateral_m_s2)
    v_m_s = std::sqrt(response.max_lateral_m_s2 / bend_1_m);
  // It steers sooner than it slows down.
  const double fastest_m_s = std::max(v_m_s, std::abs(now.v_m_s));
  const double held_1_m =
      std::min(bend_1_m, response.max_lateral_m_s2 / std::max(fastest_m_s * fastest_m_s, 1e-9));
  return {v_m_s, std::copysign(v_m_s * held_1_m, left)};
}

}  // namespace voronaut
