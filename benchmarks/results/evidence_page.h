#pragma once

#include <string>
#include <vector>

#include "voronaut/benchmarks/suite/acceptance_criterion.h"
#include "voronaut/reports/run_record.h"

// The page that holds the acceptance criteria of suites against their results.
namespace voronaut {

// One suite that was flown, with all it flew.
struct SuiteEvidence {
  std::string suite;
  std::string about;   // what it shows, one line
  std::string commit;  // of the program that flew it
  std::string started_utc;
  std::string digest;
  std::vector<AcceptanceCriterion> criteria;
  std::vector<RunRecord> records;
};

struct EvidencePage {
  std::string markdown;
  bool holds = true;  // every criterion of every suite
};

// A section per suite: its criteria with what was measured, and a row per scenario group, vehicle
// and planner with n, the statistics of kEvidence with intervals of 95 % and how trials ended
// otherwise. Above them the sums over all suites. O(resamples * records).
EvidencePage evidence_page(const std::vector<SuiteEvidence>& suites);

}  // namespace voronaut
