#include "voronaut/reports/store/packed_trial.h"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "voronaut/reports/store/store.h"

namespace voronaut {
namespace {

PackedTrial sample() {
  PackedTrial trial;
  trial.record.trial_id = "ab12";
  trial.record.reason = std::string("with\0zero", 9);
  trial.record.outcome = Outcome::timeout;
  trial.record.seed = -1;
  trial.record.duration_s = 0.1;
  trial.record.path_length_m = -0.0;
  trial.trace_blob = std::string("\x00\xff", 2);
  return trial;
}

TEST(PackedTrial, ComesBackBitForBit) {
  const PackedTrial trial = sample();
  const PackedTrial back = unpack(pack(trial));
  EXPECT_FALSE(first_difference(back.record, trial.record));
  EXPECT_EQ(back.record.reason, trial.record.reason);
  EXPECT_TRUE(std::signbit(back.record.path_length_m));
  EXPECT_TRUE(std::isnan(back.record.spl));
  EXPECT_EQ(back.trace_blob, trial.trace_blob);
}

TEST(PackedTrial, RefusesWhatIsCutShortOrTooLong) {
  const std::string bytes = pack(sample());
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_THROW(unpack(std::string_view(bytes).substr(0, size)), std::invalid_argument);
  EXPECT_THROW(unpack(bytes + "x"), std::invalid_argument);
}

}  // namespace
}  // namespace voronaut
