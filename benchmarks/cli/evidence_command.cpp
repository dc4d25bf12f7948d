#include <fstream>
#include <ostream>
#include <sstream>

#include <nlohmann/json.hpp>

#include "voronaut/benchmarks/cli/commands.h"
#include "voronaut/benchmarks/results/digest.h"
#include "voronaut/benchmarks/results/evidence_page.h"
#include "voronaut/benchmarks/results/output_folder.h"
#include "voronaut/reports/store/atomic_file.h"

namespace voronaut {

namespace {

// The comment that a suite file begins with, up to its first line that says nothing.
std::string first_comment(const std::string& suite_text) {
  std::istringstream lines(suite_text);
  std::string text;
  for (std::string line; std::getline(lines, line) && line.starts_with("# ");)
    text += (text.empty() ? "" : " ") + line.substr(2);
  return text;
}

SuiteEvidence evidence_of(const std::string& path, const PlannerCatalog& planners) {
  const OutputFolder folder = OutputFolder::open(path);
  SuiteSource source = folder.source();
  const SuiteConfig suite = source.read(planners);
  std::ifstream file(folder.file("manifest.json"));
  const auto manifest = nlohmann::json::parse(file, nullptr, false);
  const auto said = [&](const nlohmann::json& in, const char* key) {
    return in.is_object() ? in.value(key, "unknown") : std::string("unknown");
  };
  const bool has_program = manifest.is_object() && manifest.contains("program");
  SuiteEvidence evidence;
  evidence.suite = suite.name;
  evidence.about = first_comment(source.text);
  evidence.commit = has_program ? said(manifest["program"], "commit") : "unknown";
  if (has_program && manifest["program"].value("dirty", false)) evidence.commit += " (changed)";
  evidence.started_utc = said(manifest, "started_utc");
  evidence.criteria = suite.acceptance;
  evidence.records = folder.store().records();
  evidence.digest = digest(evidence.records);
  return evidence;
}

}  // namespace

ExitCode execute(const EvidenceOptions& options, const CommandContext& context) {
  std::vector<SuiteEvidence> suites;
  for (const std::string& folder : options.folders)
    suites.push_back(evidence_of(folder, context.planners));
  const EvidencePage page = evidence_page(suites);
  if (options.out.empty())
    context.out << page.markdown;
  else
    write_file_atomically(options.out, page.markdown);
  return page.holds ? ExitCode::success : ExitCode::failure;
}

}  // namespace voronaut
