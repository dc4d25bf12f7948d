#include "voronaut/benchmarks/episode/disturbances.h"

#include <algorithm>
#include <cmath>

namespace voronaut {

namespace {

std::array<double, 4> drawn_gains(double error, std::uint64_t seed) {
  Random random(derive_seed(seed, {"gains"}, 0));
  std::array<double, 4> gains{};
  for (double& gain : gains) gain = 1 + (random.uniform() < 0.5 ? -error : error);
  return gains;
}

}  // namespace

Disturbances::Disturbances(const DisturbanceConfig& config, const Command& hold, double period_s,
                           std::uint64_t seed)
    : config_(config),
      pose_noise_(derive_seed(seed, {"pose"}, 0)),
      gains_(drawn_gains(config.gain_error, seed)),
      under_way_(1 + static_cast<std::size_t>(std::lround(config.latency_s / period_s)), hold) {}

const VehicleState& Disturbances::noisy(const VehicleState& state) {
  told_ = state;
  for (const int axis : {0, 1}) {
    if (config_.position_sigma_m > 0)
      told_.p_world[axis] += config_.position_sigma_m * pose_noise_.normal();
  }
  if (config_.heading_sigma_rad > 0) {
    // About the vertical, by an angle whose half has this tangent.
    const double half = 0.5 * config_.heading_sigma_rad * pose_noise_.normal();
    const Eigen::Quaterniond turn = Eigen::Quaterniond(1, 0, 0, half).normalized();
    told_.q_world_body = turn * state.q_world_body;
    told_.v_world = turn * state.v_world;
  }
  return told_;
}

void Disturbances::command(Command given) {
  if (config_.gain_error > 0)
    for (std::size_t i = 0; i < given.u.size(); ++i) given.u[i] *= gains_[i];
  std::rotate(under_way_.begin(), under_way_.begin() + 1, under_way_.end());
  under_way_.back() = given;
}

}  // namespace voronaut
