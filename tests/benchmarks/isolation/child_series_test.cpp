#include <csignal>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/shm.h>
#include <unistd.h>

#include "voronaut/benchmarks/isolation/process_pool.h"

// Children of one warm parent: none sees what another did, and all of them see what was prepared.
namespace voronaut {
namespace {

using End = ChildReport::End;
using Task = ChildSeries::Task;

constexpr ProcessLimits kGenerous{.memory_mb = 256, .cpu_s = 600, .wall_s = 600};

class Series : public ::testing::TestWithParam<bool> {
 protected:
  ChildSeries::Setup setup() const { return {.namespaces = GetParam()}; }

  // Of the children that were started.
  std::vector<ChildReport> run(const std::vector<Task>& tasks,
                               const ProcessLimits& limits = kGenerous) const {
    std::vector<ChildReport> reports;
    ChildSeries series(tasks, limits, setup());
    while (series.start_next()) {
      while (!series.has_ended()) {
        series.read_output();
        usleep(200);
      }
      reports.push_back(series.report());
    }
    EXPECT_EQ(reports.size(), series.started());
    return reports;
  }
};

INSTANTIATE_TEST_SUITE_P(, Series, ::testing::Bool(), [](const auto& parameter) {
  return parameter.param ? "WithNamespaces" : "WithoutNamespaces";
});

Task says(const std::string& text) {
  return {[text] { return text; }};
}

[[noreturn]] void wait_to_be_stopped() {
  while (true) pause();
}

TEST_P(Series, GoesOnHoweverAChildEnds) {
  ProcessLimits limits = kGenerous;
  limits.wall_s = 10;  // waited out by one; the others must not meet it on a slow machine
  const auto reports = run({says("first"),
                            {[]() -> std::string { std::abort(); }},
                            {[]() -> std::string { throw std::runtime_error("lost"); }},
                            {[]() -> std::string { std::_Exit(3); }},
                            {[]() -> std::string { wait_to_be_stopped(); }},
                            {[]() -> std::string {
                              kill(getpid(), SIGKILL);
                              return "";
                            }},
                            says("last")},
                           limits);
  ASSERT_EQ(reports.size(), 7U);
  EXPECT_EQ(reports[0].output, "first");
  EXPECT_EQ(reports[1].code, SIGABRT);
  EXPECT_EQ(reports[2].message, "lost");
  EXPECT_EQ(reports[3].end, End::exited);
  EXPECT_EQ(reports[4].end, End::wall_limit);
  EXPECT_EQ(reports[5].end, End::killed);
  EXPECT_EQ(reports[6].end, End::finished);
  EXPECT_EQ(reports[6].output, "last");
}

TEST_P(Series, PreparesInItsParentWhatAllLaterChildrenShare) {
  int prepared = 0;
  int worked = 0;
  const Task task{[&] {
                    ++worked;
                    return std::to_string(prepared) + " " + std::to_string(worked);
                  },
                  [&] { ++prepared; }};
  const auto reports = run({task, task, {task.work, [] { throw std::runtime_error("no"); }}});
  ASSERT_EQ(reports.size(), 3U);
  EXPECT_EQ(reports[0].output, "1 1");
  EXPECT_EQ(reports[1].output, "2 1") << "work happens in the child alone";
  EXPECT_EQ(reports[2].output, "2 1") << "what cannot be prepared is the work's to report";
  EXPECT_EQ(prepared, 0) << "and nothing in the caller";
}

TEST_P(Series, LeavesNobodyOfOneChildToTheNext) {
  const Task leaves_orphan{[]() -> std::string {
    if (fork() == 0) {
      setsid();
      if (fork() == 0) wait_to_be_stopped();
      _exit(0);
    }
    return "";
  }};
  std::string orphan;
  const Task writes_its_number{[]() -> std::string {
    int pipes[2];
    static_cast<void>(!pipe(pipes));
    if (fork() == 0) {
      setsid();
      char number[32] = {};
      static_cast<void>(!readlink("/proc/self", number, sizeof number - 1));
      static_cast<void>(!write(pipes[1], number, sizeof number));
      wait_to_be_stopped();
    }
    char number[32] = {};
    static_cast<void>(!read(pipes[0], number, sizeof number));
    return number;
  }};
  ChildSeries series({leaves_orphan, writes_its_number, says("next")}, kGenerous, setup());
  for (int i = 0; i < 2; ++i) {
    ASSERT_TRUE(series.start_next());
    while (!series.has_ended()) usleep(200);
    orphan = series.report().output;
  }
  ASSERT_FALSE(orphan.empty());
  EXPECT_NE(access(("/proc/" + orphan).c_str(), F_OK), 0) << "before the next is started";
  EXPECT_TRUE(series.start_next());
}

TEST_P(Series, GivesEachChildItsPipeAsIfItWereTheFirst) {
  const auto reports = run({{[]() -> std::string {
                              for (int fd = 0; fd < 1000; ++fd) fcntl(fd, F_SETFL, O_NONBLOCK);
                              std::fputs("p: a.h:1: f(): Assertion `early' failed.\n", stderr);
                              std::_Exit(1);
                            }},
                            {[] { return std::string(2'000'000, 'x'); }},
                            {[]() -> std::string { std::abort(); }}});
  ASSERT_EQ(reports.size(), 3U);
  EXPECT_EQ(reports[1].output.size(), 2'000'000U);
  EXPECT_EQ(reports[2].message, "") << "what an earlier one said is not this one's";
}

TEST_P(Series, CountsOfMemoryWhatTheChildAddsAndNotWhatItInherits) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "a sanitizer's own memory counts, too";
#endif
  const std::string callers(60U << 20U, 'x');
  const auto reports = run({{[&] { return std::string(1, callers.back()); }}, {[&] {
                              std::vector<char> own(30U << 20U, 'y');
                              return std::string(1, own[own.size() / 2]);
                            }}});
  ASSERT_EQ(reports.size(), 2U);
  EXPECT_LT(reports[0].memory_max_mb, 20);
  EXPECT_GT(reports[1].memory_max_mb, 28);
  EXPECT_LT(reports[1].memory_max_mb, 60);
}

TEST_P(Series, EndsWithAChildThatLeavesSharedMemoryBehind) {
  const Task leaves_segment{[]() -> std::string {
    const int id = shmget(IPC_PRIVATE, 4096, IPC_CREAT | 0600);
    return std::to_string(id);
  }};
  const auto reports = run({leaves_segment, says("next")});
  shmid_ds found{};
  const int id = std::atoi(reports[0].output.c_str());
  const bool outside = shmctl(id, IPC_STAT, &found) == 0;
  if (outside) {  // no IPC namespace: it is as any other's
    shmctl(id, IPC_RMID, nullptr);
    EXPECT_EQ(reports.size(), 2U);
  } else {
    EXPECT_EQ(reports.size(), 1U) << "the next would find it";
  }
}

TEST(ProcessPool, HearsASignalThatCameBeforeItRan) {
  StopSignals stop;
  kill(getpid(), SIGUSR1);
  ProcessPool pool(stop, 1, kGenerous, {.namespaces = false}, nullptr);
  EXPECT_EQ(pool.run([]() -> std::vector<ProcessPool::Job> {
    ADD_FAILURE();
    return {};
  }),
            ProcessPool::End::stopped);
}

TEST(ProcessPool, DoesAllJobsThoughSeriesBreakAndTellsWhenEachStarts) {
  constexpr std::size_t kJobs = 30;
  std::vector<int> started(kJobs, 0);
  std::vector<std::string> results(kJobs);
  std::size_t next = 0;
  StopSignals stop;
  ProcessPool pool(stop, 2, kGenerous, {.namespaces = false}, nullptr);
  const auto end = pool.run([&] {
    std::vector<ProcessPool::Job> share;
    for (; share.size() < 7 && next < kJobs; ++next) {
      const std::size_t i = next;
      share.push_back({[i] {
                         if (i % 3 == 0) kill(getppid(), SIGKILL);
                         return "job " + std::to_string(i);
                       },
                       nullptr, [&, i] { ++started[i]; },
                       [&, i](const ChildReport& report) {
                         EXPECT_GT(started[i], 0);
                         results[i] = report.end == End::finished ? report.output : "killed";
                       }});
    }
    return share;
  });
  EXPECT_EQ(end, ProcessPool::End::all_done);
  for (std::size_t i = 0; i < kJobs; ++i)
    EXPECT_TRUE(results[i] == "job " + std::to_string(i) || (i % 3 == 0 && results[i] == "killed"))
        << i << ": " << results[i];
}

}  // namespace
}  // namespace voronaut
