#pragma once

#include <deque>
#include <functional>

#include "voronaut/dynamics/state.h"
#include "voronaut/planners/navigation/declared_errors.h"

namespace voronaut {

// Where a vehicle is and where it will be when what is commanded now begins to act, from poses that
// jitter, velocities that do not, and the commands under way. What navigation and regulator are to
// be told. Once per vehicle step: take(), then command().
//
// The pose is what a first-order observer makes of the poses told and of dead reckoning: of white
// noise it lets sqrt(g / (2 - g)) of the standard deviation through, g the gain. Latency is
// compensated by the model through the commands that have not acted yet (O. J. M. Smith's predictor
// with the whole state measured). With gain 1 and no latency both are the state as told.
class StateEstimate {
 public:
  // The state one vehicle step later under a command held constant, without the errors that nobody
  // knows: a model's step().
  using Step = std::function<VehicleState(const VehicleState&, const Command&)>;

  // `hold`: what acts before any command does.
  StateEstimate(const DeclaredErrors& errors, Step step, const Command& hold, double period_s);

  StateEstimate(const StateEstimate&) = delete;  // here_ leads into it
  StateEstimate& operator=(const StateEstimate&) = delete;

  // `told` must live as long as the answers are asked for: they are `told` itself where nothing is
  // to be filtered and nothing is under way.
  void take(const VehicleState& told);
  void command(const Command& given);

  const VehicleState& now() const { return *here_; }
  const VehicleState& when_it_acts() const { return under_way_.empty() ? *here_ : then_; }

 private:
  void observe(const VehicleState& told);

  double gain_;
  double period_s_;
  Step step_;
  std::deque<Command> under_way_;  // the first acts now, the last one step before the next given
  bool begun_ = false;
  VehicleState now_, then_;
  const VehicleState* here_ = &now_;
};

}  // namespace voronaut
