#include "voronaut/benchmarks/isolation/process_pool.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <iterator>
#include <system_error>
#include <utility>
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

}  // namespace

// Jobs that came together, and the series of children that does them.
class ProcessPool::Lane {
 public:
  Lane(std::vector<Job> jobs, const ProcessLimits& limits, const ChildSeries::Setup& setup)
      : jobs_(std::move(jobs)), series_(tasks_of(jobs_), limits, setup) {}

  ChildSeries& series() { return series_; }

  // Of the job that goes on with it, which has begun; false if the series cannot go on.
  bool start_next() {
    if (at_ == jobs_.size()) return false;
    if (jobs_[at_].starts) jobs_[at_].starts();
    return series_.start_next();
  }

  void hand_over() {
    const Job ended = std::move(jobs_[at_++]);
    ended.done(series_.report());
  }

  std::vector<Job> take_rest() {
    return {std::make_move_iterator(jobs_.begin() + static_cast<std::ptrdiff_t>(at_)),
            std::make_move_iterator(jobs_.end())};
  }

 private:
  static std::vector<ChildSeries::Task> tasks_of(const std::vector<Job>& jobs) {
    std::vector<ChildSeries::Task> tasks;
    tasks.reserve(jobs.size());
    for (const Job& job : jobs) tasks.push_back({job.work, job.prepare});
    return tasks;
  }

  std::vector<Job> jobs_;
  std::size_t at_ = 0;
  ChildSeries series_;
};

ProcessPool::ProcessPool(std::size_t jobs, const ProcessLimits& limits, ChildSeries::Setup setup,
                         std::function<void()> tick)
    : jobs_(std::max<std::size_t>(jobs, 1)),
      limits_(limits),
      setup_(std::move(setup)),
      tick_(std::move(tick)) {}

ProcessPool::~ProcessPool() = default;

// Takes care of every child once; those that have ended are handed over, and the next ones of their
// series started. After a signal nothing is handed over: who sends it to all processes of a job has
// ended them too.
void ProcessPool::attend(const std::function<bool()>& stopped) {
  for (auto lane = lanes_.begin(); lane != lanes_.end();) {
    ChildSeries& series = lane->series();
    series.read_output();
    if (!series.has_ended()) {
      series.enforce_wall_limit(ChildSeries::Clock::now());
      ++lane;
      continue;
    }
    if (stopped()) return;
    lane->hand_over();
    if (lane->start_next()) {
      ++lane;
      continue;
    }
    auto rest = lane->take_rest();
    left_over_.insert(left_over_.end(), std::make_move_iterator(rest.begin()),
                      std::make_move_iterator(rest.end()));
    lane = lanes_.erase(lane);
  }
}

std::vector<ProcessPool::Job> ProcessPool::next_jobs(
    const std::function<std::vector<Job>()>& next) {
  if (!left_over_.empty()) return std::exchange(left_over_, {});
  if (!more_) return {};
  std::vector<Job> jobs = next();
  more_ = !jobs.empty();
  return jobs;
}

void ProcessPool::fill_lanes(const std::function<std::vector<Job>()>& next,
                             const std::function<bool()>& stopped) {
  while (lanes_.size() < jobs_ && !stopped()) {
    std::vector<Job> jobs = next_jobs(next);
    if (jobs.empty()) return;
    lanes_.emplace_back(std::move(jobs), limits_, setup_);
    if (lanes_.back().start_next()) continue;
    left_over_ = lanes_.back().take_rest();  // somebody was faster than its first child
    lanes_.pop_back();
  }
}

void ProcessPool::wait_for_events(int signal_fd) {
  std::vector<pollfd> fds{{signal_fd, POLLIN, 0}};
  auto wake = ChildSeries::Clock::now() + std::chrono::milliseconds(200);
  for (Lane& lane : lanes_) {
    fds.push_back({lane.series().output_fd(), POLLIN, 0});
    fds.push_back({lane.series().verdict_fd(), POLLIN, 0});
    wake = std::min(wake, lane.series().deadline());
  }
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(wake - ChildSeries::Clock::now());
  poll(fds.data(), fds.size(), static_cast<int>(std::max<std::int64_t>(left.count(), 0)));
}

ProcessPool::End ProcessPool::run(const std::function<std::vector<Job>()>& next) {
  StopSignals stop;
  const auto stopped = [&stop] { return stop.received(); };
  more_ = true;
  while (true) {
    fill_lanes(next, stopped);
    if (stopped()) {
      lanes_.clear();
      return stop.end();
    }
    if (lanes_.empty()) return End::all_done;
    wait_for_events(stop.fd());
    attend(stopped);
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
