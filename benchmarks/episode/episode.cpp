#include "voronaut/benchmarks/episode/episode.h"

namespace voronaut {

EpisodeLog fly(Flight& flight) {
  const double period_s = flight.spec.loop.vehicle_period_s;
  VehicleState state = flight.at_start();
  Command applied = flight.model->hold();
  flight.regulator->reset(state);

  std::size_t tick = 0;
  for (; !flight.referee.verdict(); ++tick) {
    const double now_s = static_cast<double>(tick) * period_s;
    flight.recorder.step_begins(now_s, state);
    const Setpoint setpoint =
        flight.scan_is_due(tick) ? flight.navigator.update(flight.sense(state, now_s), state, now_s)
                                 : flight.navigator.steer(state, now_s);
    const Command command = flight.regulator->regulate(setpoint, state);
    state = flight.model->step(state, applied, period_s);
    applied = command;  // what is commanded now acts one step later
    flight.recorder.step_ends();
    flight.referee.hear(now_s, flight.navigator.report());
    flight.referee.judge(now_s + period_s, state);
  }
  return flight.recorder.finish(static_cast<double>(tick) * period_s, state, flight.referee);
}

}  // namespace voronaut
