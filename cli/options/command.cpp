// SPDX-License-Identifier: Apache-2.0
#include "options/command.hpp"

#include <CLI/CLI.hpp>

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

void define(CLI::App& app, const Command& command, const Command*& chosen) {
  app.footer(command.footer);
  app.final_callback([&chosen, &command] { chosen = &command; });
  for (const Option& option : command.options) {
    CLI::Option& defined = *std::visit(Definition{app, option}, option.typed);
    if (!option.section.empty()) defined.group(option.section);
    if (!option.is_flag()) defined.type_name(option.argument);
    if (option.is_required) defined.required();
    if (option.is_repeated) defined.allow_extra_args(false);
  }
}

}  // namespace

Expected<const Command*> parsed(const std::deque<Command>& commands, const Program& program, int argc, char** argv) {
  CLI::App app(program.description);
  app.name(program.name);
  app.footer(program.footer);
  app.require_subcommand(1);
  app.set_version_flag("--version", program.version);
  const Command* chosen = nullptr;
  for (const Command& command : commands)
    define(*app.add_subcommand(command.name, command.description), command, chosen);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0) return failure(ErrorCode::bad_argument, error.what());
    app.exit(error);  // the help or the version that was asked for
    return nullptr;
  }
  return chosen;
}

}  // namespace orispline::cli
