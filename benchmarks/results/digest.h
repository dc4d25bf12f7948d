#pragma once

#include <string>
#include <vector>

#include "voronaut/reports/run_record.h"
#include "voronaut/reports/store/store.h"

namespace voronaut {

// The deterministic columns of a record, one "name=value" per line; numbers as the shortest decimal
// that reads back, absent ones empty, -0 as 0.
std::string deterministic_text(const RunRecord& record);

// Where the deterministic columns of two records differ, "name: a, now b; ..."; empty if they do
// not.
std::string difference_text(const RunRecord& stored, const RunRecord& flown);

// SHA-256 over the deterministic columns of all records, which come ordered by trial id.
std::string digest(const std::vector<RunRecord>& records);
std::string digest(const ResultStore& store);

// Whether two trials flew alike: their part of flights_digest(), whatever world, vehicle, planner
// and repetition are called.
bool same_flight(const RunRecord& a, const RunRecord& b);

// What was flown, whatever names its parts go by: SHA-256 over scenario, vehicle, planner,
// repetition, outcome, the numbers of the flight and its state digest, in the order of the first
// four. Ids, seeds, names of keys and columns, modes and reasons are left out, so that it stays
// equal while those are renamed. O(n log n).
std::string flights_digest(const ResultStore& store);

}  // namespace voronaut
