#include "voronaut/benchmarks/cli/dry_run.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <ostream>
#include <set>

#include "voronaut/benchmarks/isolation/process_pool.h"
#include "voronaut/benchmarks/results/merge.h"
#include "voronaut/benchmarks/results/output_folder.h"
#include "voronaut/benchmarks/runner/isolated_world.h"
#include "voronaut/benchmarks/runner/progress.h"
#include "voronaut/benchmarks/runner/run_trial.h"
#include "voronaut/benchmarks/runner/runner.h"
#include "voronaut/benchmarks/suite/suite_trials.h"
#include "voronaut/reports/summary/text_table.h"

namespace voronaut {

namespace {

// A probe is this many trials of each planner, as far as the time allows.
constexpr std::size_t kProbesOfPlanner = 3;
constexpr double kProbeTime_s = 5;
constexpr std::size_t kFilesShown = 20;

// CPU time of trials that were flown.
struct Cost {
  double sum_s = 0;
  std::size_t n = 0;

  void add(const Cost& other) {
    sum_s += other.sum_s;
    n += other.n;
  }
  double mean_s() const { return n > 0 ? sum_s / static_cast<double>(n) : 0; }
};

using CostByPlanner = std::map<std::string, Cost>;

// What the folders of a run hold of this version of the suite.
struct StoredRows {
  std::set<std::string> ids;
  CostByPlanner costs;
};

StoredRows stored_rows(const std::filesystem::path& run, const SuiteConfig& whole) {
  StoredRows rows;
  const std::string identity = suite_identity(whole);
  for (const auto& folder : folders_with_results(run)) {
    const OutputFolder part = OutputFolder::open(folder);
    if (part.store().meta("suite_identity") != identity) continue;
    part.store().for_each_record([&](const RunRecord& record) {
      if (rows.ids.insert(record.trial_id).second)
        rows.costs[record.planner].add({record.cpu_time_s, 1});
    });
  }
  return rows;
}

// What a run would fly of one planner. Of its trials those with the smallest ids are kept: ids are
// hashes, so these are drawn from all of them, and always the same.
struct Planned {
  std::size_t trials = 0;
  std::size_t stored = 0;
  std::map<std::string, TrialSpec> sample;
};

using PlannedByPlanner = std::map<std::string, Planned>;

PlannedByPlanner plan(const SuiteConfig& suite, const Shard& shard, const StoredRows& rows) {
  PlannedByPlanner planned;
  SuiteTrials trials(suite, rehearse_in_child(), shard);
  while (auto next = trials.next()) {
    Planned& of_planner = planned[next->spec.planner.label];
    ++of_planner.trials;
    if (rows.ids.contains(next->spec.trial_id)) {
      ++of_planner.stored;
    } else if (next->refusal.empty()) {
      const std::string id = next->spec.trial_id;
      of_planner.sample.emplace(id, std::move(next->spec));
      if (of_planner.sample.size() > kProbesOfPlanner)
        of_planner.sample.erase(std::prev(of_planner.sample.end()));
    }
  }
  return planned;
}

// Flies some trials of each planner of which nothing is known, one of each before a second of any.
CostByPlanner probe(const SuiteConfig& suite, const PlannedByPlanner& planned,
                    const CostByPlanner& known, const PlannerCatalog& planners) {
  using Clock = std::chrono::steady_clock;
  const auto left_s = [end = Clock::now() + std::chrono::duration<double>(kProbeTime_s)] {
    return std::chrono::duration<double>(end - Clock::now()).count();
  };
  const FlyTrial fly = [&](const TrialSpec& spec, bool keep_trace) {
    return run_trial(spec, planners, keep_trace);
  };
  CostByPlanner costs;
  for (std::size_t i = 0; i < kProbesOfPlanner; ++i) {
    for (const auto& [label, of_planner] : planned) {
      TrialLimits limits = suite.limits;
      limits.process.wall_s = std::min(limits.process.wall_s, left_s());
      if (limits.process.wall_s <= 0) return costs;
      if (known.contains(label) || i >= of_planner.sample.size()) continue;
      const TrialSpec& spec = std::next(of_planner.sample.begin(), static_cast<int>(i))->second;
      costs[label].add({run_alone(spec, limits, fly).cpu_time_s, 1});
    }
  }
  return costs;
}

Cost sum_of(const CostByPlanner& costs) {
  Cost sum;
  for (const auto& [label, cost] : costs) sum.add(cost);
  return sum;
}

// What is expected of the planners, and where that comes from.
struct Forecast {
  PlannedByPlanner planned;
  CostByPlanner stored;
  CostByPlanner probed;
  std::size_t trials = 0;
  std::size_t missing = 0;
  double cpu_s = 0;

  // Of a planner that nothing is known of what the others cost.
  double trial_s(const std::string& label) const {
    for (const CostByPlanner* costs : {&stored, &probed})
      if (const auto found = costs->find(label); found != costs->end())
        return found->second.mean_s();
    Cost all = sum_of(stored);
    all.add(sum_of(probed));
    return all.mean_s();
  }
  std::string known_from(const std::string& label) const {
    if (const auto found = stored.find(label); found != stored.end())
      return std::to_string(found->second.n) + " stored";
    if (const auto found = probed.find(label); found != probed.end())
      return "a probe of " + std::to_string(found->second.n);
    return "the others";
  }
};

Forecast forecast(const SuiteConfig& suite, const Shard& shard, const StoredRows& rows,
                  const PlannerCatalog& planners) {
  Forecast expected{plan(suite, shard, rows), rows.costs, {}};
  expected.probed = probe(suite, expected.planned, rows.costs, planners);
  for (const auto& [label, of_planner] : expected.planned) {
    const std::size_t missing = of_planner.trials - of_planner.stored;
    expected.trials += of_planner.trials;
    expected.missing += missing;
    expected.cpu_s += static_cast<double>(missing) * expected.trial_s(label);
  }
  return expected;
}

TextTable table_of(const SuiteConfig& suite, const Forecast& expected) {
  TextTable table{{{"planner", TextTable::Align::left},
                   {"trials"},
                   {"stored"},
                   {"to fly"},
                   {"CPU ms each"},
                   {"known from", TextTable::Align::left}},
                  {}};
  for (const PlannerSpec& planner : suite.planners) {
    const auto found = expected.planned.find(planner.label);
    const Planned none;
    const Planned& its = found == expected.planned.end() ? none : found->second;
    table.rows.push_back({printable(planner.label), std::to_string(its.trials),
                          std::to_string(its.stored), std::to_string(its.trials - its.stored),
                          fixed(expected.trial_s(planner.label) * 1e3, 1),
                          expected.known_from(planner.label)});
  }
  table.rows.push_back({"all", std::to_string(expected.trials),
                        std::to_string(expected.trials - expected.missing),
                        std::to_string(expected.missing), "", ""});
  return table;
}

void print_files(const SuiteSource& source, std::ostream& out) {
  out << "files read: " << source.file << "\n";
  std::size_t shown = 0;
  for (const auto& [path, bytes] : source.files)
    if (shown++ < kFilesShown) out << "  " << path << "\n";
  if (shown > kFilesShown) out << "  and " << shown - kFilesShown << " more\n";
}

}  // namespace

std::string size_text(const SuiteConfig& suite) {
  std::string text = "suite '" + suite.name + "', " + std::to_string(suite.scenarios.size()) +
                     " scenarios x " + std::to_string(suite.vehicles.size()) + " vehicles x " +
                     std::to_string(suite.planners.size()) + " planners x " +
                     std::to_string(suite.repetitions) +
                     " repetitions = " + std::to_string(SuiteTrials(suite).total()) + " trials";
  for (const SweepAxis& axis : suite.sweep) {
    std::set<std::size_t> values;
    for (const SweptEntry& entry : axis.entries) values.insert(entry.step);
    text += "\n  over " + axis.path + ": " + std::to_string(values.size()) + " values" +
            (axis.zipped ? ", in step" : "");
  }
  return text;
}

void print_dry_run(const DryRun& run, const CommandContext& context) {
  const StoredRows rows = stored_rows(run.folder, run.whole);
  const Forecast expected = forecast(run.suite, run.shard, rows, context.planners);
  context.out << size_text(run.suite) << "\n";
  if (!run.shard.is_whole())
    context.out << "shard " << run.shard.text() << ": " << expected.trials << " of them\n";
  context.out << "\n" << table_of(run.suite, expected).aligned() << "\n";
  print_files(run.source, context.out);
  const std::size_t jobs = run.jobs > 0 ? run.jobs : ProcessPool::default_jobs();
  const double sides =
      static_cast<double>(std::min(jobs, std::max<std::size_t>(1, expected.missing)));
  context.out << "about " << duration_text(expected.cpu_s) << " of CPU time in flight for "
              << expected.missing << " trials, " << duration_text(expected.cpu_s / sides)
              << " with " << jobs << " at once: by " << sum_of(expected.stored).n
              << " trials stored in " << run.folder.string() << " and a probe of "
              << sum_of(expected.probed).n
              << "; worlds and shortest paths come on top; nothing was written" << std::endl;
}

}  // namespace voronaut
