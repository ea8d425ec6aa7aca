// SPDX-License-Identifier: Apache-2.0
// clip: from a file of skeletons to another one.
#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/scenes/scene_file.hpp>
#include <orispline/scenes/scene_tracks.hpp>

#include "commands/task_command.hpp"
#include "options/file_places.hpp"
#include "options/scene_input.hpp"
#include "options/threads.hpp"
#include "output/scene_output.hpp"
#include "output/standard_output.hpp"

namespace orispline::cli {

namespace {

Expected<TaskJob> clip_job(const TaskArguments& arguments) {
  const std::string& output = arguments.output.path;
  if (!is_scene(output))
    return usage_failure(formatted("{}: found '{}', wanted a file of skeletons, whose name ends in {}",
                                   arguments.output.option, printable(output), endings_of(scenes_written())));
  FirstError checked;
  TaskJob job{.input = {.path = arguments.input.path, .read = {}}, .request = request_of(arguments)};
  job.writing = checked(scene_writing(arguments.output));
  job.request.options.emplace_back("threads", std::uint64_t{checked(threads_in(arguments.inputs.threads))});
  job.names = Json({{"input", arguments.input.path}});
  auto read = std::move(checked).or_else(std::move(job));
  if (!read) return read;
  return jobs::check_task("clip", read->request)
      .and_then([&] { return check_files(arguments); })
      .and_then([&]() -> Expected<void> {
        const auto behind = file_of(arguments, "append");
        if (!behind) return {};
        return check_output_apart(arguments.output.option, output, {{"that of --append", *behind}});
      })
      .map([&] { return std::move(*read); });
}

Expected<void> read_clips(const TaskArguments& arguments, TaskJob& job) {
  auto scene = read_scene_as_typed(arguments.input, arguments.input.path).and_then([&](scenes::Scene whole) {
    warn(whole.warnings);
    return scenes::with_clips(std::move(whole), arguments.clips);
  });
  if (!scene) return tl::unexpected(std::move(scene.error()));
  job.request.inputs = {{"scene", motion_of(arguments.input.path, *scene)}};
  job.scene = *std::move(scene);
  const auto behind = file_of(arguments, "append");
  if (!behind) return {};
  return read_scene_as_typed(arguments.input, *behind).map([&](const scenes::Scene& second) {
    warn(second.warnings);
    job.request.inputs.emplace_back("append", motion_of(*behind, second));
  });
}

Expected<WrittenResult> write_clip(const TaskArguments& arguments, TaskJob& job, jobs::TaskOutcome& outcome) {
  return write_edited_scene(arguments.output.path, std::move(job.scene), job.writing, outcome).map([&] {
    return WrittenResult{.text = written_text(arguments, "")};
  });
}

}  // namespace

Expected<void> run_clip(const TaskArguments& arguments) {
  return run_on_one({"clip", clip_job, read_clips, write_clip}, arguments);
}

}  // namespace orispline::cli
