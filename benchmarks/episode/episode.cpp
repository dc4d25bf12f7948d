#include "voronaut/benchmarks/episode/episode.h"

#include <utility>

namespace voronaut {

EpisodeLog fly(Flight& flight) {
  const double period_s = flight.spec.flight.loop.vehicle_period_s;
  const Scenario& scenario = flight.spec.scenario;
  const Vec3 start(scenario.start_world.x(), scenario.start_world.y(), scenario.start_height_m);

  VehicleState state = flight.model->at_rest(start, scenario.start_heading);
  Command applied = flight.model->hold();
  Setpoint setpoint;
  flight.regulator->reset(state);

  for (std::size_t tick = 0; !flight.referee.verdict(); ++tick) {
    const double now_s = static_cast<double>(tick) * period_s;
    flight.log.ticks.push_back(
        {now_s, state, scenario.world->clearance_m(state.p_world.head<2>())});
    const bool scan_is_due = flight.scan_is_due(tick);
    flight.log.step.measure([&] {
      if (scan_is_due) {
        flight.sense(state, now_s);
        flight.log.mapping.measure([&] { flight.update_map(); });
        flight.log.planning.measure([&] { flight.plan(state, now_s); });
      }
      setpoint = flight.navigate(state, now_s);
      const Command command = flight.regulator->regulate(setpoint, state);
      state = flight.model->step(state, applied, period_s);
      applied = command;  // what is commanded now acts one step later
    });
    if (scan_is_due) flight.record_scan(setpoint);
    flight.referee.judge(now_s + period_s, state);
  }
  const double end_s = static_cast<double>(flight.log.ticks.size()) * period_s;
  flight.log.ticks.push_back({end_s, state, scenario.world->clearance_m(state.p_world.head<2>())});
  flight.log.verdict = *flight.referee.verdict();
  flight.log.end_s = flight.referee.end_s();
  return std::move(flight.log);
}

}  // namespace voronaut
