// SPDX-License-Identifier: Apache-2.0
#include "options/command.hpp"

#include <array>
#include <sstream>

#include <CLI/CLI.hpp>

#include <orispline/base/formatted.hpp>
#include <orispline/base/pieces.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/base/suggestion.hpp>

namespace orispline::cli {

namespace {

/// Defines an option in the terms of CLI11.
struct Definition {
  CLI::App& app;
  const Option& option;

  CLI::Option* operator()(bool* typed) const { return app.add_flag(option.names, *typed, option.sentence); }
  CLI::Option* operator()(std::optional<std::string>* typed) const {
    if (!option.is_flag()) return app.add_option(option.names, *typed, option.sentence);
    return app.add_flag_callback(
        option.names, [typed, text = option.stands_for] { *typed = text; }, option.sentence);
  }
  template <class T>
  CLI::Option* operator()(T* typed) const {
    return app.add_option(option.names, *typed, option.sentence);
  }
};

/// Which options the help shows.
enum class Shown { usual, all };

/// Whether most people use it: by its name, or in every command.
bool is_usual(const Command& command, const Option& option) {
  constexpr std::array everywhere{"INPUT",    "-o,--output", "--output-folder", "--columns",
                                  "--method", "--tension",   "--json",          "--report"};
  return command.usual.empty() || option.is_required ||
         std::ranges::find(everywhere, option.names) != everywhere.end() ||
         std::ranges::find(command.usual, option.names) != command.usual.end();
}

/// Behind the options: how to see the others, and what the command says.
std::string footer_of(const Command& command, Shown shown) {
  const auto hidden =
      std::ranges::count_if(command.options, [&](const Option& option) { return !is_usual(command, option); });
  if (shown == Shown::all || hidden == 0) return command.footer;
  return formatted("'orispline help {} {}' shows {} more options.\n\n{}", command.name, all_options, hidden,
                   command.footer);
}

void define(CLI::App& app, const Command& command, Shown shown, const Command*& chosen) {
  app.footer(footer_of(command, shown));
  app.final_callback([&chosen, &command] { chosen = &command; });
  for (const Option& option : command.options) {
    CLI::Option& defined = *std::visit(Definition{app, option}, option.typed);
    if (shown == Shown::usual && !is_usual(command, option)) defined.group("");  // which is not shown
    else if (!option.section.empty()) defined.group(option.section);
    if (!option.is_flag()) defined.type_name(option.argument);
    if (option.is_required) defined.required();
    if (option.is_repeated) defined.allow_extra_args(false);
  }
}

// What CLI11 finds wrong, in the words of the other messages.

/// The names of the options that begin with dashes.
std::vector<std::string_view> flags_of(const Command& command) {
  std::vector<std::string_view> flags{"--help"};
  for (const Option& option : command.options)
    for (const std::string_view name : pieces_of(option.names, ','))
      if (name.starts_with("--")) flags.push_back(name);
  return flags;
}

std::string unexpected(const Command& command, std::string_view word) {
  if (!word.starts_with('-'))
    return formatted("{}: found {}, wanted no more words here; 'orispline help {}' lists the options", command.name,
                     in_quotes(word), command.name);
  const std::string_view flag = word.substr(0, word.find('='));
  const auto flags = flags_of(command);
  if (const auto nearest = nearest_word(flag, flags))
    return formatted("{}: unknown option {}; did you mean '{}'?", command.name, in_quotes(flag), *nearest);
  return formatted("{}: unknown option {}; 'orispline help {}' lists them", command.name, in_quotes(flag),
                   command.name);
}

std::string unmatched(const Command& command, std::string_view message) {
  const std::string_view name = message.substr(0, message.find(':'));
  const Option* const option = command.find(name);
  if (message.find("At Most") != message.npos) return formatted("{}: found it more than once, wanted it once", name);
  if (option && !option->argument.empty())
    return formatted("{}: found nothing after it, wanted {}", name, option->argument);
  return std::string(message);
}

std::string missing(const Command& command, std::string_view message) {
  return formatted("{}: {} is missing; 'orispline help {}' shows what to type", command.name,
                   message.substr(0, message.find(' ')), command.name);
}

/// What CLI11 found wrong, in one line.
std::string parse_message(const CLI::ParseError& error, const CLI::App& app, const std::deque<Command>& commands) {
  const auto named = app.get_subcommands();
  const auto command = std::ranges::find_if(
      commands, [&](const Command& known) { return !named.empty() && known.name == named.front()->get_name(); });
  const std::string_view message = error.what();
  if (command != commands.end()) {
    const std::vector<std::string> extras = app.remaining(true);
    const auto option = std::ranges::find_if(extras, [](const std::string& word) { return word.starts_with('-'); });
    if (dynamic_cast<const CLI::ExtrasError*>(&error) && !extras.empty())
      return unexpected(*command, option == extras.end() ? extras.front() : *option);
    if (dynamic_cast<const CLI::ArgumentMismatch*>(&error)) return unmatched(*command, message);
    if (dynamic_cast<const CLI::RequiredError*>(&error)) return missing(*command, message);
  }
  return printable(message);
}

}  // namespace

const Option* Command::find(std::string_view typed) const {
  for (const Option& option : options)
    for (const std::string_view other : pieces_of(option.names, ','))
      if (other == typed) return &option;
  return nullptr;
}

Expected<Wanted> parsed(const std::deque<Command>& commands, const Program& program, std::vector<std::string> words) {
  CLI::App app(program.description);
  app.name(program.name);
  app.footer(program.footer);
  app.require_subcommand(1);
  app.set_version_flag("--version", program.version);
  const bool asks_for_help =
      std::ranges::any_of(words, [](std::string_view word) { return word == "--help" || word == "-h"; });
  const bool asks_for_all = asks_for_help && std::erase(words, all_options) > 0;
  const Command* chosen = nullptr;
  for (const Command& command : commands)
    define(*app.add_subcommand(command.name, command.description), command,
           asks_for_help && !asks_for_all ? Shown::usual : Shown::all, chosen);
  try {
    std::ranges::reverse(words);  // as CLI11 takes them
    app.parse(std::move(words));
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0) return failure(ErrorCode::bad_argument, parse_message(error, app, commands));
    std::ostringstream asked_for;
    app.exit(error, asked_for, asked_for);
    return Wanted{.text = asked_for.str()};
  }
  return Wanted{.command = chosen};
}

}  // namespace orispline::cli
