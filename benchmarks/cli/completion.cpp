#include "voronaut/benchmarks/cli/completion.h"

#include <algorithm>
#include <ostream>

#include "voronaut/benchmarks/cli/commands.h"
#include "voronaut/benchmarks/cli/option_lists.h"

namespace voronaut {

namespace {

struct CompletedOption {
  std::vector<std::string> names;    // "-o", "--output"
  std::vector<std::string> choices;  // of its value
  bool takes_value = false;
  std::string sentence;
};

struct CompletedCommand {
  std::string name;
  std::string summary;
  std::vector<CompletedOption> options;
  std::vector<std::string> choices;  // of its first word
  bool takes_suite = false;          // the name of one that ships
  bool takes_name = false;           // of what its first word stands for
};

// "TEXT:{a,b}" is what a type is called whose values are checked to be a or b.
std::vector<std::string> choices_of(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  const std::size_t begin = type.find('{');
  const std::size_t end = type.rfind('}');
  std::vector<std::string> names;
  if (begin == std::string::npos || end == std::string::npos) return names;
  for (const std::string& name : CLI::detail::split(type.substr(begin + 1, end - begin - 1), ','))
    names.push_back(name);
  return names;
}

CompletedOption completed(const CLI::Option& option) {
  CompletedOption result;
  for (const std::string& name : option.get_snames()) result.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) result.names.push_back("--" + name);
  result.choices = choices_of(option);
  result.takes_value = option.get_expected_max() > 0;
  result.sentence = option.get_description();
  return result;
}

std::vector<CompletedCommand> commands_of(const CLI::App& app) {
  std::vector<CompletedCommand> commands;
  for (const CLI::App* each : app.get_subcommands([](const CLI::App*) { return true; })) {
    CompletedCommand& command = commands.emplace_back();
    command.name = each->get_name();
    command.summary = each->get_description();
    for (const CLI::Option* option : each->get_options()) {
      const std::string positional = option->get_name(true, false);
      if (option->nonpositional()) {
        command.options.push_back(completed(*option));
        continue;
      }
      if (command.choices.empty()) command.choices = choices_of(*option);
      command.takes_suite |= positional == "SUITE" || positional == "FILE";
      command.takes_name |= positional == "NAME";
    }
  }
  return commands;
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

std::string option_names(const CompletedCommand& command) {
  std::string text;
  for (const CompletedOption& option : command.options)
    text += (text.empty() ? "" : " ") + joined(option.names);
  return text;
}

std::string command_names(const std::vector<CompletedCommand>& commands) {
  std::string text;
  for (const CompletedCommand& command : commands) text += command.name + " ";
  return text + "--help --version";
}

// "'report -f' | 'report --format') values='html md' ;;" for each option whose values are known.
std::string value_cases(const CompletedCommand& command) {
  std::string lines;
  for (const CompletedOption& option : command.options) {
    if (option.choices.empty()) continue;
    std::string pattern;
    for (const std::string& name : option.names)
      pattern += (pattern.empty() ? "'" : " | '") + command.name + " " + name + "'";
    lines += "    " + pattern + ") values='" + joined(option.choices) + "' ;;\n";
  }
  return lines;
}

// What words a command takes that are no files.
std::string name_case(const CompletedCommand& command) {
  const std::string known = "names='" + joined(command.choices) + "'";
  const auto asked = [](const std::string& what) {
    return "names=$(voronaut list " + what + " 2>/dev/null | cut -d ' ' -f 1)";
  };
  std::string words;
  if (command.takes_name)
    words = "[ \"$nth\" -eq 2 ] && " + known + " || " + asked("\"$first\"");
  else if (!command.choices.empty())
    words = known;
  else if (command.takes_suite)
    words = asked("suites");
  return words.empty() ? "" : "    " + command.name + ") " + words + " ;;\n";
}

// What may come next, as bash and zsh both read it: in `switches` the options of the command, in
// `values` what the option before takes, in `names` what else may stand here.
std::string cases(const std::vector<CompletedCommand>& commands) {
  std::string options, values, names;
  for (const CompletedCommand& command : commands) {
    options += "    " + command.name + ") switches='" + option_names(command) + "' ;;\n";
    values += value_cases(command);
    names += name_case(command);
  }
  return "  case $command in\n" + options + "  esac\n  case \"$command $previous\" in\n" + values +
         "  esac\n  case $command in\n" + names + "  esac\n";
}

std::string bash(const std::vector<CompletedCommand>& commands) {
  return "# Completes voronaut's commands in bash; `voronaut completion bash` prints it.\n"
         "_voronaut() {\n"
         "  local word=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]}\n"
         "  local command=${COMP_WORDS[1]} first=${COMP_WORDS[2]} nth=$COMP_CWORD\n"
         "  local switches= values= names=\n"
         "  COMPREPLY=()\n"
         "  if [ \"$nth\" -eq 1 ]; then\n"
         "    COMPREPLY=($(compgen -W '" +
         command_names(commands) +
         "' -- \"$word\"))\n"
         "    return\n"
         "  fi\n" +
         cases(commands) +
         "  if [ -n \"$values\" ]; then\n"
         "    COMPREPLY=($(compgen -W \"$values\" -- \"$word\"))\n"
         "  elif [[ $word == -* ]]; then\n"
         "    COMPREPLY=($(compgen -W \"$switches\" -- \"$word\"))\n"
         "  else\n"
         "    [[ $previous == -* ]] && names=\n"
         "    COMPREPLY=($(compgen -W \"$names\" -- \"$word\") $(compgen -f -- \"$word\"))\n"
         "  fi\n"
         "}\n"
         "complete -o filenames -F _voronaut voronaut\n";
}

std::string zsh(const std::vector<CompletedCommand>& commands) {
  return "#compdef voronaut\n"
         "# Completes voronaut's commands in zsh; `voronaut completion zsh` prints it.\n"
         "_voronaut() {\n"
         "  local word=$words[CURRENT] previous=$words[CURRENT-1]\n"
         "  local command=$words[2] first=$words[3] nth=$((CURRENT - 1))\n"
         "  local switches= values= names=\n"
         "  if [ \"$nth\" -eq 1 ]; then\n"
         "    compadd -- " +
         command_names(commands) +
         "\n"
         "    return\n"
         "  fi\n" +
         cases(commands) +
         "  if [ -n \"$values\" ]; then\n"
         "    compadd -- ${=values}\n"
         "  elif [[ $word == -* ]]; then\n"
         "    compadd -- ${=switches}\n"
         "  else\n"
         "    [[ $previous == -* ]] || compadd -- ${=names}\n"
         "    _files\n"
         "  fi\n"
         "}\n"
         "if [ \"$funcstack[1]\" = _voronaut ]; then _voronaut \"$@\"; else compdef _voronaut "
         "voronaut; fi\n";
}

// In quotes of fish, where only ' and \ are special.
std::string fish_text(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) {
    if (c == '\'' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + "'";
}

std::string fish_option(const CompletedOption& option) {
  std::string line;
  for (const std::string& name : option.names)
    line += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  if (option.takes_value) line += option.choices.empty() ? " -r" : " -x";
  if (!option.choices.empty()) line += " -a " + fish_text(joined(option.choices));
  return line + " -d " + fish_text(option.sentence) + "\n";
}

std::string fish(const std::vector<CompletedCommand>& commands) {
  std::string text =
      "# Completes voronaut's commands in fish; `voronaut completion fish` prints it.\n";
  for (const CompletedCommand& command : commands) {
    text += "complete -c voronaut -f -n __fish_use_subcommand -a " + command.name + " -d " +
            fish_text(command.summary) + "\n";
    const std::string within =
        "complete -c voronaut -n '__fish_seen_subcommand_from " + command.name + "'";
    for (const CompletedOption& option : command.options) text += within + fish_option(option);
    if (!command.choices.empty())
      text += within + " -a " + fish_text(joined(command.choices)) + "\n";
    else if (command.takes_suite)
      text += within + " -a '(voronaut list suites 2>/dev/null | cut -d \" \" -f 1)'\n";
  }
  return text;
}

}  // namespace

const std::vector<std::string>& completed_shells() {
  static const std::vector<std::string> shells = {"bash", "zsh", "fish"};
  return shells;
}

std::string completion_of(const CLI::App& app, const std::string& shell) {
  const auto commands = commands_of(app);
  if (shell == "bash") return bash(commands);
  return shell == "zsh" ? zsh(commands) : fish(commands);
}

ExitCode execute(const CompletionOptions& options, const CommandContext& context) {
  context.out << completion_script(options.shell);
  return ExitCode::success;
}

}  // namespace voronaut
