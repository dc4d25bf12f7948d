#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <ostream>
#include <stdexcept>

#include "voronaut/benchmarks/cli/commands.h"
#include "voronaut/benchmarks/cli/flying.h"
#include "voronaut/benchmarks/cli/tuning_heat.h"
#include "voronaut/benchmarks/keys/file_keys.h"
#include "voronaut/benchmarks/results/digest.h"
#include "voronaut/benchmarks/suite/suite_trials.h"
#include "voronaut/benchmarks/tuning/race.h"
#include "voronaut/benchmarks/tuning/tuned_suites.h"
#include "voronaut/environments/config/nearest_name.h"
#include "voronaut/environments/random.h"
#include "voronaut/reports/store/atomic_file.h"
#include "voronaut/reports/summary/comparison_text.h"
#include "voronaut/reports/summary/text_table.h"

namespace voronaut {

namespace {

constexpr const char* kCandidatesFile = "tune.yaml";
constexpr const char* kWinnerFile = "tuned.yaml";

// All that a tuning is made of.
struct Tuning {
  ConfigNode root;  // of the suite that is tuned, with what is set
  std::string file;
  std::string planner;
  std::vector<SearchKey> keys;
  std::vector<Candidate> candidates;
  std::vector<const Statistic*> objectives;
  std::vector<Rung> rungs;
  int repetitions = 1;
  std::filesystem::path folder;
  SuiteSource source;  // of the suite of the candidates
  std::string fresh_seed;
  std::size_t jobs = 0;
};

std::vector<SearchKey> keys_of(const TuneOptions& options, const std::string& planner_name,
                               const CommandContext& context) {
  std::vector<KeyFact> declared = parameters_of(*context.planners.find(planner_name));
  for (KeyFact fact : key_facts(NavigationConfig{})) {
    fact.key = "navigation." + fact.key;
    declared.push_back(std::move(fact));
  }
  std::vector<SearchKey> keys;
  for (const std::string& text : options.over) {
    keys.push_back(search_key(text, declared));
    for (std::size_t i = 0; i + 1 < keys.size(); ++i)
      if (keys[i].key == keys.back().key)
        throw std::invalid_argument("--over: " + in_quotes(keys[i].key) + " is given twice");
  }
  return keys;
}

// What is set about the planners is in the candidates already.
std::vector<std::string> settings_of_the_rest(const std::vector<std::string>& set) {
  std::vector<std::string> rest;
  for (const std::string& setting : set)
    if (!setting.starts_with("planner")) rest.push_back(setting);
  return rest;
}

Tuning tuning_of(const TuneOptions& options, const CommandContext& context) {
  SuiteSource source = source_of(options);
  const SuiteConfig suite = source.read(context.planners);
  SuiteTrials::check_worlds(suite);
  for (const SweepAxis& axis : suite.sweep)
    if (axis.column == "planner")
      throw std::invalid_argument(source.file + ": sweeps over " + axis.path +
                                  "; a tuning makes the planners itself");
  Tuning tuning{source.root(),
                std::filesystem::absolute(source.file).lexically_normal().string(),
                options.planner,
                {},
                {},
                {},
                {},
                suite.repetitions,
                {},
                {},
                {},
                options.jobs};
  planner_entry(tuning.root, options.planner);
  for (const PlannerSpec& planner : suite.planners)
    if (planner.label == options.planner) tuning.keys = keys_of(options, planner.name, context);
  tuning.candidates =
      candidates_of(options.planner, points_in(tuning.keys, options.candidates - 1, suite.seed));
  for (const std::string& name : options.objectives) tuning.objectives.push_back(&objective(name));
  tuning.rungs = rungs(tuning.candidates.size(), suite.repetitions);
  tuning.folder = options.out.empty()
                      ? std::filesystem::path("voronaut-results") / (suite.name + "-tune")
                      : std::filesystem::path(options.out);
  tuning.fresh_seed = std::to_string(derive_seed(suite.seed, {"fresh worlds of a tuning"}, 0));
  tuning.source = {
      (tuning.folder / kCandidatesFile).string(),
      candidates_suite(tuning.root, tuning.file, tuning.planner, tuning.keys, tuning.candidates),
      options.data,
      options.seed,
      "",
      {},
      settings_of_the_rest(options.set)};
  return tuning;
}

// A folder belongs to one tuning.
void write_candidates(const Tuning& tuning) {
  std::ifstream there(tuning.source.file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(there), {}};
  if (there && text != tuning.source.text)
    throw std::invalid_argument(tuning.folder.string() +
                                ": holds another tuning; give another --out or remove it");
  std::filesystem::create_directories(tuning.folder);
  write_file_atomically(tuning.source.file, tuning.source.text);
}

Heat heat_of(const Tuning& tuning, const std::vector<std::string>& planners, int repetitions) {
  Heat heat{tuning.folder, tuning.source, planners, repetitions};
  heat.source.repetitions = std::to_string(repetitions);
  return heat;
}

std::string values_text(const Tuning& tuning, const std::string& label) {
  std::string text;
  for (const Candidate& candidate : tuning.candidates)
    if (candidate.label == label)
      for (std::size_t i = 0; i < candidate.values.size(); ++i)
        text.append(text.empty() ? "" : " ").append(tuning.keys[i].key + "=" + candidate.values[i]);
  return text.empty() ? "as the suite has it" : text;
}

// What tuned.yaml must be flown with to be what was tuned.
std::string settings_text(const Tuning& tuning) {
  std::string text;
  for (const std::string& setting : tuning.source.set) text += " --set " + in_quotes(setting);
  return text.empty() ? "" : ", with" + text;
}

void print_rung(const Tuning& tuning, std::size_t number, int repetitions,
                const std::vector<Standing>& standings, std::ostream& out) {
  TextTable table{{{"candidate", TextTable::Align::left},
                   {"values", TextTable::Align::left},
                   {"mean rank"},
                   {"behind the leader [95 %]"},
                   {"", TextTable::Align::left}},
                  {}};
  for (const Standing& standing : standings) {
    const Interval& interval = standing.behind_leader.interval;
    const std::string ends = std::isnan(interval.low) ? ""
                                                      : " [" + fixed(interval.low, 3) + ", " +
                                                            fixed(interval.high, 3) + "]";
    table.rows.push_back({printable(standing.planner), values_text(tuning, standing.planner),
                          fixed(standing.score, 3), fixed(standing.behind_leader.value, 3) + ends,
                          standing.kept ? "goes on" : ""});
  }
  out << "rung " << number << " of " << tuning.rungs.size() << ": " << standings.size()
      << " candidates, " << repetitions << " repetitions\n"
      << table.aligned() << std::endl;
}

// The winner of all rungs; an exit code where there is none yet.
struct Raced {
  std::string winner;
  std::optional<ExitCode> ended;
};

Raced race_all(const Tuning& tuning, bool fly, const CommandContext& context) {
  std::vector<std::string> planners;
  for (const Candidate& candidate : tuning.candidates) planners.push_back(candidate.label);
  for (std::size_t i = 0; i < tuning.rungs.size() && planners.size() > 1; ++i) {
    const int repetitions = tuning.rungs[i].repetitions;
    const Heat heat = heat_of(tuning, planners, repetitions);
    const Flown flown = fly_heat(heat, tuning.jobs, fly, context);
    if (flown.ended) return {"", flown.ended};
    if (flown.missing > 0) {
      print_next(heat, flown.missing, context);
      return {"", ExitCode::success};
    }
    const bool last = i + 1 == tuning.rungs.size();
    const auto standings =
        race(planners, tuning.objectives, flown.rows, last ? 1 : tuning.rungs[i + 1].candidates);
    print_rung(tuning, i + 1, repetitions, standings, context.out);
    planners.clear();
    for (const Standing& standing : standings)
      if (standing.kept) planners.push_back(standing.planner);
  }
  return {planners.front(), std::nullopt};
}

std::vector<RunRecord> renamed(const std::vector<RunRecord>& rows, const std::string& planner,
                               const std::string& name) {
  std::vector<RunRecord> all;
  for (const RunRecord& row : rows) {
    if (row.planner != planner) continue;
    all.push_back(row);
    all.back().planner = name;
    all.back().scenario_group = "all";  // the race pooled them, too
  }
  return all;
}

RunComparison against_default(const Tuning& tuning, const std::string& winner,
                              const std::vector<RunRecord>& rows) {
  ComparisonConfig config;
  config.statistics = tuning.objectives;
  config.same_flight = same_flight;
  RunComparison comparison =
      compare_runs(renamed(rows, winner, winner), renamed(rows, tuning.planner, winner), config);
  comparison.title = tuning.planner;
  return comparison;
}

}  // namespace

ExitCode execute(const TuneOptions& options, const CommandContext& context) {
  hold_stop_signals();
  const Tuning tuning = tuning_of(options, context);
  write_candidates(tuning);
  const Raced raced = race_all(tuning, !options.dry_run, context);
  if (raced.ended) return *raced.ended;
  if (raced.winner == tuning.planner) {
    context.out << "no candidate is better than " << tuning.planner << " as the suite has it\n";
    return ExitCode::success;
  }
  Heat fresh = heat_of(tuning, {tuning.planner, raced.winner}, tuning.repetitions);
  fresh.folder = tuning.folder / "fresh";
  fresh.source.seed = tuning.fresh_seed;
  const Flown flown = fly_heat(fresh, tuning.jobs, !options.dry_run, context);
  if (flown.ended) return *flown.ended;
  if (flown.missing > 0) {
    print_next(fresh, flown.missing, context);
    return ExitCode::success;
  }
  const std::string values = values_text(tuning, raced.winner);
  context.out << "winner: " << raced.winner << ", " << values << "; on fresh seeds against "
              << tuning.planner << " as the suite has it:\n"
              << comparison_text(against_default(tuning, raced.winner, flown.rows));
  const std::filesystem::path file = tuning.folder / kWinnerFile;
  for (const Candidate& candidate : tuning.candidates)
    if (candidate.label == raced.winner)
      write_file_atomically(
          file, winners_suite(tuning.root, tuning.file, tuning.planner, tuning.keys, candidate,
                              tuning.planner + " tuned: " + values + settings_text(tuning)));
  context.out << "suite: " << file.string() << std::endl;
  return ExitCode::success;
}

}  // namespace voronaut
