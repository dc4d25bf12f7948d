#include <filesystem>
#include <ostream>
#include <stdexcept>
#include <utility>

#include "voronaut/benchmarks/cli/commands.h"
#include "voronaut/benchmarks/results/mapped_logs.h"
#include "voronaut/benchmarks/results/output_folder.h"
#include "voronaut/benchmarks/results/published_file.h"
#include "voronaut/environments/config/config_node.h"
#include "voronaut/environments/scenario/scenario_spec.h"
#include "voronaut/reports/page/html_report.h"
#include "voronaut/reports/page/mapping_report.h"
#include "voronaut/reports/store/atomic_file.h"
#include "voronaut/reports/store/csv_writer.h"
#include "voronaut/reports/summary/comparison_text.h"
#include "voronaut/reports/summary/summary_text.h"

namespace voronaut {

namespace {

std::string markdown(const OutputFolder& folder, const ReportBeside& beside) {
  std::string text = summary_markdown(folder.summary());
  if (beside.comparison) text += "\n" + comparison_markdown(*beside.comparison);
  if (beside.published) text += "\n" + barn_markdown(*beside.published);
  return text;
}

void write(const ReportOptions& options, const CommandContext& context, const std::string& text) {
  if (options.out.empty()) {
    context.out << text;
    return;
  }
  write_file_atomically(options.out, text);
  context.out << options.out << "\n";
}

// What `make` makes of a file that voronaut-micro printed; an error names the file.
template <class Make>
std::string page_of_benchmarks(const std::string& file, Make&& make) {
  const std::string json = read_text_file(file);
  try {
    return make(json);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(file + ": " + error.what());
  }
}

// What voronaut-micro printed as JSON, with the recorded lidar that is at hand.
ExitCode report_mapping(const ReportOptions& options, const CommandContext& context) {
  if (options.format != "html" || !options.compare.empty() || !options.published.empty())
    throw std::invalid_argument(options.folder + ": of microbenchmarks only html is written");
  const std::string data = DataLocation::find(options.data).folder;
  const std::filesystem::path page =
      options.out.empty() ? std::filesystem::path(options.folder).replace_extension(".html")
                          : std::filesystem::path(options.out);
  const std::string written = page_of_benchmarks(options.folder, [&](const std::string& json) {
    return mapping_report("The mapping step", json, map_logs(data));
  });
  write_file_atomically(page, written);
  context.out << page.string() << "\n";
  return ExitCode::success;
}

// What voronaut-micro printed, if it lies in the folder as micro.json.
std::string mapping_beside(const OutputFolder& folder, const ReportOptions& options) {
  const std::filesystem::path micro = folder.file("micro.json");
  if (!std::filesystem::exists(micro)) return {};
  return page_of_benchmarks(micro, [&](const std::string& json) {
    return mapping_data_json(json, map_logs(DataLocation::find(options.data).folder));
  });
}

}  // namespace

ExitCode execute(const ReportOptions& options, const CommandContext& context) {
  if (std::filesystem::is_regular_file(options.folder)) return report_mapping(options, context);
  const OutputFolder folder = OutputFolder::open(options.folder);
  for (const auto& [option, value] :
       {std::pair("--compare", options.compare), std::pair("--published", options.published)}) {
    if (options.format == "csv" && !value.empty())
      throw std::invalid_argument(std::string(option) + ": goes with --format html or md, not csv");
  }
  ReportBeside beside;
  if (!options.compare.empty())
    beside.comparison = folder.compare_with(OutputFolder::open(options.compare));
  if (!options.published.empty())
    beside.published = beside_published_file(folder, options.published);
  if (options.format == "csv") {
    if (options.out.empty()) {
      write_csv_of(folder.store(), context.out);
    } else {
      write_file_atomically(options.out,
                            [&](std::ostream& file) { write_csv_of(folder.store(), file); });
      context.out << options.out << "\n";
    }
  } else if (options.format == "md") {
    write(options, context, markdown(folder, beside));
  } else {
    const std::filesystem::path file =
        options.out.empty() ? folder.file("report.html") : std::filesystem::path(options.out);
    if (options.out.empty()) folder.write_csv();
    beside.mapping_json = mapping_beside(folder, options);
    folder.write_report(file, std::move(beside));
    context.out << file.string() << "\n";
  }
  return ExitCode::success;
}

}  // namespace voronaut
