#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

#include "voronaut/benchmarks/cli/options.h"
#include "voronaut/benchmarks/results/manifest.h"
#include "voronaut/planners/catalog/catalog.h"

// The commands of the program. Each throws what it thinks of its input (ConfigError, StoreError,
// std::invalid_argument, std::filesystem::filesystem_error) before it has written anything.
namespace voronaut {

struct CommandContext {
  const PlannerCatalog& planners;
  std::ostream& out;
  std::ostream& err;
  std::vector<std::string> command_line;
};

ExitCode execute(const RunOptions& options, const CommandContext& context);
ExitCode execute(const SummaryOptions& options, const CommandContext& context);
ExitCode execute(const ListOptions& options, const CommandContext& context);
ExitCode execute(const CheckOptions& options, const CommandContext& context);
ExitCode execute(const ReplayOptions& options, const CommandContext& context);
ExitCode execute(const DigestOptions& options, const CommandContext& context);
ExitCode execute(const ReportOptions& options, const CommandContext& context);
ExitCode execute(const CompareOptions& options, const CommandContext& context);
ExitCode execute(const EvidenceOptions& options, const CommandContext& context);
ExitCode execute(const PlotOptions& options, const CommandContext& context);
ExitCode execute(const ShowOptions& options, const CommandContext& context);
ExitCode execute(const ExportOptions& options, const CommandContext& context);
ExitCode execute(const SchemaOptions& options, const CommandContext& context);
ExitCode execute(const MergeOptions& options, const CommandContext& context);
ExitCode execute(const StatusOptions& options, const CommandContext& context);
ExitCode execute(const SubmitOptions& options, const CommandContext& context);
ExitCode execute(const CancelOptions& options, const CommandContext& context);
ExitCode execute(const TuneOptions& options, const CommandContext& context);
ExitCode execute(const InitOptions& options, const CommandContext& context);
ExitCode execute(const CompletionOptions& options, const CommandContext& context);

// The suite that is asked for, as text; and where its results go.
SuiteSource source_of(const SuiteChoice& choice);
std::filesystem::path run_folder(const std::string& out, const SuiteConfig& suite);

}  // namespace voronaut
