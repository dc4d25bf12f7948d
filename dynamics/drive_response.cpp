#include "voronaut/dynamics/drive_response.h"

#include <algorithm>
#include <cmath>

namespace voronaut {

namespace {

// What is left of a way that bends by less than this in all is a straight line.
constexpr double kStraightRest_m = 0.001;
constexpr double kTurnedRest_rad = 0.02;
constexpr double kDriveHorizon_s = 4;
// A sample more where it has turned by 0.05 rad: between two of them, at most 0.125 m apart (2.5
// m/s), an arc lies within 0.8 mm of its chord.
constexpr double kBendsCosine = 0.99875;

struct DriveRates {
  double v_dot_m_s2 = 0, w_dot_rad_s2 = 0;
};

DriveRates rates_asked(const DriveResponse& r, const DriveMotion& m, const ArcCommand& commanded) {
  return {std::clamp(r.speed_gain_1_s * (commanded.v_m_s - m.v_m_s), -r.a_max_m_s2, r.a_max_m_s2),
          std::clamp(r.yaw_rate_gain_1_s * (commanded.w_rad_s - m.w_rad_s), -r.alpha_max_rad_s2,
                     r.alpha_max_rad_s2)};
}

// A small angle's turn by its series, to 1e-9 at 0.2 rad and 1e-5 at 0.8.
Eigen::Vector2d turned_a_little(const Eigen::Vector2d& heading, double angle_rad) {
  const double square = angle_rad * angle_rad;
  const double c = 1 - square / 2 * (1 - square / 12 * (1 - square / 30));
  const double s = angle_rad * (1 - square / 6 * (1 - square / 20 * (1 - square / 42)));
  return {c * heading.x() - s * heading.y(), s * heading.x() + c * heading.y()};
}

// Midpoint rule: the way of a step lies along the heading in its middle.
void drive(const DriveResponse& r, DriveMotion& m, const DriveRates& rates) {
  const double t_s = r.period_s;
  const double v_mean_m_s = m.v_m_s + 0.5 * t_s * rates.v_dot_m_s2;
  const double turn_rad = t_s * (m.w_rad_s + 0.5 * t_s * rates.w_dot_rad_s2);
  const Eigen::Vector2d middle = turned_a_little(m.heading, 0.5 * turn_rad);
  m.p_m += t_s * v_mean_m_s * middle;
  m.heading = turned_a_little(middle, 0.5 * turn_rad);
  m.v_m_s += t_s * rates.v_dot_m_s2;
  m.w_rad_s += t_s * rates.w_dot_rad_s2;
}

}  // namespace

double DriveResponse::error_m(const DriveMotion& now, const ArcCommand& commanded) const {
  return error_at_rest_m +
         error_per_speed_s * std::max(std::abs(now.v_m_s), std::abs(commanded.v_m_s));
}

DriveMotion DriveResponse::motion_of(const VehicleState& state) const {
  DriveMotion m;
  m.p_m = state.p_world.head<2>();
  m.heading = state.heading_world();
  m.v_m_s = m.heading.dot(state.v_world.head<2>());
  m.w_rad_s = state.w_body.z();
  return m;
}

void DriveResponse::predict_stop(const DriveMotion& now, const ArcCommand& before,
                                 const ArcCommand& commanded, double hold_s, double sample_s,
                                 std::vector<Eigen::Vector2d>& track,
                                 std::vector<Eigen::Vector2d>* headings) const {
  DriveMotion m = now;
  track.assign(1, m.p_m);
  if (headings != nullptr) headings->assign(1, m.heading);
  const auto hold_steps = std::lround(hold_s / period_s);
  const long sample_steps = std::max(1L, std::lround(sample_s / period_s));
  const auto steps_max = static_cast<long>(kDriveHorizon_s / period_s);
  DriveRates pending = rates_asked(*this, m, before);
  Eigen::Vector2d heading_sampled = m.heading;
  double rest_m = 0, rest_rad = 0;
  for (long step = 0; step < steps_max; ++step) {
    if (step > hold_steps) {
      // Of two linear loops, what is left is v / k along the heading, which turns by w / k.
      rest_m = m.v_m_s / speed_gain_1_s;
      rest_rad = m.w_rad_s / yaw_rate_gain_1_s;
      const bool linear = speed_gain_1_s * std::abs(m.v_m_s) < 0.9 * a_max_m_s2 &&
                          yaw_rate_gain_1_s * std::abs(m.w_rad_s) < 0.9 * alpha_max_rad_s2;
      const bool turned = headings == nullptr || std::abs(rest_rad) < kTurnedRest_rad;
      if (linear && turned && std::abs(rest_m * rest_rad) < kStraightRest_m) break;
    }
    const DriveRates next = rates_asked(*this, m, step >= hold_steps ? ArcCommand{} : commanded);
    drive(*this, m, pending);
    pending = next;
    if ((step + 1) % sample_steps == 0 || heading_sampled.dot(m.heading) < kBendsCosine) {
      track.push_back(m.p_m);
      if (headings != nullptr) headings->push_back(m.heading);
      heading_sampled = m.heading;
    }
  }
  track.push_back(m.p_m);
  track.push_back(m.p_m + rest_m * m.heading);
  if (headings == nullptr) return;
  headings->push_back(m.heading);
  headings->push_back(turned_a_little(m.heading, rest_rad));
}

}  // namespace voronaut
