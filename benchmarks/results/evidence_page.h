#pragma once

#include <string>
#include <vector>

#include "voronaut/benchmarks/suite/claim.h"
#include "voronaut/reports/run_record.h"

// The page that holds the claims of suites against their results.
namespace voronaut {

// One suite that was flown, with all it flew.
struct SuiteEvidence {
  std::string suite;
  std::string about;   // what it shows, one line
  std::string commit;  // of the program that flew it
  std::string started_utc;
  std::string digest;
  std::vector<Claim> claims;
  std::vector<RunRecord> records;
};

struct EvidencePage {
  std::string markdown;
  bool holds = true;  // every claim of every suite
};

// A section per suite: its claims with what was measured, and a row per scenario group, vehicle and
// planner with n, intervals of 95 %, collisions, the smallest clearance and the path ratio. Above
// them the sums over all suites. O(resamples * records).
EvidencePage evidence_page(const std::vector<SuiteEvidence>& suites);

}  // namespace voronaut
