#include "voronaut/benchmarks/isolation/supervisor.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <optional>
#include <vector>

#include <poll.h>
#include <sys/prctl.h>
#include <sys/signalfd.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include "voronaut/benchmarks/isolation/descriptors.h"
#include "voronaut/benchmarks/isolation/guard.h"
#include "voronaut/benchmarks/isolation/namespaces.h"
#include "voronaut/benchmarks/isolation/process_tree.h"

namespace voronaut {

namespace {

using Clock = ChildSeries::Clock;

constexpr auto kMemoryPeriod = std::chrono::milliseconds(20);
constexpr auto kLastReportWait = std::chrono::seconds(1);

void block_signals() {
  sigset_t all;
  sigfillset(&all);
  sigprocmask(SIG_SETMASK, &all, nullptr);
}

class Watch {
 public:
  Watch(const Supervised& supervised, pid_t guard, int guard_fd)
      : limits_(supervised.limits),
        tasks_(supervised.tasks.size()),
        caller_fd_(supervised.caller_fd),
        guard_(guard),
        guard_fd_(guard_fd) {
    sigset_t asked;
    sigemptyset(&asked);
    sigaddset(&asked, SIGTERM);
    signal_fd_ = signalfd(-1, &asked, SFD_CLOEXEC | SFD_NONBLOCK);
  }

  // Child after child, as the caller asks for them.
  void run() {
    for (std::size_t begun = 1; caller_asks(); ++begun) {
      Verdict verdict = watch_child();
      verdict.last = begun == tasks_ || !can_go_on(verdict);
      if (verdict.last) leave_nobody();
      if (write(caller_fd_, &verdict, sizeof verdict) != sizeof verdict) break;
      if (verdict.last) return;
    }
    leave_nobody();
  }

 private:
  bool caller_asks() {
    std::array<pollfd, 2> fds{pollfd{caller_fd_, POLLIN, 0}, pollfd{signal_fd_, POLLIN, 0}};
    while (poll(fds.data(), fds.size(), -1) < 0 && errno == EINTR) {
    }
    char go = 0;
    return fds[1].revents == 0 && read(caller_fd_, &go, 1) == 1;
  }

  bool can_go_on(const Verdict& verdict) const {
    const bool unharmed = verdict.cause != Verdict::Cause::stopped &&
                          verdict.cause != Verdict::Cause::guard_ended && verdict.error == 0;
    return unharmed && guard_answers_ && !end_.spoilt;
  }

  Verdict watch_child() {
    Verdict verdict;
    end_ = {};
    memory_.reset();
    const char go = 0;
    const bool begun = send(guard_fd_, &go, 1, MSG_NOSIGNAL) == 1;
    verdict.cause = begun ? wait_for_end(deadline_from_now()) : Verdict::Cause::guard_ended;
    if (verdict.cause != Verdict::Cause::ended) stop_child();
    if (end_.error != 0) verdict.cause = Verdict::Cause::not_started;
    verdict.error = end_.error;
    verdict.wait_status = end_.wait_status;
    verdict.cpu_time_s = end_.cpu_time_s;
    verdict.memory_max_mb = end_.memory_max_mb;
    return verdict;
  }

  Clock::time_point deadline_from_now() const {
    return Clock::now() + std::chrono::duration_cast<Clock::duration>(
                              std::chrono::duration<double>(limits_.wall_s));
  }

  Verdict::Cause wait_for_end(Clock::time_point deadline) {
    while (true) {
      const auto wake = std::min(deadline, Clock::now() + kMemoryPeriod);
      std::array<pollfd, 2> fds{pollfd{guard_fd_, POLLIN, 0}, pollfd{signal_fd_, POLLIN, 0}};
      poll(fds.data(), fds.size(), milliseconds_until(wake));
      if (fds[0].revents != 0)
        return read_end() ? Verdict::Cause::ended : Verdict::Cause::guard_ended;
      if (fds[1].revents != 0) return Verdict::Cause::stopped;
      if (Clock::now() >= deadline) return Verdict::Cause::wall_limit;
      if (memory_in_use_mb() > limits_.memory_mb) return Verdict::Cause::memory;
    }
  }

  // Children that are faster than the first look cost no look at the guard either.
  double memory_in_use_mb() {
    if (!memory_) memory_.emplace(guard_);
    return memory_->in_use_mb(trial(), limits_.memory_mb);
  }

  static int milliseconds_until(Clock::time_point time) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(time - Clock::now());
    return static_cast<int>(std::max<std::int64_t>(left.count(), 0));
  }

  bool read_end() { return read(guard_fd_, &end_, sizeof end_) == sizeof end_; }

  std::vector<pid_t> trial() const {
    std::vector<pid_t> pids = descendants_of(getpid());
    std::erase(pids, guard_);
    return pids;
  }

  // The guard stays: it knows what the child has used, and forks the next one.
  void stop_child() {
    const auto patience = Clock::now() + kLastReportWait;
    kill(guard_, SIGCONT);
    while (Clock::now() < patience) {
      kill_descendants(getpid(), guard_);
      pollfd report{guard_fd_, POLLIN, 0};
      if (poll(&report, 1, 1) > 0) {
        guard_answers_ = read_end();
        return;
      }
    }
    guard_answers_ = false;
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
  std::size_t tasks_;
  int caller_fd_;
  pid_t guard_;
  int guard_fd_;
  int signal_fd_ = -1;
  bool guard_answers_ = true;
  std::optional<TreeMemory> memory_;
  ChildEnd end_;
};

// Answers whatever the caller asks first: there is no process for it.
void refuse(int caller_fd, int error) {
  Verdict verdict;
  verdict.error = error;
  char go = 0;
  if (read(caller_fd, &go, 1) == 1) static_cast<void>(!write(caller_fd, &verdict, sizeof verdict));
}

void run_guarded(Supervised& supervised, bool own_namespaces) {
  std::array<int, 2> link{-1, -1};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, link.data()) != 0)
    return refuse(supervised.caller_fd, errno);
  const pid_t guard_pid = fork();
  if (guard_pid == 0) {
    close(link[0]);
    close(supervised.caller_fd);
    guard({supervised, link[1], own_namespaces});
  }
  if (guard_pid < 0) return refuse(supervised.caller_fd, errno);
  close_all_but({link[0], supervised.caller_fd});
  Watch(supervised, guard_pid, link[0]).run();
}

}  // namespace

void supervise(Supervised supervised) {
  block_signals();
  setsid();
  prctl(PR_SET_NAME, "voronaut-trial");
  close_all_but({supervised.caller_fd, supervised.child.output_fd, supervised.child.error_fd});
  Namespaces entered;
  if (supervised.setup.namespaces) entered = enter_namespaces(supervised.setup.read_only);
  prctl(PR_SET_CHILD_SUBREAPER, 1);
  prctl(PR_SET_PDEATHSIG, SIGTERM);  // after the namespaces, which forget it
  if (getppid() != supervised.caller) _exit(1);
  run_guarded(supervised, entered.processes);
  _exit(0);
}

}  // namespace voronaut
