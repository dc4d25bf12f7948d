#include "voronaut/reports/outcome.h"

#include <set>
#include <stdexcept>

#include <gtest/gtest.h>

namespace voronaut {
namespace {

TEST(Outcome, NamesGoBothWays) {
  for (const OutcomeEntry& entry : kOutcomes) {
    EXPECT_EQ(outcome_from_string(to_string(entry.outcome)), entry.outcome);
  }
  EXPECT_THROW(outcome_from_string("victory"), std::invalid_argument);
}

TEST(Outcome, IsToldFromTheOthersByNameSignAndColour) {
  std::set<std::string_view> names, signs, colours, on_dark;
  for (const OutcomeEntry& entry : kOutcomes) {
    names.insert(entry.name);
    signs.insert(entry.sign);
    colours.insert(entry.colour);
    on_dark.insert(entry.colour_on_dark);
  }
  for (const auto* set : {&names, &signs, &colours, &on_dark})
    EXPECT_EQ(set->size(), kOutcomes.size());
}

TEST(Outcome, OnlyTheGoalIsNoFailureAndWhatIsCutOffIsOne) {
  for (const OutcomeEntry& entry : kOutcomes) {
    EXPECT_EQ(entry.failure, entry.outcome != Outcome::goal_reached) << entry.name;
    EXPECT_TRUE(entry.failure || !entry.cut_off) << entry.name;
  }
}

}  // namespace
}  // namespace voronaut
