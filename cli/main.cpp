// SPDX-License-Identifier: Apache-2.0
// The command line: which commands and options there are, and what the help says about them.
#include <algorithm>
#include <csignal>
#include <deque>
#include <new>
#include <span>

#include <orispline/base/formatted.hpp>
#include <orispline/base/version.hpp>
#include <orispline/batch/kernel/dispatch.hpp>
#include <orispline/scenes/scene_tracks.hpp>

#include "commands/completion/completion.hpp"
#include "commands/convert/convert_options.hpp"
#include "commands/help/help.hpp"
#include "commands/methods/methods.hpp"
#include "commands/plot/plot_options.hpp"
#include "commands/sample/sample_options.hpp"
#include "commands/studio/studio_options.hpp"
#include "commands/task_command.hpp"
#include "commands/tasks/tasks.hpp"
#include "options/first_word.hpp"
#include "options/method_options.hpp"
#include "output/exit_code.hpp"
#include "output/standard_output.hpp"
#include "papers/reproduce.hpp"

namespace orispline::cli { namespace {

constexpr auto app_examples = R"(Examples:
  orispline sample keys.csv --rate 100 -o motion.csv
  orispline convert keys.csv -o keys.tum
  orispline inspect keys.csv --method auto,quintic
  orispline compare flight.csv --keep-every 8
  orispline reduce flight.csv --tolerance 0.1deg -o keys.csv
  orispline studio keys.csv
  orispline methods)";

constexpr auto methods_footer = R"(Examples:
  orispline methods
  orispline methods timed-c2
  orispline methods --json)";

constexpr auto tasks_footer = R"(Examples:
  orispline tasks
  orispline tasks --json)";

constexpr auto reproduce_footer = R"(Examples:
  orispline reproduce
  orispline reproduce 000-table1
  orispline reproduce tan-table1 --keys keys.csv
  orispline reproduce 003 --keys keys.csv --reference flight.csv
  orispline reproduce 003 --pictures pictures
  orispline reproduce all --output-folder papers
  orispline reproduce 003-table1 --report flight.html

Name a paper by its number or its author: 000 or tan is Tan et al. 2018, 001 or he is He et al. 2022, 002 or eberly is
Eberly, and 003 or sextic is the paper on the 6th degree, whose authors our copy does not name.)";

constexpr auto completion_footer = R"(Examples:
  source <(orispline completion bash)
  orispline completion zsh > "${fpath[1]}/_orispline"
  orispline completion fish > ~/.config/fish/completions/orispline.fish)";

constexpr auto help_footer = R"(Examples:
  orispline help
  orispline help sample
  orispline help sample --all
  orispline help --manual-pages man/man1)";

Program program() {
  return {.name = "orispline",
          .description = "Smooth orientation curves through keyframes.",
          .footer = formatted("{}\n\n{}", app_examples, exit_codes()),
          .version = formatted("orispline {}", version)};
}

/// The words that the registry has for an argument of that type, or the names of the commands.
std::vector<std::string> registered_words(std::string_view type, const std::deque<Command>& commands) {
  if (type == setting_type) return known_settings();
  if (type == ends_type) return known_end_rules();
  if (type != method_type && type != methods_type && type != command_type) return {};
  std::vector<std::string> names;
  if (type == command_type)
    for (const Command& command : commands) names.push_back(command.name);
  else
    for (const FamilyInfo& family : families_info()) names.emplace_back(family.name);
  return names;
}

/// What a shell is told about an option; choices stand in the type name.
OptionOutline outline(const Option& option, const std::deque<Command>& commands) {
  OptionOutline result{.names = {}, .description = option.sentence};
  for (const std::string_view name : pieces_of(option.names, ',')) result.names.emplace_back(name);
  const std::string& type = option.argument;
  if (option.is_flag()) return result;
  result.argument = type == file_type || type == folder_type ? Argument::file : Argument::word;
  result.choices = registered_words(type, commands);
  if (!result.choices.empty()) result.argument = type == setting_type ? Argument::setting : Argument::choice;
  if (type.find('|') == std::string::npos || type.find(',') != std::string::npos) return result;
  result.argument = Argument::choice;
  for (const std::string_view choice : pieces_of(type, '|')) result.choices.emplace_back(choice);
  return result;
}

std::vector<CommandOutline> outlines(const std::deque<Command>& commands) {
  std::vector<CommandOutline> outlines;
  for (const Command& command : commands) {
    CommandOutline& result = outlines.emplace_back(CommandOutline{command.name, command.description, {}});
    result.options.push_back({.names = {"-h", "--help"}, .description = "Print this help message and exit"});
    for (const Option& option : command.options) result.options.push_back(outline(option, commands));
  }
  return outlines;
}

/// For somebody who has typed the name of the command and no more.
constexpr auto first_steps = R"(orispline makes smooth motions from orientation keyframes. To begin with:
  orispline sample keys.csv --rate 100 -o motion.csv   a motion through the keys, with exact rates
  orispline inspect keys.csv --method auto             what the keys are like, and where rates jump
  orispline compare flight.csv --keep-every 8          which method follows a recording best
  orispline convert keys.csv -o keys.tum               the same keys in another format
  orispline methods                                    all methods, what they promise and take
keys.csv has the columns t,qw,qx,qy,qz. 'orispline help' and 'orispline help sample' say more.
)";

/// `orispline compare keys.csv …`, as a shell takes it.
std::string command_line(std::span<char*> arguments) {
  std::string line = "orispline";
  for (const std::string_view argument : arguments) {
    const bool plain = !argument.empty() && argument.find_first_of(" \t\n'\"\\$&|;<>()*?[]#~`!{}") == argument.npos;
    line += plain ? formatted(" {}", argument) : formatted(" {}", shell_word(argument));
  }
  return line;
}

/// Defines the commands; each stands for a function to call when it was chosen.
class CommandLine {
 public:
  CommandLine() {
    scenes::join_formats();
    add_sample_options(
        command("sample", "Sample the smooth motion through keyframes", [this] { return sample(sample_); }), sample_);
    add_convert_options(command("convert", "Write keyframes in another format", [this] { return convert(convert_); }),
                        convert_);
    add("inspect");
    add("difference");
    add("compare");
    add("align");
    add_plot_options(command("plot", "Draw the motion by one or more methods as SVG", [this] { return plot(plot_); }),
                     plot_);
    add_studio_options(command("studio", "Make a page on which keyframes are edited with the mouse",
                               [this] { return studio(studio_); }),
                       studio_);
    add("clip");
    add("smooth");
    add("mean");
    add("tune");
    add("reduce");
    add("retime");
    add("bake");
    add_methods_options(command("methods", "List the methods, or describe one", [this] { return methods(methods_); }));
    add_tasks_options(command("tasks", "List the options and results of every task", [this] { return tasks(tasks_); }));
    add_reproduce_options(
        command("reproduce", "Run the experiments of the papers anew", [this] { return reproduce(reproduce_); }));
    add_completion_options(command("completion", "Print a completion script for a shell",
                                   [this] { return completion(shell_, outlines(commands_)); }));
    add_help_options(command(std::string(help_command), "Print the help of a command",
                             [this] { return help(help_, program(), commands_); }));
  }

  [[nodiscard]] ExitCode run(int argc, char** argv) {
    try {
      const std::span arguments(argv, static_cast<std::size_t>(argc));
      if (arguments.size() < 2) return tell(first_steps), ExitCode::bad_usage;
      reproduce_.report.command_line = command_line(arguments.subspan(1));
      for (TaskArguments& task : task_arguments_) task.report.command_line = reproduce_.report.command_line;
      const auto words = arguments.subspan(1);
      const auto done =
          understood_words(commands_, {words.begin(), words.end()})
              .and_then(
                  [&](const std::vector<std::string>& understood) { return parsed(commands_, program(), understood); })
              .and_then([](const Wanted& user) {
                if (!user.command) return print_document(user.text);
                return batch::forced_kernels().and_then([&](const batch::Kernels*) { return user.command->run(); });
              });
      return done ? ExitCode::success : report(done.error());
    } catch (const std::bad_alloc&) {
      return report({ErrorCode::bad_access, "out of memory", {}});
    }
  }

 private:
  Command& command(std::string name, std::string description, std::function<Expected<void>()> run) {
    return commands_.emplace_back(
        Command{.name = std::move(name), .description = std::move(description), .run = std::move(run)});
  }

  /// A command that runs a task.
  void add(std::string_view name) {
    const TaskCommand& row = task_command(name);
    TaskArguments& arguments = task_arguments_.emplace_back();
    row.add_options(command(std::string(name), std::string(row.sentence), [&] { return row.run(arguments); }),
                    arguments);
  }

  void add_methods_options(Command& app) {
    app.footer = methods_footer;
    app.add_option("METHOD", methods_.name, "Method to describe [list them all]")->type_name(method_type);
    add_blending_option(app, methods_.blending);
    app.add_flag("--json", methods_.json, "Print one JSON array");
  }

  void add_tasks_options(Command& app) {
    app.footer = tasks_footer;
    app.add_flag("--json", tasks_.json, "Print one JSON array");
  }

  void add_reproduce_options(Command& app) {
    app.footer = reproduce_footer;
    app.add_option("EXPERIMENT", reproduce_.experiment,
                   "Experiment to run: a name of the list, a paper's number or author, or 'all' [list them all]")
        ->type_name("NAME");
    app.add_option("--keys", reproduce_.keys,
                   "Run the experiment on the keys of this file; the list says which ones take keys")
        ->type_name(file_type);
    app.add_option("--reference", reproduce_.reference,
                   "Take this recording for the true motion of those keys; the list says which ones want it")
        ->type_name(file_type);
    app.add_option("--output-folder", reproduce_.folder,
                   "Write the tables of each experiment into this folder, as text and with all curves as JSON, and its "
                   "pictures as SVG")
        ->type_name(folder_type);
    app.add_option("--pictures", reproduce_.pictures, "Write the pictures as SVG into this folder")
        ->type_name(folder_type);
    app.add_option("--report", reproduce_.report.path, "Write a page to look at in a browser: the motions in space")
        ->type_name(file_type);
    app.add_flag("--json", reproduce_.json, "Print one JSON array");
  }

  void add_completion_options(Command& app) {
    app.footer = completion_footer;
    app.add_option("SHELL", shell_, "Shell that the script is for")->required()->type_name(one_of(shell_choices));
  }

  void add_help_options(Command& app) {
    app.footer = help_footer;
    app.add_option(command_type, help_.command, "Command to explain [list them all]")->type_name(command_type);
    app.add_option("--manual-pages", help_.manual_pages,
                   "Write the manual pages of all commands, for man, into this folder")
        ->type_name(folder_type);
  }

  std::deque<Command> commands_;
  std::deque<TaskArguments> task_arguments_;
  SampleArguments sample_;
  ConvertArguments convert_;
  PlotArguments plot_;
  StudioArguments studio_;
  MethodsArguments methods_;
  TasksArguments tasks_;
  ReproduceArguments reproduce_;
  std::string shell_;
  HelpArguments help_;
};

}}  // namespace orispline::cli

int main(int argc, char** argv) {
  std::signal(SIGPIPE, SIG_DFL);  // a reader that has seen enough ends the command without a word
#ifdef SIGXFSZ
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is an error of writing, as a full disk is
#endif
  return static_cast<int>(orispline::cli::CommandLine().run(argc, argv));
}
