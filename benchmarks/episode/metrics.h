#pragma once

#include <span>
#include <string>

#include "voronaut/benchmarks/episode/episode_log.h"
#include "voronaut/dynamics/model.h"
#include "voronaut/reports/run_record.h"

// Metrics of a flight: pure functions of its log. Less is better for lengths, times and ratios,
// more is better for clearance, speed and SPL.
namespace voronaut {

// Length of the track in the plane [m].
double path_length_m(std::span<const Tick> ticks);

// Smallest and mean clearance of the centre to the true surface [m]; NaN for no ticks.
double clearance_smallest_m(std::span<const Tick> ticks);
double clearance_mean_m(std::span<const Tick> ticks);

// Speed in the plane over the ticks from departure_s on [m/s]: mean = length / time.
double speed_mean_m_s(std::span<const Tick> ticks, double departure_s);
double speed_max_m_s(std::span<const Tick> ticks);

// Lengths below the goal's tolerance > 0 count as the tolerance, so that who starts at the goal and
// goes nowhere has taken the shortest path: 0 / 0 is 1. Elsewhere every length is above it.
//
// Success weighted by path length (Anderson et al. 2018, arXiv:1807.06757, eq. 1, one term):
// 0 for a failure, else shortest / max(flown, shortest).
double spl(bool success, double shortest_m, double flown_m, double goal_tolerance_m);
// Length to the goal over the shortest; NaN without a shortest path.
double path_ratio(double to_goal_m, double shortest_m, double goal_tolerance_m);

// Root mean square and largest of the distances from the path followed [m], over the scans that
// have one; NaN where none has.
struct TrackingError {
  double rms_m = kAbsent;
  double max_m = kAbsent;
};
TrackingError tracking_error(std::span<const ScanEvent> scans);

// Sum of the model's power after each step times its length [J]: exact for actuators that hold
// still over a step. NaN for a model that has no power.
double energy_j(std::span<const Tick> ticks, const Model& model);

double mean(std::span<const double> samples);

// 64-bit FNV-1a over the bits of every state, as 16 hexadecimal digits: two flights with the same
// digest are the same flight.
std::string state_digest(std::span<const Tick> ticks);

// The columns of the path of `ticks`, which is not empty; of one that reached the goal the ratio
// counts the rest of the way: it may end at the goal's tolerance, the reference ends at the goal.
void add_path(RunRecord& record, std::span<const Tick> ticks, const Scenario& scenario);

}  // namespace voronaut
