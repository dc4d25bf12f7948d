#include "voronaut/benchmarks/isolation/child_process.h"

#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

namespace voronaut {
namespace {

using End = ChildReport::End;

// Generous where a limit is not what a test is about: how fast the machine is shall not matter.
ProcessLimits tight() { return {.memory_mb = 256, .cpu_s = 600, .wall_s = 600}; }

TEST(ChildProcess, ReturnsWhatTheWorkReturnedHoweverLong) {
  const std::string long_text(3'000'000, 'x');
  const ChildReport report = run_in_child([&] { return long_text; }, tight());
  EXPECT_EQ(report.end, End::finished);
  EXPECT_EQ(report.output, long_text);
  EXPECT_GT(report.memory_max_mb, 1);
}

TEST(ChildProcess, PassesOnWhatAnExceptionSays) {
  const ChildReport report = run_in_child(
      []() -> std::string { throw std::runtime_error("no roadmap\nat all"); }, tight());
  EXPECT_EQ(report.end, End::exception);
  EXPECT_EQ(report.message, "no roadmap");
}

TEST(ChildProcess, KnowsAnExceptionThatIsNoStandardOne) {
  const ChildReport report = run_in_child([]() -> std::string { throw 7; }, tight());
  EXPECT_EQ(report.end, End::exception);
  EXPECT_EQ(report.message, "an exception that is no std::exception");
}

TEST(ChildProcess, PassesOnAnExceptionThatNobodyCouldCatch) {
  const ChildReport report = run_in_child(
      []() -> std::string {
        std::thread([] { throw std::logic_error("from a thread"); }).join();
        return "";
      },
      tight());
  EXPECT_EQ(report.end, End::signalled);
  EXPECT_EQ(report.code, SIGABRT);
  EXPECT_EQ(report.message, "from a thread");
}

TEST(ChildProcess, NamesTheSignal) {
  const ChildReport report = run_in_child(
      []() -> std::string {
        std::signal(SIGSEGV, SIG_DFL);
        std::raise(SIGSEGV);
        return "";
      },
      tight());
  EXPECT_EQ(report.end, End::signalled);
  EXPECT_EQ(report.code, SIGSEGV);
  EXPECT_EQ(report.message, "");
}

TEST(ChildProcess, QuotesAFailedAssertionAndNothingElseOfStandardError) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "standard error is where a sanitizer reports: it stays visible";
#endif
  const ChildReport report = run_in_child(
      []() -> std::string {
        std::fputs("at 0x55f0\nprogram: a.h:12: void f(): Assertion `x > 0' failed.\n", stderr);
        std::abort();
      },
      tight());
  EXPECT_EQ(report.end, End::signalled);
  EXPECT_EQ(report.code, SIGABRT);
  EXPECT_EQ(report.message, "a.h:12: void f(): Assertion `x > 0' failed.");
}

TEST(ChildProcess, KnowsAProcessThatLeftByItself) {
  const ChildReport zero = run_in_child([]() -> std::string { std::_Exit(0); }, tight());
  EXPECT_EQ(zero.end, End::exited);
  EXPECT_EQ(zero.code, 0);
  const ChildReport seven = run_in_child([]() -> std::string { std::exit(7); }, tight());
  EXPECT_EQ(seven.end, End::exited);
  EXPECT_EQ(seven.code, 7);
}

// A part of each block is touched: a sanitized build counts that alone.
std::string eat_memory() {
  std::vector<char*> hoard;
  while (true) {
    hoard.push_back(new char[1U << 24U]);
    std::memset(hoard.back(), 'x', 1U << 20U);
  }
}

TEST(ChildProcess, RefusesMemoryPastTheLimit) {
  EXPECT_EQ(run_in_child(eat_memory, tight()).end, End::memory);
}

TEST(ChildProcess, KnowsThatMemoryRanOutWhereItCannotBeThrown) {
  const auto work = []() -> std::string { return [&]() noexcept { return eat_memory(); }(); };
  EXPECT_EQ(run_in_child(work, tight()).end, End::memory);
}

TEST(ChildProcess, ForgivesARefusedAllocationThatTheWorkGotOver) {
  const auto work = []() -> std::string {
    try {
      eat_memory();
    } catch (const std::bad_alloc&) {
      return "recovered";
    }
    return "";
  };
  const ChildReport report = run_in_child(work, tight());
  EXPECT_EQ(report.end, End::finished);
  EXPECT_EQ(report.output, "recovered");
}

TEST(ChildProcess, StopsWhatComputesForever) {
  const auto work = []() -> std::string {
    for (volatile std::uint64_t i = 0;;) i = i + 1;
  };
  ProcessLimits limits = tight();
  limits.cpu_s = 1;
  const ChildReport report = run_in_child(work, limits);
  EXPECT_EQ(report.end, End::cpu_limit);
  EXPECT_GT(report.cpu_time_s, 0.9);
}

TEST(ChildProcess, StopsWhatWaitsForeverEvenIfItIgnoresTheRequest) {
  const auto work = []() -> std::string {
    std::signal(SIGTERM, SIG_IGN);
    while (true) pause();
  };
  ProcessLimits limits = tight();
  limits.wall_s = 0.1;
  EXPECT_EQ(run_in_child(work, limits).end, End::wall_limit);
}

TEST(ChildProcess, LeavesNoProcessAndNoDescriptorBehind) {
  const auto next_fd = [] {
    const int fd = dup(STDERR_FILENO);
    close(fd);
    return fd;
  };
  const int before = next_fd();
  for (int i = 0; i < 20; ++i) run_in_child([] { return std::string("x"); }, tight());
  {
    const ChildProcess dropped(
        []() -> std::string {
          while (true) pause();
        },
        tight(), {});
  }
  EXPECT_EQ(next_fd(), before);
}

}  // namespace
}  // namespace voronaut
