#include "voronaut/benchmarks/runner/progress.h"

#include <sstream>

#include <gtest/gtest.h>

namespace voronaut {
namespace {

using std::chrono::seconds;

TEST(Progress, TellsRateAndTimeLeftFromThisRunAlone) {
  const Progress::Time begin{};
  std::ostringstream out;
  Progress progress(out, false, 100, begin);
  EXPECT_EQ(progress.line(begin), "0/100 trials");
  for (int i = 0; i < 40; ++i) progress.trial_stored();
  EXPECT_EQ(progress.line(begin + seconds(1)), "40/100 trials");
  for (int i = 0; i < 20; ++i) progress.trial_done(i < 2);
  EXPECT_EQ(progress.line(begin + seconds(4)), "60/100 trials, 5.0/s, 8 s left, 2 failed");
  for (int i = 0; i < 40; ++i) progress.trial_done(false);
  EXPECT_EQ(progress.line(begin + seconds(5)), "100/100 trials, 12/s, 2 failed");
}

TEST(Progress, PrintsPlainLinesEveryFewSeconds) {
  const Progress::Time begin{};
  std::ostringstream out;
  Progress progress(out, false, 10, begin);
  for (int tenth = 0; tenth < 110; ++tenth) progress.tick(begin + tenth * seconds(1) / 10);
  progress.finish(begin + seconds(11));
  EXPECT_EQ(out.str(), "0/10 trials\n0/10 trials\n0/10 trials\n");
}

TEST(Progress, RewritesOneLineOnATerminal) {
  const Progress::Time begin{};
  std::ostringstream out;
  Progress progress(out, true, 2, begin);
  progress.trial_done(false);
  progress.tick(begin + seconds(1));
  progress.trial_done(false);
  progress.finish(begin + seconds(2));
  EXPECT_EQ(out.str(), "\r1/2 trials, 1.0/s, 1 s left\r2/2 trials, 1.0/s          \n");
}

TEST(Progress, WritesDurationsAsPeopleDo) {
  EXPECT_EQ(duration_text(0.85), "850 ms");
  EXPECT_EQ(duration_text(0.9999), "1 s");
  EXPECT_EQ(duration_text(59.4), "59 s");
  EXPECT_EQ(duration_text(59.6), "1 min 00 s");
  EXPECT_EQ(duration_text(185), "3 min 05 s");
  EXPECT_EQ(duration_text(7621), "2 h 07 min");
}

}  // namespace
}  // namespace voronaut
