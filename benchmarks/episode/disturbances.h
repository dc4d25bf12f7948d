#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "voronaut/benchmarks/trial/disturbance_config.h"
#include "voronaut/dynamics/state.h"
#include "voronaut/environments/random.h"

namespace voronaut {

// What stands between commands and vehicle, and between vehicle and what it is told of itself.
class Disturbances {
 public:
  // `hold`: what acts before any command does.
  Disturbances(const DisturbanceConfig& config, const Command& hold, double period_s,
               std::uint64_t seed);

  // The state with the noise of its pose; valid until the next call, and no longer than `state`.
  // Velocities are told as they are in the body's frame.
  const VehicleState& told(const VehicleState& state) {
    return config_.position_sigma_m == 0 && config_.heading_sigma_rad == 0 ? state : noisy(state);
  }
  // What acts in this step, and what will once it is due: one step later and the latency.
  const Command& acting() const { return under_way_.front(); }
  void command(Command given);

 private:
  const VehicleState& noisy(const VehicleState& state);

  DisturbanceConfig config_;
  Random pose_noise_;
  std::array<double, 4> gains_;
  std::vector<Command> under_way_;
  VehicleState told_;
};

}  // namespace voronaut
