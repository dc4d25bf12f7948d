#include "voronaut/benchmarks/isolation/process_pool.h"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

#include <poll.h>
#include <sched.h>

namespace voronaut {

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

ProcessPool::ProcessPool(StopSignals& stop, std::size_t jobs, const ProcessLimits& limits,
                         ChildSeries::Setup setup, std::function<void()> tick)
    : stop_(stop),
      jobs_(std::max<std::size_t>(jobs, 1)),
      limits_(limits),
      setup_(std::move(setup)),
      tick_(std::move(tick)) {}

ProcessPool::~ProcessPool() = default;

// Takes care of every child once; those that have ended are handed over, and the next ones of their
// series started. After a signal nothing is handed over: who sends it to all processes of a job has
// ended them too.
void ProcessPool::attend() {
  for (auto lane = lanes_.begin(); lane != lanes_.end();) {
    ChildSeries& series = lane->series();
    series.read_output();
    if (!series.has_ended()) {
      series.enforce_wall_limit(ChildSeries::Clock::now());
      ++lane;
      continue;
    }
    if (stop_.received()) return;
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

void ProcessPool::fill_lanes(const std::function<std::vector<Job>()>& next) {
  while (lanes_.size() < jobs_ && !stop_.received()) {
    std::vector<Job> jobs = next_jobs(next);
    if (jobs.empty()) return;
    lanes_.emplace_back(std::move(jobs), limits_, setup_);
    if (lanes_.back().start_next()) continue;
    left_over_ = lanes_.back().take_rest();  // somebody was faster than its first child
    lanes_.pop_back();
  }
}

void ProcessPool::wait_for_events() {
  std::vector<pollfd> fds{{stop_.fd(), POLLIN, 0}};
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
  more_ = true;
  while (true) {
    fill_lanes(next);
    if (stop_.received()) {
      lanes_.clear();
      return stop_.interrupted() ? End::interrupted : End::stopped;
    }
    if (lanes_.empty()) return End::all_done;
    wait_for_events();
    attend();
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
