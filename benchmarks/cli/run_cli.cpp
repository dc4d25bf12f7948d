#include "voronaut/benchmarks/cli/run_cli.h"

#include <csignal>
#include <filesystem>
#include <iostream>
#include <stdexcept>

#include <ompl/util/Console.h>

#include "voronaut/benchmarks/cli/commands.h"
#include "voronaut/benchmarks/cli/plugin.h"
#include "voronaut/environments/config/config_error.h"
#include "voronaut/reports/store/sqlite.h"

namespace voronaut {

namespace {

ExitCode complain(const std::exception& error, ExitCode code) {
  std::cerr << "voronaut: " << error.what() << std::endl;
  return code;
}

ExitCode execute_any(const Options& options, const CommandContext& context) {
  try {
    return std::visit([&](const auto& chosen) { return execute(chosen, context); }, options);
  } catch (const ConfigError& error) {
    return complain(error, ExitCode::bad_input);
  } catch (const std::invalid_argument& error) {
    return complain(error, ExitCode::bad_input);
  } catch (const StoreError& error) {
    return complain(error, ExitCode::bad_input);
  } catch (const std::filesystem::filesystem_error& error) {
    return complain(error, ExitCode::bad_input);
  } catch (const std::exception& error) {
    return complain(error, ExitCode::failure);
  }
}

}  // namespace

namespace {

// With what the command's plugins bring. Commands without planners have no such option.
PlannerCatalog with_plugins(PlannerCatalog planners, const Options& options) {
  std::visit(
      [&](const auto& chosen) {
        if constexpr (requires { chosen.plugins; })
          for (const std::string& file : chosen.plugins) load_plugin(file, planners);
      },
      options);
  return planners;
}

}  // namespace

int run_cli(int argc, char** argv, const PlannerCatalog& planners) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow (ulimit -f) is an error with a message
  ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
  const ParsedArguments parsed = parse_arguments(argc, argv, std::cout, std::cerr);
  if (!parsed.options) return static_cast<int>(parsed.exit_code);
  try {
    const PlannerCatalog all = with_plugins(planners, *parsed.options);
    const CommandContext context{all, std::cout, std::cerr, {argv, argv + argc}};
    return static_cast<int>(execute_any(*parsed.options, context));
  } catch (const std::invalid_argument& error) {
    return static_cast<int>(complain(error, ExitCode::bad_input));
  }
}

}  // namespace voronaut
