// SPDX-License-Identifier: Apache-2.0
// clip: from a file of skeletons to another one.
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/clip/clip_difference.hpp>
#include <orispline/jobs/task_list.hpp>
#include <orispline/scenes/scene_file.hpp>
#include <orispline/scenes/scene_tracks.hpp>
#include <orispline/scenes/usual_step.hpp>

#include "commands/task_command.hpp"
#include "options/file_places.hpp"
#include "options/scene_input.hpp"
#include "options/threads.hpp"
#include "output/scene_output.hpp"
#include "output/standard_output.hpp"

namespace orispline::cli {

namespace {

bool is_bvh(const std::string& path) { return scenes::scene_format_of(path) == &scenes::bvh_format; }

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

constexpr double even_step = 1e-6;   // share by which even steps between frames may differ
constexpr double same_frame = 0.01;  // shares of a step by which two times are one frame

/// The usual step between keys that are not at even frames, as after a cut between two of them, or where a joint got
/// more keys [s], or nearly that where the last frame is at the end then; absent where all steps are even.
std::optional<double> frame_step_of(const Clip& clip) {
  const double usual = scenes::usual_step_of(clip);
  const std::vector<double> times = key_times(clip);
  bool are_even = true;
  for (std::size_t i = 0; i + 1 < times.size(); ++i)
    are_even = are_even && std::abs(times[i + 1] - times[i] - usual) <= even_step * usual;
  if (usual == 0.0 || are_even) return std::nullopt;
  const double span = times.back() - times.front(), frames = std::round(span / usual);
  return std::abs(span / usual - frames) <= same_frame ? span / frames : usual;
}

/// The rate nearest to a usual one at which a loop ends on a frame [Hz].
double rate_of_loop(Domain loop, double usual, const std::string& path) {
  const double length = loop.end - loop.start, rate = std::max(1.0, std::round(length * usual)) / length;
  if (std::abs(rate - usual) > even_step * usual)
    warn({{.code = "rate_of_loop",
           .message =
               formatted("the loop has frames at {:.6g} Hz instead of {:.6g} Hz, so that it ends on one", rate, usual),
           .where = {.file = path},
           .numbers = {{"rate_hz", rate}}}});
  return rate;
}

/// What a loop is written at as BVH, where it does not end on a frame as it is [Hz].
std::optional<double> rate_of_loop(const std::string& path, const Clip& loop, const TaskJob& job,
                                   std::optional<double> rate) {
  if (!rate && job.scene.format == &scenes::bvh_format)
    if (const auto step = frame_step_of(loop)) rate = 1.0 / *step;
  return rate ? std::optional(rate_of_loop(loop.domain(), *rate, path)) : std::nullopt;
}

Expected<WrittenResult> write_clip(const TaskArguments& arguments, TaskJob& job, jobs::TaskOutcome& outcome) {
  const std::string& path = arguments.output.path;
  const ClipEdits& edits = jobs::found<jobs::ClipOutcome>(outcome).request.edits;
  if (is_bvh(path) && edits.loop)
    job.writing.rate = rate_of_loop(path, outcome.scenes.front().clips.front(), job, edits.rate);
  return write_edited_scene(path, std::move(job.scene), job.writing, outcome).map([&] {
    return WrittenResult{.text = written_text(arguments, "")};
  });
}

}  // namespace

Expected<void> run_clip(const TaskArguments& arguments) {
  return run_on_one({"clip", clip_job, read_clips, write_clip}, arguments);
}

}  // namespace orispline::cli
