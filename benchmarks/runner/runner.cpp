#include "voronaut/benchmarks/runner/runner.h"

#include <algorithm>
#include <deque>
#include <memory>
#include <stdexcept>

#include "voronaut/benchmarks/episode/episode_trace.h"
#include "voronaut/benchmarks/episode/ground_truth_collision_checker.h"
#include "voronaut/benchmarks/isolation/flight_marks.h"
#include "voronaut/benchmarks/isolation/process_pool.h"
#include "voronaut/benchmarks/runner/isolated_world.h"
#include "voronaut/benchmarks/suite/suite_trials.h"
#include "voronaut/environments/config/config_node.h"
#include "voronaut/reports/store/packed_trial.h"
#include "voronaut/reports/trace/trace_json.h"

namespace voronaut {

namespace {

std::string fly_and_pack(const TrialSpec& spec, const FlyTrial& fly, TraceKeeping traces) {
  const TrialResult result = fly(spec, traces != TraceKeeping::none);
  PackedTrial packed{result.record, {}};
  const bool wanted =
      traces == TraceKeeping::all ||
      (traces == TraceKeeping::failures && result.record.outcome != Outcome::goal_reached);
  if (result.trace && wanted) packed.trace_blob = compress_trace(*result.trace);
  return pack(packed);
}

Outcome outcome_of(ChildReport::End end) {
  switch (end) {
    case ChildReport::End::memory:
      return Outcome::memory;
    case ChildReport::End::cpu_limit:
    case ChildReport::End::wall_limit:
    case ChildReport::End::output_limit:
    case ChildReport::End::killed:
      return Outcome::killed;
    default:
      return Outcome::crash;
  }
}

PackedTrial result_of(const TrialSpec& spec, const ChildReport& report,
                      const ProcessLimits& limits) {
  PackedTrial result;
  bool whole = report.end == ChildReport::End::finished;
  if (whole) {
    try {
      result = unpack(report.output);
    } catch (const std::invalid_argument&) {
      whole = false;
    }
  }
  if (!whole)
    result = {record_of_failure(spec, outcome_of(report.end), end_in_words(report, limits)), {}};
  result.record.cpu_time_s = report.cpu_time_s;
  result.record.memory_max_mb = report.memory_max_mb;
  return result;
}

// What cannot be known of a single flight.
std::string after_second_flight(const std::string& reason) {
  return reason + ", which no limit sent, and so when it was flown again";
}

// In the warm parent of a series: what the trials of one world are judged by, made once.
void share_contacts(TrialSpec& spec) {
  static std::shared_ptr<const World> world;
  static std::shared_ptr<const CollisionScene> contacts;
  if (spec.kind != TrialKind::flown) return;
  if (world != spec.scenario.world) {
    contacts = CollisionScene::of(spec.scenario.world->shapes());
    world = spec.scenario.world;
  }
  spec.contacts = contacts;
}

constexpr const char* kTookTheRunner =
    "the runner ended while this trial flew, and again when it flew alone";

// Hands out what is missing as jobs and takes in what they bring back. What somebody killed, and
// what was in flight when an earlier runner died, is flown last and with nothing beside it.
class SuiteRun {
 public:
  SuiteRun(const SuiteConfig& suite, const FlyTrial& fly, ShortestReferences& references,
           ResultStore& store, Progress& progress, const RunShare& share, StopSignals& stop)
      : suite_(suite),
        fly_(fly),
        references_(references),
        store_(store),
        progress_(progress),
        share_(share),
        stop_(stop),
        marks_(store.file().string() + "-in-flight"),
        trials_(suite, rehearse_in_child(), share.shard) {}

  RunReport report;

  // A share of what is left that keeps every lane busy to the end; one series of children does it.
  std::vector<ProcessPool::Job> next_share(std::size_t lanes) {
    const std::size_t left = trials_.total() - std::min(trials_.total(), taken_);
    const std::size_t size = std::clamp<std::size_t>(left / (2 * lanes), 1, kShareMax);
    std::vector<ProcessPool::Job> share;
    while (share.size() < size) {
      auto job = next();
      if (!job) break;
      share.push_back(std::move(*job));
    }
    return share;
  }

  // One at a time.
  std::vector<ProcessPool::Job> next_again() {
    if (again_.empty()) return {};
    const Pending pending = again_.front();
    again_.pop_front();
    return {job(pending)};
  }

 private:
  // Worlds of so many trials are in memory at a time, for each lane.
  static constexpr std::size_t kShareMax = 64;

  enum class Flight { first, suspect, second };

  struct Pending {
    std::shared_ptr<TrialSpec> spec;
    Flight flight;
  };

  std::optional<ProcessPool::Job> next() {
    while (auto planned = trials_.next()) {
      ++taken_;
      progress_.tick(ChildProcess::Clock::now());
      TrialSpec& spec = planned->spec;
      const auto suspicion = marks_.suspicion(spec.trial_id);
      if (store_.has(spec.trial_id) || share_.elsewhere.contains(spec.trial_id)) {
        ++report.stored;
        progress_.trial_stored();
        marks_.stored(spec.trial_id);
      } else if (const std::string why = why_not(*planned); !why.empty()) {
        // Who sends a signal to all processes of a job has ended those that made the world, too.
        if (stop_.received()) return std::nullopt;
        keep({record_of_failure(spec, Outcome::invalid, why), {}});
      } else if (suspicion == FlightMarks::Suspicion::culprit) {
        keep({record_of_failure(spec, Outcome::crash, kTookTheRunner), {}});
      } else if (suspicion == FlightMarks::Suspicion::suspect) {
        draw_world(spec);
        again_.push_back({std::make_shared<TrialSpec>(std::move(spec)), Flight::suspect});
      } else {
        draw_world(spec);
        return job({std::make_shared<TrialSpec>(std::move(spec)), Flight::first});
      }
    }
    return std::nullopt;
  }

  // Gives the trial its references. Why it cannot be flown; empty if it can.
  std::string why_not(PlannedTrial& planned) {
    if (!planned.refusal.empty()) return planned.refusal;
    try {
      references_.add_to(planned.spec);
      return {};
    } catch (const std::runtime_error& error) {
      return error.what();
    }
  }

  void draw_world(const TrialSpec& spec) {
    if (spec.world_id == drawn_world_) return;
    store_.keep_world(trace_world(spec.scenario, spec.world_id));
    drawn_world_ = spec.world_id;
  }

  ProcessPool::Job job(const Pending& pending) {
    return {[this, pending] { return fly_and_pack(*pending.spec, fly_, suite_.traces); },
            [pending] { share_contacts(*pending.spec); },
            [this, pending] {
              marks_.takes_off(pending.spec->trial_id, pending.flight == Flight::suspect);
            },
            [this, pending](const ChildReport& ended) { take(pending, ended); }};
  }

  void take(const Pending& pending, const ChildReport& ended) {
    marks_.landed(pending.spec->trial_id);
    const bool killed = ended.end == ChildReport::End::killed;
    if (killed && pending.flight != Flight::second) {
      again_.push_back({pending.spec, Flight::second});
      return;
    }
    PackedTrial result = result_of(*pending.spec, ended, suite_.limits.process);
    if (killed) result.record.reason = after_second_flight(result.record.reason);
    keep(result);
  }

  void keep(const PackedTrial& result) {
    store_.keep(result.record, result.trace_blob);
    marks_.stored(result.record.trial_id);
    ++report.done;
    progress_.trial_done(entry_of(result.record.outcome).cut_off);
  }

  const SuiteConfig& suite_;
  const FlyTrial& fly_;
  ShortestReferences& references_;
  ResultStore& store_;
  Progress& progress_;
  const RunShare& share_;
  StopSignals& stop_;
  FlightMarks marks_;
  SuiteTrials trials_;
  std::size_t taken_ = 0;  // of trials_
  std::deque<Pending> again_;
  std::string drawn_world_;
};

}  // namespace

RunReport run_suite(const SuiteConfig& suite, const FlyTrial& fly, std::size_t jobs,
                    ShortestReferences& references, ResultStore& store, Progress& progress,
                    const RunShare& share) {
  StopSignals stop;
  SuiteRun run(suite, fly, references, store, progress, share, stop);
  const auto tick = [&] {
    store.flush_when_due();
    progress.tick(ChildProcess::Clock::now());
  };
  const ChildProcess::Setup setup{.read_only = {store.file().parent_path()}};
  ProcessPool together(stop, jobs, suite.limits.process, setup, tick);
  ProcessPool alone(stop, 1, suite.limits.process, setup, tick);
  auto end = together.run([&] { return run.next_share(jobs); });
  if (end == ProcessPool::End::all_done) end = alone.run([&] { return run.next_again(); });
  run.report.interrupted = end == ProcessPool::End::interrupted;
  run.report.stopped = end == ProcessPool::End::stopped;
  if (end == ProcessPool::End::all_done) progress.all_done();
  store.flush();
  progress.finish(ChildProcess::Clock::now());
  return run.report;
}

RunRecord run_alone(const TrialSpec& spec, const TrialLimits& limits, const FlyTrial& fly) {
  const auto flown = [&] {
    return run_in_child([&] { return fly_and_pack(spec, fly, TraceKeeping::none); }, limits.process,
                        {.streams = ChildProcess::Streams::inherited});
  };
  const ChildReport first = flown();
  if (first.end != ChildReport::End::killed) return result_of(spec, first, limits.process).record;
  const ChildReport second = flown();
  RunRecord record = result_of(spec, second, limits.process).record;
  if (second.end == ChildReport::End::killed) record.reason = after_second_flight(record.reason);
  return record;
}

RunRecord record_of_failure(const TrialSpec& spec, Outcome outcome, const std::string& reason) {
  RunRecord record = record_before_flight(spec);
  record.outcome = outcome;
  record.reason = reason;
  record.spl = 0;
  return record;
}

}  // namespace voronaut
