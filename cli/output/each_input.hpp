// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <utility>

#include <orispline/base/expected.hpp>

#include "options/input_options.hpp"
#include "options/option_text.hpp"
#include "options/output_options.hpp"
#include "options/several_inputs.hpp"
#include "options/summary_options.hpp"
#include "output/output_folder.hpp"

namespace orispline::cli {

/// One of several inputs, and what the work on it may use.
struct InputTurn {
  std::string input, output;  ///< paths
  std::string threads;        ///< as `--threads` would have them
  std::string session{};      ///< as `--session` would have it, where each recording of an input is one
};

/// What a command does with several inputs.
struct WorkOnEach {
  std::function<Expected<void>(const InputTurn&)> check;  ///< of the options, by the first input, before all work
  std::function<Expected<void>(const InputTurn&)> work;
  std::string_view extension{};  ///< of the outputs; empty: those of the inputs
  bool wants_report = false;     ///< which shows one of them
  SceneOutputs scenes = SceneOutputs::rows;
  /// How many recordings there are in a file, each of which is an input. Null: files are.
  std::function<Expected<std::size_t>(const std::string&)> sessions{};
};

/// Works on each input in threads, and says what there is to say in their order. A bad input does not stop the others.
///
/// Errors: what is wrong with the options or the folder; else, once each bad input was named, the gravest kind of what
/// was wrong, with the number of bad inputs.
[[nodiscard]] Expected<void> work_on_each(const SeveralInputs& inputs, const SummaryOptions& summary,
                                          const WorkOnEach& each);

/// What a command does with its options once they name one input and one output.
template <class Options>
struct CommandOnInput {
  std::string_view written;                 ///< into the output: `keys`
  Expected<void> (*check)(const Options&);  ///< that the options are good, before all work on several inputs
  Expected<void> (*work)(const Options&);
  std::string_view extension{};  ///< as in WorkOnEach, of a command that writes no samples
  SceneOutputs scenes = SceneOutputs::rows;
};

/// Calls it with the only input, or with each of several that go into an output folder.
template <class Options>
[[nodiscard]] Expected<void> on_inputs(const Options& options, const CommandOnInput<Options>& command) {
  const bool each_session = asks_for_all_sessions(options.input);
  if (each_session && !options.inputs.folder)
    return usage_failure("--session: found all without --output-folder, wanted that too, or the number of a recording");
  if (!options.inputs.folder)
    return only_input(options.inputs, command.written).and_then([&](const std::string& path) {
      Options one = options;
      one.input.path = path;
      return command.work(one);
    });
  const Expected<std::string_view> extension =
      command.extension.empty() ? folder_extension(options.output, command.written) : command.extension;
  if (!extension) return tl::unexpected(extension.error());
  const auto on = [&](const InputTurn& turn) {
    Options one = options;
    one.input.path = turn.input;
    one.output.path = turn.output;
    one.output.option = "--output-folder";
    one.inputs.threads = turn.threads;
    if (!turn.session.empty()) choose_session(one.input, turn.session);
    return one;
  };
  WorkOnEach each{.check = [&](const InputTurn& turn) { return command.check(on(turn)); },
                  .work = [&](const InputTurn& turn) { return command.work(on(turn)); },
                  .extension = *extension,
                  .scenes = command.scenes};
  if (each_session)
    each.sessions = [&](const std::string& path) {
      InputOptions one = options.input;
      one.path = path;
      return sessions_in(one);
    };
  if constexpr (requires { options.report; }) each.wants_report = options.report.path.has_value();
  return work_on_each(options.inputs, options.summary, each);
}

}  // namespace orispline::cli
