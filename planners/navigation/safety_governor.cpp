#include "voronaut/planners/navigation/safety_governor.h"

namespace voronaut {

namespace {

constexpr double kShares[] = {1, 0.8, 0.6, 0.4, 0.25, 0.12, 0.05};

}  // namespace

SafetyGovernor::Decision SafetyGovernor::decide(const VehicleState& state,
                                                const FreeSpace& known_free,
                                                const Eigen::Vector2d& towards,
                                                double wanted_speed_m_s) {
  for (const double share : kShares) {
    const double speed_m_s = share * wanted_speed_m_s;
    braking_.predict(state, speed_m_s * towards, config_.period_s, track_);
    if (track_is_free(known_free)) return {speed_m_s, false};
  }
  braking_.predict(state, Eigen::Vector2d::Zero(), config_.period_s, track_);
  return {0, true};
}

bool SafetyGovernor::track_is_free(const FreeSpace& known_free) const {
  const double radius_m = config_.body_radius_m + config_.range_error_m + braking_.error_m();
  for (std::size_t i = 1; i < track_.size(); ++i) {
    if (!known_free.swept_disc_is_free(track_[i - 1], track_[i], radius_m)) return false;
  }
  return true;
}

}  // namespace voronaut
