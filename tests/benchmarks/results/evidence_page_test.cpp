#include "voronaut/benchmarks/results/evidence_page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace voronaut {
namespace {

using ::testing::HasSubstr;

SuiteEvidence evidence(Outcome last) {
  SuiteEvidence evidence{"evidence-wood", "Ten woods", "abc", "2020-01-01T00:00:00Z", "d1", {}, {}};
  for (int i = 0; i < 10; ++i) {
    RunRecord record;
    record.scenario_group = "wood";
    record.vehicle = "ideal";
    record.planner = "a";
    record.outcome = i < 9 ? Outcome::goal_reached : last;
    record.clearance_smallest_m = 0.3 + 0.01 * i;
    record.path_ratio = i < 9 ? 1.25 : kAbsent;
    evidence.records.push_back(record);
  }
  AcceptanceCriterion safe;
  safe.bound("collision_share_max") = 0;
  evidence.criteria.push_back(safe);
  return evidence;
}

TEST(EvidencePage, HasARowWithCountsIntervalsAndTheSmallestClearance) {
  const EvidencePage page = evidence_page({evidence(Outcome::stuck)});
  EXPECT_TRUE(page.holds);
  EXPECT_THAT(page.markdown,
              HasSubstr("1 suites, 10 flights, 0 collisions, smallest clearance 0.300 m. Every "
                        "acceptance criterion holds."));
  EXPECT_THAT(page.markdown, HasSubstr("## evidence-wood\n\nTen woods\n\n- holds: every trial: "
                                       "collisions <= 0 % (0 of 10)\n"));
  EXPECT_THAT(page.markdown,
              HasSubstr("| 9 of 10, 90.0 % [59.6, 98.2] |"));  // Wilson's interval of 9 in 10
  EXPECT_THAT(page.markdown, HasSubstr("1 stuck"));
  EXPECT_THAT(page.markdown, HasSubstr("1.250 [1.250, 1.250]"));
  EXPECT_THAT(page.markdown, HasSubstr("Flown 2020-01-01T00:00:00Z by commit abc, digest `d1`."));
}

TEST(EvidencePage, SaysWhichCriterionIsBroken) {
  const EvidencePage page = evidence_page({evidence(Outcome::stuck), evidence(Outcome::collision)});
  EXPECT_FALSE(page.holds);
  EXPECT_THAT(page.markdown, HasSubstr("20 flights, 1 collisions (1 in evidence-wood), smallest"));
  EXPECT_THAT(page.markdown, HasSubstr("**Not every acceptance criterion holds.**"));
  EXPECT_THAT(page.markdown, HasSubstr("- **broken**: every trial: collisions <= 0 % (1 of 10)\n"));
}

TEST(EvidencePage, GivesTheWorldsOfBarnTheirOwnScore) {
  SuiteEvidence barn{"real-barn", "Courses", "abc", "2020-01-01T00:00:00Z", "d1", {}, {}};
  RunRecord record;
  record.outcome = Outcome::goal_reached;
  for (const double score : {0.25, 0.5, 0.125}) {
    record.barn_score = score;
    barn.records.push_back(record);
  }
  record.outcome = Outcome::collision;
  record.barn_score = 0;
  barn.records.push_back(record);
  const EvidencePage page = evidence_page({barn});
  EXPECT_THAT(page.markdown, HasSubstr("BARN score"));
  EXPECT_THAT(page.markdown, HasSubstr("| 0.219 (too few: 0.000, 0.125, 0.250, 0.500) |"));
  EXPECT_THAT(evidence_page({evidence(Outcome::stuck)}).markdown,
              ::testing::Not(HasSubstr("BARN")));
}

}  // namespace
}  // namespace voronaut
