#include "voronaut/benchmarks/cli/options.h"

#include <algorithm>
#include <ostream>

#include "voronaut/benchmarks/cli/completion.h"
#include "voronaut/benchmarks/cli/examples.h"
#include "voronaut/benchmarks/cli/option_lists.h"
#include "voronaut/benchmarks/results/build_info.h"
#include "voronaut/environments/config/nearest_name.h"

namespace voronaut {

const char* const kOptionsFooter =
    "Exit codes: 0 success; 1 ran, but something failed (a trial ended as crash, killed, memory "
    "or\n"
    "invalid, a replay differed, a criterion is broken, a comparison is worse, the run was\n"
    "interrupted); 2 bad input.";

CLI::Validator one_of(const std::vector<std::string>& names) {
  std::string all;
  for (const std::string& name : names) all += (all.empty() ? "{" : ",") + name;
  return {[names](std::string& value) {
            const bool known = std::find(names.begin(), names.end(), value) != names.end();
            return known ? "" : "no " + in_quotes(value) + allowed_names(value, names);
          },
          all + "}"};
}

CLI::Option* add_list(CLI::App* command, const std::string& name, std::vector<std::string>& values,
                      const std::string& description) {
  return command->add_option(name, values, description)
      ->delimiter(',')
      ->expected(1)
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

CLI::App* add_command(CLI::App& app, const std::string& name, const std::string& summary) {
  CLI::App* command = app.add_subcommand(name, summary);
  std::string examples = "Examples:\n";
  for (const std::string& example : command_examples(name)) examples += "  " + example + "\n";
  command->footer(examples + "\n" + kOptionsFooter);
  return command;
}

void add_folder(CLI::App* command, std::string& folder) {
  command->add_option("DIR", folder, "Folder of results")->required();
}

void add_data(CLI::App* command, std::string& data) {
  command->add_option("--data", data, "Folder of foreign data sets (else VORONAUT_DATA)");
}

void add_settings(CLI::App* command, std::vector<std::string>& settings) {
  command
      ->add_option("--set", settings,
                   "path=value instead of what the suite says, as planners.RRTConnect.range=0.5; "
                   "may be given again (docs/sweeps.md)")
      ->expected(1)
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

void add_plugins(CLI::App* command, std::vector<std::string>& plugins) {
  command->add_option("--plugin", plugins, "Shared library with planners; may be given again")
      ->expected(1)
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

// In the order in which they are needed.
Commands::Commands(CLI::App& app) {
  add_init(app);
  add_check(app);
  add_show(app);
  add_run(app);
  add_summary(app);
  add_report(app);
  add_compare(app);
  add_plot(app);
  add_replay(app);
  add_digest(app);
  add_evidence(app);
  add_export(app);
  add_list_command(app);
  add_schema(app);
  add_submit(app);
  add_status(app);
  add_merge(app);
  add_cancel(app);
  add_tune(app);
  add_completion(app);
}

Options Commands::chosen() const {
  const std::pair<const CLI::App*, Options> all[] = {
      {run_command, run},
      {summary_command, summary},
      {list_command, list},
      {check_command, check},
      {replay_command, replay},
      {digest_command, digest},
      {report_command, report},
      {compare_command, compare},
      {evidence_command, evidence},
      {show_command, show},
      {export_command, exported},
      {schema_command, schema},
      {merge_command, merge},
      {status_command, status},
      {submit_command, submit},
      {cancel_command, cancel},
      {tune_command, tune},
      {init_command, init},
      {completion_command, completion},
  };
  for (const auto& [command, options] : all)
    if (command->parsed()) return options;
  return plot;
}

namespace {

std::vector<std::string> names_of_commands(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(command->get_name());
  return names;
}

// A first word that is no command; CLI11 would miss one instead of naming it.
std::string unknown_command(const CLI::App& app, int argc, const char* const* argv) {
  if (argc < 2 || argv[1][0] == '-') return "";
  const std::string word = argv[1];
  const auto names = names_of_commands(app);
  if (std::find(names.begin(), names.end(), word) != names.end()) return "";
  return "no command " + in_quotes(word) + allowed_names(word, names);
}

// What a command was given and does not take.
std::string unexpected(const CLI::App& app) {
  const CLI::App* command = app.get_subcommands().front();
  const std::string word = app.remaining(true).front();
  std::string text = command->get_name() + ": " + in_quotes(word) + " was not expected";
  std::vector<std::string> options;
  std::string lists;
  for (const CLI::Option* option : command->get_options()) {
    for (const std::string& name : option->get_lnames()) options.push_back("--" + name);
    if (option->get_delimiter() != '\0' && option->count() > 0)
      lists += (lists.empty() ? "" : ", ") + option->get_name() + " a,b";
  }
  if (word.starts_with("-")) return text + allowed_names(word, options);
  return lists.empty() ? text : text + " (values are joined by commas: " + lists + ")";
}

std::string in_one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

}  // namespace

std::string completion_script(const std::string& shell) {
  CLI::App app("", "voronaut");
  const Commands commands(app);
  return completion_of(app, shell);
}

ParsedArguments parse_arguments(int argc, const char* const* argv, std::ostream& out,
                                std::ostream& err) {
  CLI::App app("Benchmarks for planners that discover the world while they move", "voronaut");
  app.set_version_flag("--version", version_line(), "Print the version and exit");
  app.footer(kOptionsFooter);
  app.require_subcommand(1);
  const Commands commands(app);
  for (CLI::App* command : app.get_subcommands({}))
    command->set_version_flag("--version", version_line(), "Print the version and exit");
  const auto refuse = [&err](const std::string& text) {
    err << "voronaut: " << in_one_line(text) << " (--help shows what is possible)\n";
    return ParsedArguments{std::nullopt, ExitCode::bad_input};
  };
  if (const std::string unknown = unknown_command(app, argc, argv); !unknown.empty())
    return refuse(unknown);
  try {
    app.parse(argc, argv);
    return {commands.chosen(), ExitCode::success};
  } catch (const CLI::Success& success) {  // help or version
    app.exit(success, out, err);
    return {std::nullopt, ExitCode::success};
  } catch (const CLI::ExtrasError&) {
    return refuse(unexpected(app));
  } catch (const CLI::ParseError& error) {
    return refuse(error.what());
  }
}

}  // namespace voronaut
