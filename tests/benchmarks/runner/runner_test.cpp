#include "voronaut/benchmarks/runner/runner.h"

#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "voronaut/benchmarks/results/digest.h"
#include "voronaut/benchmarks/runner/isolated_world.h"
#include "voronaut/benchmarks/suite/suite_trials.h"
#include "voronaut/tests/benchmarks/small_suite.h"

namespace voronaut {
namespace {

const std::vector<std::string> kCalm = {"a", "b", "c"};

RunReport run(const SuiteConfig& suite, const FlyTrial& fly, std::size_t jobs,
              const std::filesystem::path& database) {
  std::ostringstream out;
  Progress progress(out, false, SuiteTrials(suite).total(), std::chrono::steady_clock::now());
  ShortestReferences references = made_up_references();
  ResultStore store = ResultStore::create(database);
  return run_suite(suite, fly, jobs, references, store, progress);
}

FlyTrial calm() {
  return [](const TrialSpec& spec, bool) { return made_up_flight(spec); };
}

// A part of each block is touched: a sanitized build counts that alone.
[[noreturn]] void hoard_memory() {
  std::vector<char*> hoard;
  while (true) {
    hoard.push_back(new char[1U << 24U]);
    std::memset(hoard.back(), 'x', 1U << 20U);
  }
}

// Misbehaves as the planner's label says.
TrialResult misbehave(const TrialSpec& spec, bool) {
  const std::string& label = spec.planner.label;
  if (label == "aborts") std::abort();
  if (label == "segfaults") std::raise(SIGSEGV);
  if (label == "throws") throw std::runtime_error("lost the roadmap");
  if (label == "exits") std::exit(3);
  if (label == "eats") hoard_memory();
  if (label == "loops")
    for (volatile std::uint64_t i = 0;;) i = i + 1;
  if (label == "sleeps")
    while (true) pause();
  return made_up_flight(spec);
}

TEST(Runner, MakesARowOfEverythingThatCanHappenAndHarmsNoOther) {
  const TemporaryFolder folder;
  const SuiteConfig suite =
      small_suite("mixed", {"fine", "aborts", "segfaults", "throws", "exits", "eats", "fine_too"});
  const RunReport report = run(suite, misbehave, 2, folder.path() / "results.db");
  EXPECT_EQ(report.done, 14U);
  EXPECT_FALSE(report.interrupted);
  const auto fine = std::make_pair(Outcome::goal_reached, std::string("made up"));
  const std::map<std::string, std::pair<Outcome, std::string>> expected = {
      {"fine", fine},
      {"fine_too", fine},
      {"aborts", {Outcome::crash, "ended by SIGABRT"}},
      {"segfaults", {Outcome::crash, "ended by SIGSEGV"}},
      {"throws", {Outcome::crash, "exception: lost the roadmap"}},
      {"exits", {Outcome::crash, "ended the process with exit code 3"}},
      {"eats", {Outcome::memory, "asked for more than 256 MB of memory"}}};
  const auto records = ResultStore::open(folder.path() / "results.db").records();
  ASSERT_EQ(records.size(), 14U);
  for (const RunRecord& record : records) {
    EXPECT_EQ(record.outcome, expected.at(record.planner).first) << record.planner;
    EXPECT_EQ(record.reason, expected.at(record.planner).second);
    EXPECT_EQ(record.suite, "mixed");
    EXPECT_EQ(record.vehicle, "quadrotor");
    EXPECT_GT(record.shortest_length_m, 0) << "references belong to failures too";
    EXPECT_GE(record.cpu_time_s, 0);
    EXPECT_GE(record.memory_max_mb, 0);
    EXPECT_EQ(record.memory_max_mb > 10, record.planner == "eats") << record.memory_max_mb;
    EXPECT_EQ(entry_of(record.outcome).cut_off, record.outcome != Outcome::goal_reached);
  }
}

TEST(Runner, StopsWhatComputesForever) {
  const TemporaryFolder folder;
  SuiteConfig suite = small_suite("looping", {"loops"});
  suite.limits.process.cpu_s = 1;
  run(suite, misbehave, 2, folder.path() / "results.db");
  const auto records = ResultStore::open(folder.path() / "results.db").records();
  ASSERT_EQ(records.size(), 2U);
  for (const RunRecord& record : records) {
    EXPECT_EQ(record.outcome, Outcome::killed);
    EXPECT_EQ(record.reason, "used more than 1 s of CPU time");
  }
}

TEST(Runner, StopsWhatWaitsForever) {
  const TemporaryFolder folder;
  SuiteConfig suite = small_suite("sleeping", {"sleeps"});
  suite.limits.process.wall_s = 0.5;
  run(suite, misbehave, 2, folder.path() / "results.db");
  const auto records = ResultStore::open(folder.path() / "results.db").records();
  ASSERT_EQ(records.size(), 2U);
  for (const RunRecord& record : records) {
    EXPECT_EQ(record.outcome, Outcome::killed);
    EXPECT_EQ(record.reason, "took longer than 0.5 s");
  }
}

TEST(Runner, GivesTheSameDigestForAnyNumberOfJobs) {
  const TemporaryFolder folder;
  const SuiteConfig suite = small_suite("jobs", kCalm, 3);
  run(suite, calm(), 1, folder.path() / "one.db");
  run(suite, calm(), 3, folder.path() / "three.db");
  const auto one = ResultStore::open(folder.path() / "one.db").records();
  const auto three = ResultStore::open(folder.path() / "three.db").records();
  EXPECT_EQ(one.size(), 18U);
  EXPECT_EQ(digest(one), digest(three));
  auto changed = one;
  changed[4].duration_s += 1e-12;
  EXPECT_NE(digest(one), digest(changed));
  auto rated = one;
  rated.front().free_share = 0.123;
  rated.front().narrowest_passage_m = 4.56;
  rated.front().cpu_time_s = 7.89;
  EXPECT_EQ(digest(one), digest(rated))
      << "what is measured and how hard the world is is no result";
}

TEST(Runner, RunsNothingTwice) {
  const TemporaryFolder folder;
  const SuiteConfig suite = small_suite("twice", kCalm);
  EXPECT_EQ(run(suite, calm(), 2, folder.path() / "results.db").done, 6U);
  const RunReport again = run(
      suite, [](const TrialSpec&, bool) -> TrialResult { std::abort(); }, 2,
      folder.path() / "results.db");
  EXPECT_EQ(again.stored, 6U);
  EXPECT_EQ(again.done, 0U);
}

TEST(Runner, GoesOnWhereAnEarlierRunStoppedWithMoreRepetitions) {
  const TemporaryFolder folder;
  run(small_suite("more", kCalm, 1), calm(), 1, folder.path() / "results.db");
  const RunReport more =
      run(small_suite("more", kCalm, 2), calm(), 1, folder.path() / "results.db");
  EXPECT_EQ(more.stored, 6U);
  EXPECT_EQ(more.done, 6U);
}

void wait_for(const std::filesystem::path& file) {
  while (!std::filesystem::exists(file)) usleep(1000);
}

// Starts a runner in a process of its own and ends it by a signal once `file` is there.
int run_and_signal(const SuiteConfig& suite, const FlyTrial& fly,
                   const std::filesystem::path& database, int signal,
                   const std::filesystem::path& file, std::size_t jobs) {
  std::filesystem::remove(file);
  const pid_t runner = fork();
  if (runner == 0) {
    const RunReport report = run(suite, fly, jobs, database);
    _exit(report.interrupted ? 1 : report.stopped ? 3 : 0);
  }
  wait_for(file);
  kill(runner, signal);
  int status = 0;
  waitpid(runner, &status, 0);
  return status;
}

void expect_completion(int signal) {
  const TemporaryFolder folder;
  const auto database = folder.path() / "results.db";
  const SuiteConfig suite = small_suite("killed", kCalm, 8);
  const TemporaryFolder notes;
  const FlyTrial flown_until_noted = [&](const TrialSpec& spec, bool) {
    if (spec.repetition == 5) {
      std::ofstream(notes.path() / "flying").close();
      while (true) pause();
    }
    return made_up_flight(spec);
  };
  const int status =
      run_and_signal(suite, flown_until_noted, database, signal, notes.path() / "flying", 2);
  if (signal == SIGKILL) {
    EXPECT_TRUE(WIFSIGNALED(status));
  } else {
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == (signal == SIGINT ? 1 : 3)) << status;
  }
  const RunReport rest = run(suite, calm(), 2, database);
  EXPECT_EQ(rest.stored + rest.done, 48U);
  EXPECT_GT(rest.done, 0U);
  const auto records = ResultStore::open(database).records();
  EXPECT_EQ(records.size(), 48U);
  std::set<std::string> ids;
  for (const RunRecord& record : records) ids.insert(record.trial_id);
  EXPECT_EQ(ids.size(), 48U);
  run(suite, calm(), 1, folder.path() / "whole.db");
  EXPECT_EQ(digest(records), digest(ResultStore::open(folder.path() / "whole.db").records()));
}

TEST(Runner, IsCompletedByTheNextRunAfterSigkill) { expect_completion(SIGKILL); }
TEST(Runner, StopsInOrderOnSigintAndIsCompletedByTheNextRun) { expect_completion(SIGINT); }
TEST(Runner, StopsInOrderOnSigtermAndIsCompletedByTheNextRun) { expect_completion(SIGTERM); }
TEST(Runner, StopsInOrderOnSigusr1AndIsCompletedByTheNextRun) { expect_completion(SIGUSR1); }

TEST(Runner, FliesAgainOnceWhatSomebodyElseKilled) {
  const TemporaryFolder folder;
  const TemporaryFolder notes;
  const FlyTrial fly = [&](const TrialSpec& spec, bool) {
    const auto note = notes.path() / spec.trial_id;
    const bool first = !std::filesystem::exists(note);
    std::ofstream(note).close();
    if (spec.planner.label == "always" || (spec.planner.label == "once" && first))
      kill(getpid(), SIGKILL);
    return made_up_flight(spec);
  };
  run(small_suite("shot", {"calm", "once", "always"}), fly, 2, folder.path() / "results.db");
  const auto records = ResultStore::open(folder.path() / "results.db").records();
  ASSERT_EQ(records.size(), 6U);
  for (const RunRecord& record : records) {
    const bool lost = record.planner == "always";
    EXPECT_EQ(record.outcome, lost ? Outcome::killed : Outcome::goal_reached);
    EXPECT_EQ(
        record.reason,
        lost ? "ended by SIGKILL, which no limit sent, and so when it was flown again" : "made up");
  }
}

TEST(Runner, MakesARowOfATrialThatTakesTheRunnerAlongAndFliesAllOthers) {
  const TemporaryFolder folder;
  const TemporaryFolder notes;
  const auto database = folder.path() / "results.db";
  const SuiteConfig suite = small_suite("deadly", {"a", "deadly", "b"});
  const auto is_deadly = [](const TrialSpec& spec) {
    return spec.planner.label == "deadly" && spec.scenario.name == "open";
  };
  // It waits: the runner is killed while it flies.
  const FlyTrial fly = [&](const TrialSpec& spec, bool) {
    if (is_deadly(spec)) {
      std::ofstream(notes.path() / "flying").close();
      while (true) pause();
    }
    return made_up_flight(spec);
  };
  run_and_signal(suite, fly, database, SIGKILL, notes.path() / "flying", 1);
  run_and_signal(suite, fly, database, SIGKILL, notes.path() / "flying", 1);
  EXPECT_EQ(ResultStore::open(database).records().size(), 5U) << "it was flown last";
  EXPECT_EQ(run(suite, calm(), 2, database).done, 1U);
  for (const RunRecord& record : ResultStore::open(database).records()) {
    const bool deadly = record.planner == "deadly" && record.scenario == "open";
    EXPECT_EQ(record.outcome, deadly ? Outcome::crash : Outcome::goal_reached);
    if (deadly) {
      EXPECT_EQ(record.reason,
                "the runner ended while this trial flew, and again when it flew alone");
    }
  }
  EXPECT_FALSE(std::filesystem::exists(database.string() + "-in-flight"));
}

TEST(Runner, KeepsTracesAsTheSuiteAsks) {
  const FlyTrial fly = [](const TrialSpec& spec, bool keep_trace) {
    TrialResult result = made_up_flight(spec);
    if (spec.planner.label == "b") result.record.outcome = Outcome::collision;
    if (keep_trace) result.trace.emplace().trial_id = spec.trial_id;
    return result;
  };
  for (const auto& [keeping, expected] :
       {std::pair(TraceKeeping::all, 6), std::pair(TraceKeeping::failures, 2),
        std::pair(TraceKeeping::none, 0)}) {
    const TemporaryFolder folder;
    SuiteConfig suite = small_suite("traces", kCalm);
    suite.traces = keeping;
    run(suite, fly, 1, folder.path() / "results.db");
    const ResultStore store = ResultStore::open(folder.path() / "results.db");
    int traces = 0;
    for (const std::string& id : store.trial_ids()) traces += store.trace(id) ? 1 : 0;
    EXPECT_EQ(traces, expected);
    EXPECT_EQ(store.worlds().size(), 2U);
  }
}

TEST(Runner, ComputesEachReferenceOnce) {
  const TemporaryFolder folder;
  int calls = 0;
  ShortestReferences references([&](const Scenario&, double radius_m) {
    ++calls;
    return radius_m;
  });
  std::ostringstream out;
  const SuiteConfig suite = small_suite("references", kCalm, 4);
  Progress progress(out, false, 24, std::chrono::steady_clock::now());
  ResultStore store = ResultStore::create(folder.path() / "results.db");
  run_suite(suite, calm(), 1, references, store, progress);
  EXPECT_EQ(calls, 2 + 4 * 2) << "one fixed world, four random ones, two radii";
  for (const RunRecord& record : store.records()) {
    EXPECT_EQ(record.shortest_length_m, 0.25);
    EXPECT_EQ(record.shortest_at_clearance_m, 0.31);
  }
}

TEST(Runner, RatesEachWorldOnceAndWritesItToAllOfItsTrials) {
  const TemporaryFolder folder;
  int calls = 0;
  ShortestReferences references([](const Scenario&, double radius_m) { return radius_m; },
                                [&](const Scenario& scenario) -> WorldDifficulty {
                                  ++calls;
                                  return {0.5, scenario.goal_world.x()};
                                });
  std::ostringstream out;
  const SuiteConfig suite = small_suite("rated", kCalm, 4);
  Progress progress(out, false, 24, std::chrono::steady_clock::now());
  ResultStore store = ResultStore::create(folder.path() / "results.db");
  run_suite(suite, calm(), 1, references, store, progress);
  EXPECT_EQ(calls, 1 + 4) << "one fixed world, four random ones";
  for (const RunRecord& record : store.records()) {
    EXPECT_EQ(record.free_share, 0.5);
    EXPECT_GT(record.narrowest_passage_m, 0);
  }
}

TEST(Runner, MakesRowsOfAWorldThatEndsTheProcessThatMeasuresItAndGoesOn) {
  const TemporaryFolder folder;
  ShortestReferences references =
      isolated_references([](const Scenario& scenario, double radius_m) {
        if (scenario.name == "open") std::raise(SIGSEGV);
        return radius_m;
      });
  std::ostringstream out;
  const SuiteConfig suite = small_suite("deadly", kCalm);
  Progress progress(out, false, 6, std::chrono::steady_clock::now());
  ResultStore store = ResultStore::create(folder.path() / "results.db");
  EXPECT_EQ(run_suite(suite, calm(), 2, references, store, progress).done, 6U);
  for (const RunRecord& record : store.records()) {
    const bool open = record.scenario == "open";
    EXPECT_EQ(record.outcome, open ? Outcome::invalid : Outcome::goal_reached);
    EXPECT_EQ(record.reason, open ? "the shortest path of its world: ended by SIGSEGV" : "made up");
    if (!open) {
      EXPECT_EQ(record.shortest_length_m, 0.25);
    }
  }
}

// The next call in a child of this process kills the child, later ones do not.
class OneShot {
 public:
  void fire() const {
    if (std::filesystem::exists(note_)) return;
    std::ofstream(note_).close();
    kill(getpid(), SIGTERM);
  }

 private:
  TemporaryFolder folder_;
  std::filesystem::path note_ = folder_.path() / "fired";
};

TEST(Runner, KeepsNoRowOfAWorldThatWasEndedTogetherWithTheRun) {
  const TemporaryFolder folder;
  ShortestReferences references([](const Scenario&, double) -> double {
    kill(getpid(), SIGTERM);
    throw std::runtime_error("ended by SIGTERM");
  });
  std::ostringstream out;
  const SuiteConfig suite = small_suite("requeued", kCalm);
  Progress progress(out, false, 6, std::chrono::steady_clock::now());
  ResultStore store = ResultStore::create(folder.path() / "results.db");
  EXPECT_TRUE(run_suite(suite, calm(), 1, references, store, progress).stopped);
  EXPECT_EQ(store.records().size(), 0U);
}

TEST(References, AreMeasuredOnceMoreWhereSomebodyKilledWhoDid) {
  const OneShot somebody;
  const auto length = isolated_length([&](const Scenario&, double radius_m) {
    somebody.fire();
    return radius_m;
  });
  EXPECT_EQ(length({}, 0.25), 0.25);
}

TEST(Rehearsal, IsDoneOnceMoreWhereSomebodyKilledIt) {
  const OneShot somebody;
  const SuiteTrials::Rehearse rehearse = rehearse_in_child();
  EXPECT_EQ(rehearse([&] { somebody.fire(); }), "");
  EXPECT_NE(rehearse([] { kill(getpid(), SIGTERM); }), "") << "each time";
}

TEST(Rehearsal, WarnsOfWhatEndsItsProcessAndOfNothingElse) {
  const SuiteTrials::Rehearse rehearse = rehearse_in_child();
  EXPECT_EQ(rehearse([] {}), "");
  EXPECT_EQ(rehearse([] { throw std::runtime_error("no room"); }), "") << "can be caught here";
  EXPECT_EQ(rehearse([] { std::abort(); }), "making its world: ended by SIGABRT");
}

}  // namespace
}  // namespace voronaut
