#pragma once

#include <span>

#include "voronaut/benchmarks/episode/episode_log.h"
#include "voronaut/reports/run_record.h"

// The rules by which the BARN challenge counts since 2024 (Daffan/the-barn-challenge at bf5a226,
// run.py).
namespace voronaut {

// From the first tick that is 0.1 m away from the first one to end_s [s]; absent if there is none.
double barn_time_s(std::span<const Tick> ticks, double end_s);

// Time, score and pace of a flight over a course whose own length is course_length_m > 0. With OT
// that length at 2 m/s and AT the time: score = OT / clip(AT, 2 OT, 8 OT) where it arrived, else 0,
// pace = OT / AT where it arrived. Who was there without moving has the best score and no time.
void add_barn(RunRecord& record, std::span<const Tick> ticks, double course_length_m);

}  // namespace voronaut
