#include <algorithm>
#include <array>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <dirent.h>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "voronaut/benchmarks/isolation/child_process.h"
#include "voronaut/benchmarks/isolation/namespaces.h"
#include "voronaut/tests/support/temporary_folder.h"

// What docs/isolation.md promises, each with work that tries to break it. Nothing here depends on
// how fast the machine is: what should be stopped waits to be stopped.
namespace voronaut {
namespace {

namespace fs = std::filesystem;
using End = ChildReport::End;

constexpr ProcessLimits kLimits{.memory_mb = 64, .cpu_s = 600, .wall_s = 600};

[[noreturn]] void wait_to_be_stopped() {
  while (true) pause();
}

// As the world outside numbers it: /proc is the outer one.
std::string own_number() {
  std::array<char, 32> text{};
  return readlink("/proc/self", text.data(), text.size() - 1) > 0 ? text.data() : "";
}

bool is_there(const std::string& number) { return fs::exists("/proc/" + number); }

std::string text_of(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

// A whole line, however long it takes to come.
std::string wait_for_line(const fs::path& file) {
  while (true) {
    const std::string text = text_of(file);
    if (const auto end = text.find('\n'); end != std::string::npos) return text.substr(0, end);
    usleep(2000);
  }
}

void start_orphan(const fs::path& number_file) {
  if (fork() != 0) return;
  setsid();
  if (fork() != 0) _exit(0);
  setsid();
  std::ofstream(number_file) << own_number() << std::endl;
  wait_to_be_stopped();
}

// Which of the two the system allows, tried in a process of its own.
Namespaces allowed_here() {
  const pid_t child = fork();
  if (child == 0) {
    const Namespaces entered = enter_namespaces({fs::temp_directory_path()});
    _exit((entered.processes ? 1 : 0) + (entered.mounts ? 2 : 0));
  }
  int status = 0;
  waitpid(child, &status, 0);
  return {(WEXITSTATUS(status) & 1) != 0, (WEXITSTATUS(status) & 2) != 0};
}

class Isolation : public ::testing::TestWithParam<bool> {
 protected:
  ChildProcess::Setup setup() const { return {.namespaces = GetParam()}; }
  ChildReport run(const ChildProcess::Work& work, const ProcessLimits& limits = kLimits) const {
    return run_in_child(work, limits, setup());
  }
  const fs::path& folder() const { return folder_.path(); }

 private:
  TemporaryFolder folder_;
};

INSTANTIATE_TEST_SUITE_P(, Isolation, ::testing::Bool(), [](const auto& parameter) {
  return parameter.param ? "WithNamespaces" : "WithoutNamespaces";
});

std::string open_descriptors() {
  std::string list;
  DIR* stream = opendir("/proc/self/fd");
  while (const dirent* entry = readdir(stream)) {
    const int fd = std::atoi(entry->d_name);
    if (entry->d_name[0] != '.' && fd != dirfd(stream)) list += std::string(entry->d_name) + " ";
  }
  closedir(stream);
  return list;
}

TEST_P(Isolation, AChildInheritsStandardStreamsAndItsPipeAlone) {
  std::vector<int> opened;
  for (int i = 0; i < 20; ++i) opened.push_back(open("/dev/null", O_RDWR));
  const ChildReport report = run([] { return open_descriptors(); });
  for (const int fd : opened) close(fd);
  std::istringstream words(report.output);
  std::vector<int> numbers;
  for (int fd = 0; words >> fd;) numbers.push_back(fd);
  std::sort(numbers.begin(), numbers.end());
  ASSERT_EQ(numbers.size(), 4U) << report.output;
  EXPECT_EQ(numbers[2], 2);
  EXPECT_GT(numbers[3], 100) << "no number that a program believes to be its own";
}

TEST_P(Isolation, ADescriptorNumberThatBelongsToTheCallerIsNotReachable) {
  const fs::path file = folder() / "precious";
  const int fd = open(file.c_str(), O_RDWR | O_CREAT, 0644);
  const ChildReport report = run([&] {
    for (int number = 3; number < 64; ++number)
      if (write(number, "planner: solving\n", 17) >= 0) return std::string("written");
    return std::string("refused");
  });
  close(fd);
  EXPECT_EQ(report.output, "refused");
  EXPECT_EQ(text_of(file), "");
}

TEST_P(Isolation, JoiningTheCallersGroupEvadesNoWallLimit) {
  const pid_t group = getpgrp();
  const ChildReport report = run(
      [&]() -> std::string {
        setpgid(0, group);
        wait_to_be_stopped();
      },
      {.memory_mb = 64, .cpu_s = 600, .wall_s = 0.2});
  EXPECT_EQ(report.end, End::wall_limit);
}

void fill(int fd, std::size_t megabytes) {
  const std::string block(1U << 20U, 'x');
  for (std::size_t i = 0; i < megabytes; ++i)
    if (write(fd, block.data(), block.size()) < 0) return;
}

TEST_P(Isolation, MemoryFilesCount) {
  const ChildReport report = run([]() -> std::string {
    for (int i = 0; i < 4; ++i) fill(memfd_create("hoard", 0), 30);
    wait_to_be_stopped();
  });
  EXPECT_EQ(report.end, End::memory);
}

char* touched_pages(std::size_t megabytes, int flags) {
  auto* pages = static_cast<char*>(
      mmap(nullptr, megabytes << 20U, PROT_READ | PROT_WRITE, flags | MAP_ANONYMOUS, -1, 0));
  if (pages != MAP_FAILED) std::memset(pages, 1, megabytes << 20U);
  return pages;
}

TEST_P(Isolation, SharedPagesOfAllProcessesOfATrialCount) {
  const ChildReport report = run([]() -> std::string {
    for (int i = 0; i < 3; ++i) {
      if (fork() != 0) continue;
      touched_pages(40, MAP_SHARED);
      wait_to_be_stopped();
    }
    wait_to_be_stopped();
  });
  EXPECT_EQ(report.end, End::memory);
}

TEST_P(Isolation, MemoryOfItsOwnChildrenCounts) {
  const ChildReport report = run([]() -> std::string {
    for (int i = 0; i < 3; ++i) {
      if (fork() != 0) continue;
      touched_pages(40, MAP_PRIVATE);
      wait_to_be_stopped();
    }
    wait_to_be_stopped();
  });
  EXPECT_EQ(report.end, End::memory);
}

TEST_P(Isolation, WhatProcessesShareCountsOnce) {
  const std::string callers(40U << 20U, 'x');  // shared with the caller: not the trial's at all
  const ChildReport report = run([&] {
    touched_pages(30, MAP_PRIVATE);
    const int fd = memfd_create("both open and mapped", 0);
    fill(fd, 20);
    mmap(nullptr, 20U << 20U, PROT_READ, MAP_SHARED | MAP_POPULATE, fd, 0);
    for (int i = 0; i < 4; ++i)
      if (fork() == 0) wait_to_be_stopped();
    usleep(400'000);  // long enough to be looked at
    return std::string(1, callers.back());
  });
  EXPECT_EQ(report.end, End::finished) << end_in_words(report, kLimits);
}

TEST_P(Isolation, AnEndlessResultIsCutOff) {
  const ChildReport report = run([]() -> std::string {
    const std::string block(1U << 16U, 'x');
    std::istringstream words(open_descriptors());
    int pipe = -1;
    while (words >> pipe) {
    }
    while (true) static_cast<void>(!write(pipe, block.data(), block.size()));
  });
  EXPECT_EQ(report.end, End::output_limit);
  EXPECT_EQ(report.output, "");
  EXPECT_EQ(end_in_words(report, kLimits), "sent more than 64 MB as its result");
}

TEST_P(Isolation, AChildThatKillsItsParentKillsNobodyElse) {
  const ChildReport report = run([]() -> std::string {
    kill(getppid(), SIGKILL);
    return "alive";
  });
  if (GetParam() && allowed_here().processes) {
    EXPECT_EQ(report.output, "alive");
  } else if (report.end != End::finished) {  // it may be faster than its end
    EXPECT_EQ(report.end, End::killed);
    EXPECT_EQ(report.code, SIGKILL);
  }
}

TEST_P(Isolation, NoOrphanSurvives) {
  const fs::path number = folder() / "number";
  const ChildReport report = run([&] {
    start_orphan(number);
    return wait_for_line(number);
  });
  ASSERT_EQ(report.end, End::finished);
  EXPECT_FALSE(is_there(report.output));
}

TEST_P(Isolation, NoOrphanSurvivesAParentThatWasKilled) {
  const fs::path number = folder() / "number";
  run([&]() -> std::string {
    start_orphan(number);
    wait_for_line(number);
    kill(getppid(), SIGKILL);
    return "";
  });
  EXPECT_FALSE(is_there(wait_for_line(number)));
}

TEST_P(Isolation, NobodySurvivesADroppedChild) {
  const fs::path number = folder() / "number";
  {
    const ChildProcess dropped(
        [&]() -> std::string {
          start_orphan(number);
          wait_to_be_stopped();
        },
        kLimits, setup());
    wait_for_line(number);
  }
  EXPECT_FALSE(is_there(wait_for_line(number)));
}

TEST_P(Isolation, NobodySurvivesTheCaller) {
  const fs::path number = folder() / "number";
  const pid_t caller = fork();
  if (caller == 0) {
    run([&]() -> std::string {
      start_orphan(number);
      wait_to_be_stopped();
    });
    _exit(0);
  }
  const std::string orphan = wait_for_line(number);
  EXPECT_TRUE(is_there(orphan));
  kill(caller, SIGKILL);
  waitpid(caller, nullptr, 0);
  while (is_there(orphan)) usleep(1000);
}

TEST_P(Isolation, KnowsAChildThatSomebodyElseKilled) {
  const fs::path number = folder() / "number";
  ChildProcess child(
      [&]() -> std::string {
        std::ofstream(number) << own_number() << std::endl;
        wait_to_be_stopped();
      },
      kLimits, setup());
  kill(std::stoi(wait_for_line(number)), SIGKILL);
  while (!child.has_ended()) usleep(1000);
  EXPECT_EQ(child.report().end, End::killed);
  EXPECT_EQ(end_in_words(child.report(), kLimits), "ended by SIGKILL");
}

// All that a process is, as far as a runner could change it.
std::string state_of_process() {
  std::ostringstream text;
  int subreaper = -1;
  int death_signal = -1;
  prctl(PR_GET_CHILD_SUBREAPER, &subreaper);
  prctl(PR_GET_PDEATHSIG, &death_signal);
  text << subreaper << " " << death_signal << " " << getpgrp() << " " << getsid(0) << " "
       << fs::current_path() << " " << open_descriptors();
  sigset_t blocked;
  sigprocmask(SIG_BLOCK, nullptr, &blocked);
  for (int signal = 1; signal < 32; ++signal) {
    struct sigaction action {};
    sigaction(signal, nullptr, &action);
    text << sigismember(&blocked, signal) << (action.sa_handler == SIG_DFL) << " ";
  }
  for (const auto resource : {RLIMIT_AS, RLIMIT_CPU, RLIMIT_CORE, RLIMIT_NOFILE, RLIMIT_FSIZE}) {
    rlimit limit{};
    getrlimit(resource, &limit);
    text << limit.rlim_cur << "/" << limit.rlim_max << " ";
  }
  for (const char* kind : {"pid", "mnt", "user", "ipc"})
    text << fs::read_symlink("/proc/self/ns/" + std::string(kind)) << " ";
  text << "children: " << waitpid(-1, nullptr, WNOHANG);
  return text.str();
}

TEST_P(Isolation, LeavesTheCallersProcessAsItWas) {
  const std::string before = state_of_process();
  run([] { return std::string(); });
  run([]() -> std::string { std::abort(); });
  run([]() -> std::string { wait_to_be_stopped(); },
      {.memory_mb = 64, .cpu_s = 600, .wall_s = 0.05});
  EXPECT_EQ(state_of_process(), before);
}

// The five ways in which a planner loses a database that it knows the path of.
TEST(ReadOnlyFolder, KeepsFilesFromBeingChangedByTheirPath) {
  if (!allowed_here().mounts) GTEST_SKIP() << "this system allows no mounts of one's own";
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "results.db";
  std::ofstream(file) << "rows";
  const fs::path here = fs::current_path();
  fs::current_path(folder.path());
  const ChildReport report = run_in_child(
      [&] {
        std::string refused;
        const auto note = [&](bool failed) { refused += failed ? "1" : "0"; };
        note(unlink(file.c_str()) != 0);
        note(truncate(file.c_str(), 0) != 0);
        note(open(file.c_str(), O_RDWR) < 0);
        note(rename(file.c_str(), "/tmp/elsewhere") != 0);
        note(unlink("results.db") != 0);
        note(open("new", O_CREAT | O_RDWR, 0644) < 0);
        return refused + " " + text_of(file);
      },
      kLimits, {.read_only = {folder.path()}});
  fs::current_path(here);
  EXPECT_EQ(report.output, "111111 rows");
  EXPECT_EQ(text_of(file), "rows");
}

}  // namespace
}  // namespace voronaut
