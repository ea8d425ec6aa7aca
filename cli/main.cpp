// SPDX-License-Identifier: Apache-2.0
// The command line: which commands and options there are, and what the help says about them.
#include <csignal>
#include <new>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include <orispline/base/version.hpp>

#include "completion.hpp"
#include "exit_code.hpp"
#include "inspect.hpp"
#include "methods.hpp"
#include "sample.hpp"

#include <algorithm>
#include <csignal>
#include <new>
#include <span>

namespace orispline::cli {
namespace {

constexpr auto file_type = "FILE";

constexpr auto app_footer = R"(Examples:
  orispline sample keys.csv --rate 100 -o motion.csv
  orispline inspect keys.csv --method timed-c2,quintic
  orispline methods

Exit codes: 0 success, 1 bad data, 2 bad usage, 3 file missing, unreadable or not writable.)";

constexpr auto sample_footer = R"(Examples:
  orispline sample keys.csv --rate 100 -o motion.csv
  orispline sample keys.csv --method quintic --tension=0.4 --ends natural --count 500 | head
  orispline sample flight.csv --start-rate=0,0,0.5 --set tension=0.4,0.5,0.6 --times frames.csv -o motion.csv
  orispline sample trajectory.tum --drop-duplicates --rate 200 -o smooth.tum
  orispline sample ck.csv --columns t=sclk,qw=q0,qx=q1,qy=q2,qz=q3 --conjugate --rate 10 --frame world

INPUT has the columns t,qw,qx,qy,qz and optionally px,py,pz and one column per parameter of the method (a value per
key); a parameter on the command line wins over its column. '-' is standard input or output.
Columns out: t,qw,qx,qy,qz[,px,py,pz][,wx,wy,wz[,ax,ay,az[,jx,jy,jz]]] in s, m, rad/s, rad/s^2, rad/s^3; body frame.
A TUM file always has positions: zeros when the keys have none.
Without -o the samples go to standard output as CSV; summaries and warnings go to standard error.)";

constexpr auto inspect_footer = R"(Examples:
  orispline inspect keys.csv
  orispline inspect keys.csv --method timed-c2,quintic --method slerp
  orispline inspect keys.csv --method sextic --json

Faults that 'sample' refuses (duplicate or decreasing times, rows that are not numbers, norms far from 1) are repaired
and counted. The JSON is described in docs/inspect-json.md.)";

constexpr auto methods_footer = R"(Examples:
  orispline methods
  orispline methods --json)";

constexpr auto completion_footer = R"(Examples:
  source <(orispline completion bash)
  orispline completion zsh > "${fpath[1]}/_orispline"
  orispline completion fish > ~/.config/fish/completions/orispline.fish)";

std::string method_names() {
  std::vector<std::string_view> names;
  for (const FamilyInfo& family : families_info()) names.push_back(family.name);
  return fmt::format("{}", fmt::join(names, "|"));
}

void add_input_options(CLI::App& app, InputOptions& o) {
  app.add_option("INPUT", o.path, "CSV or TUM file of keyframes; '-' is standard input")
      ->required()
      ->type_name(file_type);
  const std::string group = "Reading";
  app.add_option("--input-format", o.format, "Format of INPUT [by extension, then by content]")
      ->type_name(one_of(format_choices))
      ->group(group);
  app.add_option("--columns", o.columns, "Other names of columns: t=sclk_ticks,qw=q0_w,...")
      ->allow_extra_args(false)
      ->type_name("NAME=COLUMN,...")
      ->group(group);
  app.add_option("--order", o.order, "Order of the quaternion columns when there is no header")
      ->type_name(one_of(order_choices))
      ->group(group);
  app.add_option("--time-scale", o.time_scale, "Seconds per unit of the time column [1]")->type_name("X")->group(group);
  app.add_flag("--conjugate", o.conjugate, "The file holds world to body (SPICE, CCSDS)")->group(group);
  app.add_option("--signs", o.signs, "Negate quaternions for the shortest way, or take their signs [shortest]")
      ->type_name(one_of(sign_choices))
      ->group(group);
  app.add_flag("--drop-duplicates", o.drop_duplicates, "Of equal times keep the first row")->group(group);
  app.add_flag("--drop-invalid", o.drop_invalid, "Drop rows with NaN, infinite or empty cells")->group(group);
  app.add_flag("--sort", o.sort, "Sort the rows by time")->group(group);
}

void add_method_options(CLI::App& app, MethodOptions& o) {
  const std::string group = "Shape of the curve";
  app.add_option("--tension", o.tension, "Short for --set tension=X[,X...]")->type_name("X[,X...]")->group(group);
  app.add_option("--set", o.settings, "A parameter: one value, or exactly one per key; repeatable")
      ->allow_extra_args(false)
      ->type_name("NAME=X[,X...]")
      ->group(group);
  app.add_option("--ends", o.ends, "End rule for both ends, or for each; see 'orispline methods'")
      ->type_name("RULE|START,END")
      ->group(group);
  app.add_option("--start-rate", o.start_rate, "Body rate at the first key [rad/s]; means --ends clamped there")
      ->type_name("WX,WY,WZ")
      ->group(group);
  app.add_option("--end-rate", o.end_rate, "Body rate at the last key [rad/s]; means --ends clamped there")
      ->type_name("WX,WY,WZ")
      ->group(group);
}

void add_time_options(CLI::App& app, TimeOptions& o) {
  const std::string group = "Times (one of --rate, --count, --times)";
  app.add_option("--rate", o.rate, "Samples per second, from the start up to the end")->type_name("HZ")->group(group);
  app.add_option("--count", o.count, "Number of samples, both ends included")->type_name("N")->group(group);
  app.add_option("--times", o.list, "File with one time a line, in any order")->type_name(file_type)->group(group);
  app.add_option("--from", o.from, "Start, in the time of INPUT [first key]")->type_name("T")->group(group);
  app.add_option("--to", o.to, "End, in the time of INPUT [last key]")->type_name("T")->group(group);
}

void add_sample_options(CLI::App& app, SampleOptions& o) {
  add_input_options(app, o.input);
  app.add_option("--method", o.method, fmt::format("Method [{}]; see 'orispline methods'", default_method))
      ->type_name(method_names())
      ->group("Shape of the curve");
  add_method_options(app, o.shape);
  add_time_options(app, o.times);
  app.add_option("--extrapolate", o.extrapolate, "Outside the keys hold the end orientation, or fail [hold]")
      ->type_name(one_of(extrapolation_choices))
      ->group("Times (one of --rate, --count, --times)");
  const std::string group = "Output";
  app.add_option("-o,--output", o.output, "File to write, complete or not at all [standard output]")
      ->type_name(file_type)
      ->group(group);
  app.add_option("--output-format", o.output_format, "Format of the output [tum for .tum, else csv]")
      ->type_name(one_of(format_choices))
      ->group(group);
  app.add_option("--derivatives", o.derivatives, "Highest order of the rates [2 for CSV, 0 for TUM]")
      ->type_name("0|1|2|3")
      ->group(group);
  app.add_option("--frame", o.frame, "Frame of the rates [body]")->type_name(one_of(frame_choices))->group(group);
  app.add_option("--truth", o.truth, "Key file that the curve is compared with, in the summary")
      ->type_name(file_type)
      ->group(group);
  app.add_flag("--json", o.json, "Print the summary as JSON on standard output; needs -o")->group(group);
  app.add_flag("--quiet", o.quiet, "No summary, no progress bar")->group(group);
  app.footer(sample_footer);
}

void add_inspect_options(CLI::App& app, InspectOptions& o) {
  add_input_options(app, o.input);
  app.add_option("--method", o.methods, "Methods whose continuity is measured; repeatable, or a list with commas")
      ->allow_extra_args(false)
      ->type_name(method_names())
      ->group("Shape of the curve");
  add_method_options(app, o.shape);
  app.add_flag("--json", o.json, "Print one JSON document");
  app.footer(inspect_footer);
}

/// What a shell is told about an option; choices stand in the type name.
OptionOutline outline(const CLI::Option& option) {
  OptionOutline result{.names = {}, .description = option.get_description()};
  if (option.get_positional()) result.names.push_back(option.get_name(true));
  for (const std::string& name : option.get_snames()) result.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) result.names.push_back("--" + name);
  if (option.get_items_expected_max() == 0) return result;
  const std::string type = option.get_type_name();
  result.argument = type == file_type ? Argument::file : Argument::word;
  if (type.find('|') == std::string::npos || type.find(',') != std::string::npos) return result;
  result.argument = Argument::choice;
  for (const std::string_view choice : pieces_of(type, '|')) result.choices.emplace_back(choice);
  return result;
}

std::vector<CommandOutline> outlines(const CLI::App& app) {
  std::vector<CommandOutline> commands;
  for (const CLI::App* command : app.get_subcommands({})) {
    CommandOutline& result = commands.emplace_back(CommandOutline{command->get_name(), command->get_description(), {}});
    for (const CLI::Option* option : command->get_options()) result.options.push_back(outline(*option));
  }
  return commands;
}

/// CLI11 would only say that a subcommand is required.
std::optional<Error> unknown_command(const CLI::App& app, std::span<char*> arguments) {
  const std::string_view first = arguments.size() > 1 ? arguments[1] : "";
  if (first.starts_with('-')) return std::nullopt;
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  if (std::ranges::find(names, first) != names.end()) return std::nullopt;
  const std::string found = arguments.size() > 1 ? fmt::format("no command '{}'", first) : "found no command";
  return Error{ErrorCode::bad_argument, fmt::format("{}, wanted one of {}", found, fmt::join(names, ", ")), {}};
}

/// CLI11 would take the next word for the value of `--option=`.
std::optional<Error> empty_value(std::span<char*> arguments) {
  for (const std::string_view argument : arguments)
    if (argument.starts_with("--") && argument.size() > 3 && argument.find('=') == argument.size() - 1)
      return Error{ErrorCode::bad_argument, fmt::format("{} wanted a value after it", argument), {}};
  return std::nullopt;
}

/// Defines the commands; each stands for a function to call when it was chosen.
class CommandLine {
 public:
  CommandLine() {
    app_.name("orispline");
    app_.footer(app_footer);
    app_.require_subcommand(1);
    app_.set_version_flag("--version", fmt::format("orispline {}", version));
    add_sample_options(
        command("sample", "Sample the smooth motion through keyframes", [this] { return sample(sample_); }), sample_);
    add_inspect_options(command("inspect", "Say what a file of keyframes is like, and how continuous curves are on it",
                                [this] { return inspect(inspect_); }),
                        inspect_);
    command("methods", "List the methods", [this] { return methods(methods_); })
        .footer(methods_footer)
        ->add_flag("--json", methods_.json, "Print one JSON array");
    command("completion", "Print a completion script for a shell",
            [this] { return completion(shell_, outlines(app_)); })
        .footer(completion_footer)
        ->add_option("SHELL", shell_, "The shell")
        ->required()
        ->type_name(one_of(shell_choices));
  }

  [[nodiscard]] ExitCode run(int argc, char** argv) {
    try {
      const std::span arguments(argv, static_cast<std::size_t>(argc));
      if (const auto error = unknown_command(app_, arguments)) return report(*error);
      if (const auto error = empty_value(arguments)) return report(*error);
      app_.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
      if (error.get_exit_code() != 0) return report({ErrorCode::bad_argument, error.what(), {}});
      app_.exit(error);  // the help or the version that was asked for
    } catch (const std::bad_alloc&) {
      return report({ErrorCode::bad_access, "out of memory", {}});
    }
    return result_ ? ExitCode::success : report(result_.error());
  }

 private:
  template <class Action>
  CLI::App& command(const std::string& name, const std::string& description, Action action) {
    CLI::App& command = *app_.add_subcommand(name, description);
    command.final_callback([this, action] { result_ = action(); });
    return command;
  }

  CLI::App app_{"Smooth orientation curves through keyframes."};
  SampleOptions sample_;
  InspectOptions inspect_;
  MethodsOptions methods_;
  std::string shell_;
  Expected<void> result_;
};

}  // namespace
}  // namespace orispline::cli

int main(int argc, char** argv) {
  std::signal(SIGPIPE, SIG_DFL);  // a reader that has seen enough ends the command without a word
  return static_cast<int>(orispline::cli::CommandLine().run(argc, argv));
}
