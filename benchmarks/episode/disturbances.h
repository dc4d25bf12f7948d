#pragma once

#include <array>
#include <cstdint>
#include <deque>

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

  // The state with the noise of its pose. Velocities are told as they are in the body's frame.
  VehicleState told(const VehicleState& state);
  // What acts in this step, and what will once it is due: one step later and the latency.
  const Command& acting() const { return under_way_.front(); }
  void command(Command given);

 private:
  DisturbanceConfig config_;
  Random pose_noise_;
  std::array<double, 4> gains_;
  std::deque<Command> under_way_;
};

}  // namespace voronaut
