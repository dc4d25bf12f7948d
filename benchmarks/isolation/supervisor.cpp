#include "voronaut/benchmarks/isolation/supervisor.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <vector>

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/signalfd.h>
#include <sys/wait.h>
#include <unistd.h>

#include "voronaut/benchmarks/isolation/descriptors.h"
#include "voronaut/benchmarks/isolation/namespaces.h"
#include "voronaut/benchmarks/isolation/process_tree.h"

namespace voronaut {

namespace {

using Clock = ChildProcess::Clock;

constexpr auto kMemoryPeriod = std::chrono::milliseconds(20);
constexpr auto kLastReportWait = std::chrono::seconds(1);

// What the guard tells the supervisor.
struct ChildEnd {
  int error = 0;  // of fork
  int wait_status = 0;
  double cpu_time_s = 0;
  double memory_max_mb = 0;
};

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

void block_signals() {
  sigset_t all;
  sigfillset(&all);
  sigprocmask(SIG_SETMASK, &all, nullptr);
}

bool nobody_reads(int fd) {
  pollfd asked{fd, 0, 0};
  return poll(&asked, 1, 0) > 0 && (asked.revents & POLLERR) != 0;
}

[[noreturn]] void guard(Supervised& supervised, int report_fd) {
  setsid();
  prctl(PR_SET_NAME, "voronaut-guard");
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (nobody_reads(report_fd)) _exit(1);  // the supervisor died before that held
  ChildEnd end;
  supervised.child.parent = getpid();
  const pid_t child = fork();
  if (child == 0) run_child_side(supervised.work, supervised.limits, supervised.child);
  if (child < 0) end.error = errno;
  close_all_but({report_fd});
  for (pid_t ended = 0; child > 0 && ended != child;) {
    rusage usage{};
    ended = wait4(-1, &end.wait_status, 0, &usage);
    if (ended < 0 && errno != EINTR) _exit(1);
    end.cpu_time_s = seconds(usage.ru_utime) + seconds(usage.ru_stime);
    end.memory_max_mb = static_cast<double>(usage.ru_maxrss) / 1024;
  }
  _exit(write(report_fd, &end, sizeof end) == sizeof end ? 0 : 1);
}

class Watch {
 public:
  Watch(const ProcessLimits& limits, pid_t guard, int report_fd)
      : limits_(limits), guard_(guard), report_fd_(report_fd), memory_(guard) {
    sigset_t asked;
    sigemptyset(&asked);
    sigaddset(&asked, SIGTERM);
    signal_fd_ = signalfd(-1, &asked, SFD_CLOEXEC | SFD_NONBLOCK);
  }

  Verdict run(Clock::time_point deadline) {
    Verdict verdict;
    verdict.cause = wait_for_end(deadline);
    if (verdict.cause != Verdict::Cause::ended) stop_child();
    if (end_.error != 0) verdict.cause = Verdict::Cause::not_started;
    verdict.error = end_.error;
    verdict.wait_status = end_.wait_status;
    verdict.cpu_time_s = end_.cpu_time_s;
    verdict.memory_max_mb = end_.memory_max_mb;
    leave_nobody();
    return verdict;
  }

 private:
  Verdict::Cause wait_for_end(Clock::time_point deadline) {
    while (true) {
      const auto wake = std::min(deadline, Clock::now() + kMemoryPeriod);
      std::array<pollfd, 2> fds{pollfd{report_fd_, POLLIN, 0}, pollfd{signal_fd_, POLLIN, 0}};
      poll(fds.data(), fds.size(), milliseconds_until(wake));
      if (fds[0].revents != 0)
        return read_end() ? Verdict::Cause::ended : Verdict::Cause::guard_ended;
      if (fds[1].revents != 0) return Verdict::Cause::stopped;
      if (Clock::now() >= deadline) return Verdict::Cause::wall_limit;
      if (memory_.in_use_mb(trial(), limits_.memory_mb) > limits_.memory_mb)
        return Verdict::Cause::memory;
    }
  }

  static int milliseconds_until(Clock::time_point time) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(time - Clock::now());
    return static_cast<int>(std::max<std::int64_t>(left.count(), 0));
  }

  bool read_end() { return read(report_fd_, &end_, sizeof end_) == sizeof end_; }

  std::vector<pid_t> trial() const {
    std::vector<pid_t> pids = descendants_of(getpid());
    std::erase(pids, guard_);
    return pids;
  }

  // The guard stays for a moment: it knows what the child has used.
  void stop_child() {
    const auto patience = Clock::now() + kLastReportWait;
    kill(guard_, SIGCONT);
    while (Clock::now() < patience) {
      kill_descendants(getpid(), guard_);
      pollfd report{report_fd_, POLLIN, 0};
      if (poll(&report, 1, 1) > 0) {
        read_end();
        return;
      }
    }
  }

  // What is orphaned becomes a child of this process: nobody is left when it has none.
  static void leave_nobody() {
    while (true) {
      kill_descendants(getpid(), 0);
      pid_t ended = 0;
      while ((ended = waitpid(-1, nullptr, WNOHANG)) > 0) {
      }
      if (ended < 0 && errno == ECHILD) return;
      usleep(500);
    }
  }

  ProcessLimits limits_;
  pid_t guard_;
  int report_fd_;
  int signal_fd_ = -1;
  TreeMemory memory_;
  ChildEnd end_;
};

Verdict run_guarded(Supervised& supervised, Clock::time_point deadline) {
  Verdict verdict;
  std::array<int, 2> report{-1, -1};
  if (pipe2(report.data(), O_CLOEXEC) != 0) {
    verdict.error = errno;
    return verdict;
  }
  const pid_t guard_pid = fork();
  if (guard_pid == 0) {
    close(report[0]);
    close(supervised.verdict_fd);
    guard(supervised, report[1]);
  }
  if (guard_pid < 0) {
    verdict.error = errno;
    return verdict;
  }
  close_all_but({report[0], supervised.verdict_fd});
  return Watch(supervised.limits, guard_pid, report[0]).run(deadline);
}

}  // namespace

void supervise(Supervised supervised) {
  const auto deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                           std::chrono::duration<double>(supervised.limits.wall_s));
  block_signals();
  setsid();
  prctl(PR_SET_NAME, "voronaut-trial");
  close_all_but({supervised.verdict_fd, supervised.child.output_fd, supervised.child.error_fd});
  if (supervised.setup.namespaces) enter_namespaces(supervised.setup.read_only);
  prctl(PR_SET_CHILD_SUBREAPER, 1);
  prctl(PR_SET_PDEATHSIG, SIGTERM);  // after the namespaces, which forget it
  if (getppid() != supervised.caller) _exit(1);
  const Verdict verdict = run_guarded(supervised, deadline);
  _exit(write(supervised.verdict_fd, &verdict, sizeof verdict) == sizeof verdict ? 0 : 1);
}

}  // namespace voronaut
