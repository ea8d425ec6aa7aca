// SPDX-License-Identifier: Apache-2.0
#include "commands/completion/completion.hpp"

#include <algorithm>

#include "output/standard_output.hpp"

#include <orispline/base/formatted.hpp>

namespace orispline::cli {

namespace {

using Commands = std::vector<CommandOutline>;

bool is_positional(const OptionOutline& option) { return !option.names.front().starts_with('-'); }

std::string words_of_commands(const Commands& commands) {
  std::vector<std::string_view> names;
  for (const CommandOutline& command : commands) names.push_back(command.name);
  return joined(names, " ");
}

// bash: the word before the cursor decides, then the command.

/// `NAME=WORD` is one word of the line, but two for readline, which wants what follows the `=` only.
std::string bash_settings(const OptionOutline& option) {
  return formatted(
      "      if [[ $line =~ \\ {}\\ +[^\\ ]*$ ]]; then\n"
      "        COMPREPLY=($(compgen -W '{}' -- \"$token\"))\n"
      "        COMPREPLY=(\"${{COMPREPLY[@]#\"${{token%\"${{token##*=}}\"}}\"}}\")\n"
      "        compopt +o filenames 2>/dev/null\n"
      "        [[ ${{COMPREPLY[*]}} == *= ]] && compopt -o nospace 2>/dev/null\n"
      "        return\n"
      "      fi\n",
      option.names.front(), joined(option.choices, " "));
}

std::string bash_command(const CommandOutline& command) {
  std::string values, words, settings;
  for (const OptionOutline& option : command.options) {
    if (is_positional(option)) {
      if (option.argument == Argument::choice) words += formatted(" {}", joined(option.choices, " "));
      continue;
    }
    words += formatted(" {}", joined(option.names, " "));
    const std::string names = joined(option.names, "|");
    if (option.argument == Argument::choice)
      values += formatted("        {}) COMPREPLY=($(compgen -W '{}' -- \"$word\")); return ;;\n", names,
                          joined(option.choices, " "));
    else if (option.argument == Argument::setting) settings = bash_settings(option);
    else if (option.argument == Argument::file)
      values += formatted("        {}) COMPREPLY=($(compgen -f -- \"$word\")); return ;;\n", names);
    else if (option.argument == Argument::word) values += formatted("        {}) return ;;\n", names);
  }
  return formatted("    {})\n{}      case $previous in\n{}      esac\n      words='{}'\n      ;;\n", command.name,
                   settings, values.empty() ? "        *) ;;\n" : values, words.empty() ? "" : words.substr(1));
}

std::string bash_script(const Commands& commands) {
  std::string cases;
  for (const CommandOutline& command : commands) cases += bash_command(command);
  return formatted(
      "# bash completion of orispline: source <(orispline completion bash)\n"
      "_orispline() {{\n"
      "  local word=${{COMP_WORDS[COMP_CWORD]}} previous=${{COMP_WORDS[COMP_CWORD-1]}} words\n"
      "  local line=${{COMP_LINE:0:COMP_POINT}}; local token=${{line##* }}\n"
      "  if [ \"$COMP_CWORD\" -eq 1 ]; then\n"
      "    COMPREPLY=($(compgen -W '{} --help --version' -- \"$word\"))\n"
      "    return\n"
      "  fi\n"
      "  case ${{COMP_WORDS[1]}} in\n{}"
      "  esac\n"
      "  COMPREPLY=($(compgen -W \"$words\" -- \"$word\"))\n"
      "  case $word in -*) ;; *) COMPREPLY+=($(compgen -f -- \"$word\")) ;; esac\n"
      "}}\n"
      "complete -o filenames -F _orispline orispline\n",
      words_of_commands(commands), cases);
}

// zsh: one _arguments specification per option.

std::string zsh_text(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '[' || c == ']' || c == ':' || c == '\\') escaped += '\\';
    escaped += c;
  }
  return escaped;
}

std::string zsh_action(const OptionOutline& option) {
  switch (option.argument) {
    case Argument::none:
      return "";
    case Argument::word:
      return ":value: ";
    case Argument::choice:
    case Argument::setting:
      return formatted(":value:({})", joined(option.choices, " "));
    case Argument::file:
      return ":file:_files";
  }
  return "";
}

std::string zsh_command(const CommandOutline& command) {
  std::string text = formatted("    {}) _arguments", command.name);
  for (const OptionOutline& option : command.options) {
    if (is_positional(option)) {
      text += " " + shell_word(":" + zsh_action(option).substr(1));
      continue;
    }
    for (const std::string& name : option.names)
      text +=
          " \\\n      " + shell_word(formatted("*{}[{}]{}", name, zsh_text(option.description), zsh_action(option)));
  }
  return text + " ;;\n";
}

std::string zsh_script(const Commands& commands) {
  std::string cases, list;
  for (const CommandOutline& command : commands) {
    cases += zsh_command(command);
    list += " " + shell_word(command.name + ":" + command.description);
  }
  return formatted(
      "#compdef orispline\n"
      "# zsh completion of orispline: orispline completion zsh > \"${{fpath[1]}}/_orispline\"\n"
      "_orispline() {{\n"
      "  if (( CURRENT == 2 )); then\n"
      "    local -a commands=({} )\n"
      "    _describe command commands\n"
      "    return\n"
      "  fi\n"
      "  local command=$words[2]\n"
      "  shift words; (( CURRENT-- ))\n"
      "  case $command in\n{}"
      "  esac\n"
      "}}\n"
      "_orispline \"$@\"\n",
      list, cases);
}

// fish: one line per option, with its command as the condition.

std::string fish_option(const CommandOutline& command, const OptionOutline& option) {
  std::string line = formatted("complete -c orispline -n '__fish_seen_subcommand_from {}'", command.name);
  if (!is_positional(option))
    for (const std::string& name : option.names)
      line += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  if (option.argument == Argument::word) line += " -x";
  if (option.argument == Argument::file) line += " -rF";
  if (option.argument == Argument::choice || option.argument == Argument::setting)
    line += formatted("{} -a '{}'", is_positional(option) ? " -f" : " -x", joined(option.choices, " "));
  return line + " -d " + shell_word(option.description) + "\n";
}

std::string fish_script(const Commands& commands) {
  std::string text = "# fish completion of orispline: orispline completion fish | source\n";
  for (const CommandOutline& command : commands)
    text += formatted("complete -c orispline -n __fish_use_subcommand -f -a {} -d {}\n", command.name,
                      shell_word(command.description));
  for (const CommandOutline& command : commands)
    for (const OptionOutline& option : command.options) text += fish_option(command, option);
  return text;
}

}  // namespace

std::string shell_word(std::string_view text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

Expected<void> completion(const std::string& shell, const Commands& commands) {
  return choice_of(shell_choices)({"completion", shell}).and_then([&](Shell choice) {
    switch (choice) {
      case Shell::zsh:
        return print_document(zsh_script(commands));
      case Shell::fish:
        return print_document(fish_script(commands));
      default:
        return print_document(bash_script(commands));
    }
  });
}

}  // namespace orispline::cli
