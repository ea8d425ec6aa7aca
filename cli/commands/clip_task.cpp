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

constexpr double same_step = 0.01;  // share by which the steps between frames may differ

/// The usual step between the frames of a clip that was cut between two of them [s]; absent where all steps are even.
std::optional<double> frame_step_of(const Clip& clip) {
  const std::vector<double> times = key_times(clip);
  std::vector<double> steps;
  for (std::size_t i = 0; i + 1 < times.size(); ++i) steps.push_back(times[i + 1] - times[i]);
  if (steps.empty()) return std::nullopt;
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::ranges::nth_element(steps, middle);
  const double usual = *middle;
  const bool are_even =
      std::ranges::all_of(steps, [&](double step) { return std::abs(step - usual) <= same_step * usual; });
  return are_even ? std::nullopt : std::optional(usual);
}

/// The rate nearest to a usual one at which a loop ends on a frame [Hz].
double rate_of_loop(Domain loop, double usual) {
  const double length = loop.end - loop.start;
  return std::max(1.0, std::round(length * usual)) / length;
}

/// What a loop is written at as BVH, where it does not end on a frame [Hz].
std::optional<double> rate_of_loop(const std::string& path, const Clip& loop) {
  const auto step = frame_step_of(loop);
  if (!step) return std::nullopt;
  const double rate = rate_of_loop(loop.domain(), 1.0 / *step);
  warn({{.code = "rate_of_loop",
         .message = formatted("the loop has frames at {:.6g} Hz instead of {:.6g} Hz, so that it ends on one", rate,
                              1.0 / *step),
         .where = {.file = path}}});
  return rate;
}

Expected<WrittenResult> write_clip(const TaskArguments& arguments, TaskJob& job, jobs::TaskOutcome& outcome) {
  const std::string& path = arguments.output.path;
  const bool has_frames = job.scene.format == &scenes::bvh_format || is_given(arguments.fields, "rate");
  if (is_bvh(path) && has_frames && is_given(arguments.fields, "loop"))
    job.writing.rate = rate_of_loop(path, outcome.scenes.front().clips.front());
  return write_edited_scene(path, std::move(job.scene), job.writing, outcome).map([&] {
    return WrittenResult{.text = written_text(arguments, "")};
  });
}

}  // namespace

Expected<void> run_clip(const TaskArguments& arguments) {
  return run_on_one({"clip", clip_job, read_clips, write_clip}, arguments);
}

}  // namespace orispline::cli
