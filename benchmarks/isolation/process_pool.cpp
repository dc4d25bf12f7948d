#include "voronaut/benchmarks/isolation/process_pool.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <list>
#include <memory>
#include <system_error>
#include <vector>

#include <poll.h>
#include <sched.h>
#include <sys/signalfd.h>
#include <unistd.h>

namespace voronaut {

namespace {

// The signals that ask a run to end become readable instead of deadly, as long as this lives.
class StopSignals {
 public:
  StopSignals() {
    sigemptyset(&watched_);
    sigaddset(&watched_, SIGINT);
    sigaddset(&watched_, SIGTERM);
    sigaddset(&watched_, SIGUSR1);
    sigprocmask(SIG_BLOCK, &watched_, &before_);
    fd_ = signalfd(-1, &watched_, SFD_CLOEXEC | SFD_NONBLOCK);
    if (fd_ < 0) {
      const std::error_code why(errno, std::generic_category());
      sigprocmask(SIG_SETMASK, &before_, nullptr);
      throw std::system_error(why, "watching for signals");
    }
  }
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;
  ~StopSignals() {
    received();
    close(fd_);
    sigprocmask(SIG_SETMASK, &before_, nullptr);
  }

  int fd() const { return fd_; }

  bool received() {
    signalfd_siginfo info;
    while (read(fd_, &info, sizeof info) == static_cast<ssize_t>(sizeof info)) {
      received_ = true;
      interrupted_ = interrupted_ || info.ssi_signo == SIGINT;
    }
    return received_;
  }

  ProcessPool::End end() const {
    return interrupted_ ? ProcessPool::End::interrupted : ProcessPool::End::stopped;
  }

 private:
  sigset_t watched_{};
  sigset_t before_{};
  int fd_ = -1;
  bool received_ = false;
  bool interrupted_ = false;
};

struct Running {
  std::unique_ptr<ChildProcess> process;
  std::function<void(const ChildReport&)> done;
};

void wait_for_events(const std::list<Running>& children, int signal_fd) {
  std::vector<pollfd> fds{{signal_fd, POLLIN, 0}};
  auto wake = ChildProcess::Clock::now() + std::chrono::milliseconds(200);
  for (const Running& child : children) {
    fds.push_back({child.process->output_fd(), POLLIN, 0});
    fds.push_back({child.process->verdict_fd(), POLLIN, 0});
    wake = std::min(wake, child.process->deadline());
  }
  const auto wait = std::chrono::ceil<std::chrono::milliseconds>(wake - ChildProcess::Clock::now());
  poll(fds.data(), fds.size(), static_cast<int>(std::max<std::int64_t>(wait.count(), 0)));
}

// Takes care of every child once; those that have ended are handed over and forgotten. After a
// signal they are only forgotten: who sends it to all processes of a job has ended them too.
void attend(std::list<Running>& children, StopSignals& stop) {
  for (auto child = children.begin(); child != children.end();) {
    child->process->read_output();
    if (child->process->has_ended()) {
      const Running ended = std::move(*child);
      child = children.erase(child);
      if (!stop.received()) ended.done(ended.process->report());
    } else {
      child->process->enforce_wall_limit(ChildProcess::Clock::now());
      ++child;
    }
  }
}

}  // namespace

ProcessPool::ProcessPool(std::size_t jobs, const ProcessLimits& limits, ChildProcess::Setup setup,
                         std::function<void()> tick)
    : jobs_(std::max<std::size_t>(jobs, 1)),
      limits_(limits),
      setup_(std::move(setup)),
      tick_(std::move(tick)) {}

ProcessPool::End ProcessPool::run(const std::function<std::optional<Job>()>& next) {
  StopSignals stop;
  std::list<Running> children;
  bool more = true;
  while (true) {
    while (more && children.size() < jobs_ && !stop.received()) {
      auto job = next();
      more = job.has_value();
      if (more) {
        children.push_back(
            {std::make_unique<ChildProcess>(job->work, limits_, setup_), std::move(job->done)});
      }
    }
    if (stop.received()) return stop.end();
    if (children.empty()) return End::all_done;
    wait_for_events(children, stop.fd());
    attend(children, stop);
    if (tick_) tick_();
  }
}

std::size_t ProcessPool::default_jobs() {
  cpu_set_t set;
  CPU_ZERO(&set);
  if (sched_getaffinity(0, sizeof set, &set) != 0) return 1;
  return static_cast<std::size_t>(std::max(CPU_COUNT(&set) - 1, 1));
}

}  // namespace voronaut
