#include "voronaut/benchmarks/isolation/flight_marks.h"

#include <csignal>
#include <functional>
#include <string>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "voronaut/tests/support/temporary_folder.h"

namespace voronaut {
namespace {

using Suspicion = FlightMarks::Suspicion;

class Marks : public ::testing::Test {
 protected:
  std::filesystem::path file() const { return folder_.path() / "results.db-in-flight"; }

  // A runner that does this and then dies without a word.
  void die_after(const std::function<void(FlightMarks&)>& deeds) const {
    const pid_t runner = fork();
    if (runner == 0) {
      FlightMarks marks(file());
      deeds(marks);
      kill(getpid(), SIGKILL);
    }
    waitpid(runner, nullptr, 0);
  }

 private:
  TemporaryFolder folder_;
};

TEST_F(Marks, AreTakenBackByARunnerThatEndsInOrder) {
  {
    FlightMarks marks(file());
    marks.takes_off("a", false);
    EXPECT_TRUE(std::filesystem::exists(file()));
  }
  EXPECT_FALSE(std::filesystem::exists(file()));
}

TEST_F(Marks, OutliveARunnerAndTellWhatWasInFlight) {
  die_after([](FlightMarks& marks) {
    for (const char* id : {"flying", "landed", "stored", "beside"}) marks.takes_off(id, false);
    marks.landed("landed");
    marks.landed("stored");
    marks.stored("stored");
  });
  const FlightMarks marks(file());
  EXPECT_EQ(marks.suspicion("flying"), Suspicion::suspect);
  EXPECT_EQ(marks.suspicion("beside"), Suspicion::suspect);
  EXPECT_EQ(marks.suspicion("landed"), Suspicion::none);
  EXPECT_EQ(marks.suspicion("stored"), Suspicion::none);
  EXPECT_EQ(marks.suspicion("never flown"), Suspicion::none);
}

TEST_F(Marks, BlameATrialOnlyForASecondDeathWithNothingElseInFlight) {
  const std::string id(FlightMarks::kIdBytes, 'f');
  for (int death = 0; death < 3; ++death)
    die_after([&](FlightMarks& marks) { marks.takes_off(id, false); });
  EXPECT_EQ(FlightMarks(file()).suspicion(id), Suspicion::suspect);
  die_after([&](FlightMarks& marks) { marks.takes_off(id, true); });
  EXPECT_EQ(FlightMarks(file()).suspicion(id), Suspicion::culprit);
}

TEST_F(Marks, KeepSuspectsThatWereNotFlownAgain) {
  die_after([](FlightMarks& marks) { marks.takes_off("a", false); });
  { const FlightMarks interrupted(file()); }
  {
    FlightMarks marks(file());
    marks.takes_off("a", true);  // and dropped in order
  }
  FlightMarks marks(file());
  EXPECT_EQ(marks.suspicion("a"), Suspicion::suspect);
  marks.stored("a");
  EXPECT_EQ(marks.suspicion("a"), Suspicion::none);
}

TEST_F(Marks, GoWithoutWhatDoesNotFit) {
  FlightMarks marks(file());
  for (std::size_t i = 0; i < FlightMarks::kFlightsMax; ++i)
    marks.takes_off(std::to_string(i), false);
  marks.takes_off("one too many", false);
  marks.landed("one too many");
  marks.stored("one too many");
  marks.stored("7");
  marks.takes_off("now there is a place", false);
  EXPECT_EQ(marks.suspicion("now there is a place"), Suspicion::none);
}

TEST(FlightMarksFile, ThatCannotBeWrittenIsNamed) {
  try {
    const FlightMarks marks("/nowhere/results.db-in-flight");
    FAIL() << "no error";
  } catch (const std::exception& error) {
    EXPECT_NE(std::string(error.what()).find("/nowhere/results.db-in-flight: cannot write"),
              std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace voronaut
