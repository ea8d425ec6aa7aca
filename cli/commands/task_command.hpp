// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <orispline/jobs/task_list.hpp>
#include <orispline/scenes/scene_file.hpp>

#include "options/command.hpp"
#include "options/field_options.hpp"
#include "options/input_options.hpp"
#include "options/method_options.hpp"
#include "options/output_options.hpp"
#include "options/report_options.hpp"
#include "options/row_options.hpp"
#include "options/several_inputs.hpp"
#include "options/summary_options.hpp"

// The commands that run a task: words become a request, jobs::run_task() runs it, and what it made becomes a file.

namespace orispline::cli {

/// What is typed for such a command. Each offers some of these; the others stay as they are.
struct TaskArguments {
  SeveralInputs inputs;
  InputOptions input;  ///< the one that is worked on, and how all of them are read
  std::string second;  ///< the recording that INPUT is aligned onto, or the other skeleton
  TypedFields fields;  ///< options and settings of the task, by its names
  TypedFields files;   ///< other inputs of the task, by its names
  std::optional<std::string> method;
  std::vector<std::string> methods;  ///< each time one, or a list with commas between them
  MethodOptions shape;
  std::vector<std::string> clips;       ///< names; empty: all
  std::vector<std::string> keep_every;  ///< whole numbers, or lists of them with commas between them
  std::optional<std::string> random;    ///< seed
  bool jitter = false;
  RowOptions rows;  ///< of samples in the place of keys
  OutputOptions output;
  ReportOptions report;
  SummaryOptions summary;
  bool json = false, csv = false;  ///< how tables are printed, or written
};

/// A command that runs a task.
struct TaskCommand {
  std::string_view name, sentence;
  void (*add_options)(Command& app, TaskArguments& arguments);
  Expected<void> (*run)(const TaskArguments& arguments);
};

/// One of them. Precondition: there is one of that name.
[[nodiscard]] const TaskCommand& task_command(std::string_view name);

/// What a command line asks of a task.
struct TaskJob {
  InputRequest input;
  jobs::TaskRequest request{};       ///< whose inputs are read later
  io::SampleColumns columns{};       ///< of the output
  std::optional<RowRequest> rows{};  ///< samples in the place of keys
  std::size_t threads = 1;           ///< that make them
  std::optional<Method> named{};     ///< by the user, of a task that is about one curve
  scenes::Scene scene{};             ///< whose clips a task changes
  scenes::SceneWriting writing{};    ///< of the scene
  std::vector<Warning> warnings{};   ///< of reading, which are said with those of the task
  Json names{};                      ///< of the inputs, as the document has them
};

/// What the summary of a file says behind that of the task.
struct WrittenResult {
  std::string text{};
  Json::Object members{};  ///< of the document, behind all others
};

/// How a command comes from words to a file.
struct TaskSteps {
  std::string_view task;
  Expected<TaskJob> (*understand)(const TaskArguments& arguments);
  Expected<void> (*read)(const TaskArguments& arguments, TaskJob& job);
  Expected<WrittenResult> (*write)(const TaskArguments& arguments, TaskJob& job, jobs::TaskOutcome& outcome);
  Error (*explain)(Error error) = nullptr;  ///< what is wrong, in the words of files
};

/// Runs it on the one input that the arguments name.
[[nodiscard]] Expected<void> run_on_one(const TaskSteps& steps, const TaskArguments& arguments);

/// For the inputs of a task.
[[nodiscard]] inline std::shared_ptr<const Track> shared(Track track) {
  return std::make_shared<const Track>(std::move(track));
}

/// The options that were typed, as the task takes them.
[[nodiscard]] jobs::TaskRequest request_of(const TaskArguments& arguments);
/// The typed name of a file that the task takes beside INPUT.
[[nodiscard]] std::optional<std::string> file_of(const TaskArguments& arguments, std::string_view name);
/// Error (bad_argument): files that would be lost, and summaries and reports that have no place.
[[nodiscard]] Expected<void> check_files(const TaskArguments& arguments);
/// `keys written to keys.csv` and an end of line.
[[nodiscard]] std::string written_text(const TaskArguments& arguments, std::string_view what);

// The tasks on skeletons, whose output is one.
extern const TaskSteps smooth_scene_steps, retime_scene_steps, reduce_scene_steps;
/// Whether the output is a file of skeletons.
[[nodiscard]] bool makes_scene(const TaskArguments& arguments);

// What each command does.
[[nodiscard]] Expected<void> run_align(const TaskArguments& arguments);
[[nodiscard]] Expected<void> run_bake(const TaskArguments& arguments);
[[nodiscard]] Expected<void> run_clip(const TaskArguments& arguments);
[[nodiscard]] Expected<void> run_compare(const TaskArguments& arguments);
[[nodiscard]] Expected<void> run_difference(const TaskArguments& arguments);
[[nodiscard]] Expected<void> run_inspect(const TaskArguments& arguments);
[[nodiscard]] Expected<void> run_mean(const TaskArguments& arguments);
[[nodiscard]] Expected<void> run_reduce(const TaskArguments& arguments);
[[nodiscard]] Expected<void> run_retime(const TaskArguments& arguments);
[[nodiscard]] Expected<void> run_smooth(const TaskArguments& arguments);
[[nodiscard]] Expected<void> run_tune(const TaskArguments& arguments);

}  // namespace orispline::cli
