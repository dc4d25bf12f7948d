#include <algorithm>
#include <cerrno>
#include <cmath>
#include <ostream>
#include <stdexcept>
#include <system_error>

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "voronaut/benchmarks/cli/commands.h"
#include "voronaut/benchmarks/engines/engine.h"
#include "voronaut/benchmarks/results/merge.h"
#include "voronaut/benchmarks/results/output_folder.h"
#include "voronaut/benchmarks/suite/shard.h"
#include "voronaut/benchmarks/suite/suite_trials.h"
#include "voronaut/environments/config/nearest_name.h"
#include "voronaut/reports/store/atomic_file.h"

// Runs in shards on engines of others.
namespace voronaut {

namespace {

// A shard is to take minutes: starting one costs seconds on a cluster.
constexpr double kShardTime_s = 300;
// Of a trial of which nothing is known.
constexpr double kTrialTime_s = 0.25;
// Of Slurm's arrays, unless an administrator has changed MaxArraySize.
constexpr double kShardsMax = 1000;

// By what trials of this run have cost so far.
std::size_t shards_for(std::size_t trials, const std::filesystem::path& run) {
  double sum_s = 0;
  double rows = 0;
  for (const auto& folder : folders_with_results(run)) {
    for (const RunRecord& record : OutputFolder::open(folder).store().records()) {
      sum_s += record.cpu_time_s;
      ++rows;
    }
  }
  const double trial_s = rows > 0 ? sum_s / rows : kTrialTime_s;
  return static_cast<std::size_t>(
      std::clamp(std::ceil(static_cast<double>(trials) * trial_s / kShardTime_s), 1., kShardsMax));
}

std::string absolute(const std::string& path) {
  return std::filesystem::absolute(path).lexically_normal().string();
}

// `voronaut run SUITE ... --shard`, as it can be said from any folder.
std::vector<std::string> shard_command(const SubmitOptions& options, const SuiteSource& source,
                                       const std::filesystem::path& run) {
  std::vector<std::string> words = {std::filesystem::read_symlink("/proc/self/exe").string(),
                                    "run",
                                    absolute(source.file),
                                    "--out",
                                    run.string(),
                                    "--jobs",
                                    std::to_string(options.jobs)};
  const auto add = [&](const char* option, const std::string& value) {
    if (!value.empty()) words.insert(words.end(), {option, value});
  };
  std::string planners;
  for (const std::string& label : options.planners)
    planners += (planners.empty() ? "" : ",") + label;
  add("--planners", planners);
  add("--seed", options.seed);
  add("--repetitions", options.repetitions);
  for (const std::string& setting : options.set) add("--set", setting);
  const std::string data = DataLocation::find(source.data_argument).folder;
  add("--data", data.empty() ? "" : absolute(data));
  for (const std::string& plugin : options.plugins) add("--plugin", absolute(plugin));
  words.emplace_back("--shard");
  return words;
}

void write_files(const std::vector<EngineFile>& files, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  for (const EngineFile& file : files) {
    write_file_atomically(folder / file.name, file.text);
    if (file.text.starts_with("#!"))
      std::filesystem::permissions(folder / file.name, std::filesystem::perms(0755));
  }
}

// The exit code of a script.
int run_script(const std::filesystem::path& script) {
  std::string shell = "sh";
  std::string file = script.string();
  char* const words[] = {shell.data(), file.data(), nullptr};
  pid_t process = 0;
  if (const int error = posix_spawnp(&process, "sh", nullptr, nullptr, words, environ); error != 0)
    throw std::system_error(error, std::generic_category(), file);
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}

ExitCode code_of(int script_code) {
  return script_code == 0 ? ExitCode::success : ExitCode::failure;
}

}  // namespace

ExitCode execute(const SubmitOptions& options, const CommandContext& context) {
  SuiteSource source = source_of(options);
  SuiteConfig suite = source.read(context.planners);
  SuiteTrials::check_worlds(suite);
  if (!options.planners.empty()) keep_planners(suite, options.planners);
  const std::size_t trials = SuiteTrials(suite).total();

  ShardedRun run;
  run.suite = suite.name;
  run.folder = absolute(run_folder(options.out, suite).string());
  run.shards = options.shards > 0 ? options.shards : shards_for(trials, run.folder);
  run.jobs = options.jobs;
  run.shard_command = shard_command(options, source, run.folder);
  run.merge_command = {run.shard_command.front(), "merge", run.folder.string(), "-o",
                       run.folder.string()};

  const std::filesystem::path folder = engine_folder(run.folder, options.engine);
  write_files(engine_of(options.engine).files(run), folder);
  context.out << trials << " trials in " << run.shards << " shards: " << folder.string()
              << std::endl;
  if (suite.flight.budget.counts == PlanningBudget::Counts::wall_clock)
    context.err << "voronaut: suite " << in_quotes(suite.name)
                << ": its budget is wall clock (budget.wall_clock_s), results hang on the machines "
                   "and the digest will not repeat"
                << std::endl;
  const std::filesystem::path script = folder / "submit";
  if (options.dry_run || !std::filesystem::exists(script)) return ExitCode::success;
  return code_of(run_script(script));
}

ExitCode execute(const CancelOptions& options, const CommandContext& context) {
  ExitCode code = ExitCode::success;
  bool any = false;
  for (const std::string& engine : engine_names()) {
    const std::filesystem::path script = engine_folder(options.folder, engine) / "cancel";
    if (!std::filesystem::exists(script)) continue;
    any = true;
    if (run_script(script) != 0) code = ExitCode::failure;
  }
  if (!any)
    throw std::invalid_argument(options.folder + ": nothing was submitted from here (no engines)");
  context.out << "what was submitted goes on where it is submitted again" << std::endl;
  return code;
}

}  // namespace voronaut
