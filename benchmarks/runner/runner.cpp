#include "voronaut/benchmarks/runner/runner.h"

#include <stdexcept>

#include "voronaut/benchmarks/runner/isolated_world.h"
#include "voronaut/benchmarks/runner/packed_trial.h"
#include "voronaut/benchmarks/runner/process_pool.h"
#include "voronaut/benchmarks/suite/suite_trials.h"
#include "voronaut/environments/config/config_node.h"
#include "voronaut/reports/page/trace_json.h"

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

// Hands out what is missing as jobs and takes in what they bring back.
class SuiteRun {
 public:
  SuiteRun(const SuiteConfig& suite, const FlyTrial& fly, ShortestReferences& references,
           ResultStore& store, Progress& progress)
      : suite_(suite),
        fly_(fly),
        references_(references),
        store_(store),
        progress_(progress),
        trials_(suite, rehearse_in_child()) {}

  RunReport report;

  std::optional<ProcessPool::Job> next() {
    while (auto planned = trials_.next()) {
      progress_.tick(ChildProcess::Clock::now());
      if (store_.has(planned->spec.trial_id)) {
        ++report.stored;
        progress_.trial_stored();
      } else if (!planned->refusal.empty()) {
        keep({record_of_failure(planned->spec, Outcome::invalid, planned->refusal), {}});
      } else if (const std::string why = add_references(planned->spec); !why.empty()) {
        keep({record_of_failure(planned->spec, Outcome::invalid, why), {}});
      } else {
        return job(std::move(planned->spec));
      }
    }
    return std::nullopt;
  }

 private:
  // Why there are none, empty if there are.
  std::string add_references(TrialSpec& spec) {
    try {
      references_.add_to(spec);
      return {};
    } catch (const std::runtime_error& error) {
      return error.what();
    }
  }

  ProcessPool::Job job(TrialSpec&& pending) {
    if (pending.world_id != drawn_world_) {
      store_.insert_world(trace_world(pending.scenario, pending.world_id));
      drawn_world_ = pending.world_id;
    }
    const auto spec = std::make_shared<const TrialSpec>(std::move(pending));
    return {[this, spec] { return fly_and_pack(*spec, fly_, suite_.traces); },
            [this, spec](const ChildReport& ended) {
              keep(result_of(*spec, ended, suite_.limits.process));
            }};
  }

  void keep(const PackedTrial& result) {
    store_.insert_with_blob(result.record, result.trace_blob);
    ++report.done;
    progress_.trial_done(is_failure(result.record.outcome));
  }

  const SuiteConfig& suite_;
  const FlyTrial& fly_;
  ShortestReferences& references_;
  ResultStore& store_;
  Progress& progress_;
  SuiteTrials trials_;
  std::string drawn_world_;
};

}  // namespace

RunReport run_suite(const SuiteConfig& suite, const FlyTrial& fly, std::size_t jobs,
                    ShortestReferences& references, ResultStore& store, Progress& progress) {
  SuiteRun run(suite, fly, references, store, progress);
  ProcessPool pool(jobs, suite.limits.process, ChildProcess::Streams::silent,
                   [&] { progress.tick(ChildProcess::Clock::now()); });
  run.report.interrupted = pool.run([&] { return run.next(); }) == ProcessPool::End::interrupted;
  progress.finish(ChildProcess::Clock::now());
  return run.report;
}

RunRecord run_alone(const TrialSpec& spec, const TrialLimits& limits, const FlyTrial& fly) {
  const ChildReport ended =
      run_in_child([&] { return fly_and_pack(spec, fly, TraceKeeping::none); }, limits.process,
                   ChildProcess::Streams::inherited);
  return result_of(spec, ended, limits.process).record;
}

bool is_failure(Outcome outcome) {
  return outcome == Outcome::crash || outcome == Outcome::killed || outcome == Outcome::memory ||
         outcome == Outcome::invalid;
}

RunRecord record_of_failure(const TrialSpec& spec, Outcome outcome, const std::string& reason) {
  RunRecord record = record_before_flight(spec);
  record.outcome = outcome;
  record.reason = reason;
  record.spl = 0;
  return record;
}

}  // namespace voronaut
