#include "voronaut/benchmarks/episode/episode.h"

namespace voronaut {

EpisodeLog fly(Flight& flight) {
  const double period_s = flight.spec.flight.loop.vehicle_period_s;
  VehicleState state = flight.at_start();
  flight.regulator->reset(state);

  std::size_t tick = 0;
  for (; !flight.referee.verdict(); ++tick) {
    const double now_s = static_cast<double>(tick) * period_s;
    flight.recorder.step_begins(now_s, state);
    flight.estimate.take(flight.disturbances.told(state));
    const VehicleState& here = flight.estimate.now();
    const VehicleState& then = flight.estimate.when_it_acts();
    const Setpoint setpoint =
        flight.scan_is_due(tick)
            ? flight.navigator.update(flight.sense(state, here, now_s), then, now_s)
            : flight.navigator.steer(then, now_s);
    const Command command = flight.regulator->regulate(setpoint, then);
    state = flight.model->step(state, flight.disturbances.acting(), period_s);
    flight.estimate.command(command);
    flight.disturbances.command(command);  // acts one step later, or more with latency
    flight.recorder.step_ends();
    flight.referee.hear(now_s, flight.navigator.report());
    flight.referee.judge(now_s + period_s, state);
  }
  return flight.recorder.finish(static_cast<double>(tick) * period_s, state, flight.referee);
}

}  // namespace voronaut
