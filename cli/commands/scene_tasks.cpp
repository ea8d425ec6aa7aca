// SPDX-License-Identifier: Apache-2.0
// smooth, retime and reduce where the output is a file of skeletons, and difference, which compares two of them.
#include <filesystem>
#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/fields.hpp>
#include <orispline/scenes/scene_file.hpp>

#include "commands/task_command.hpp"
#include "options/file_places.hpp"
#include "options/scene_input.hpp"
#include "options/threads.hpp"
#include "output/report_file.hpp"
#include "output/scene_output.hpp"
#include "output/standard_output.hpp"
#include "output/summary.hpp"

namespace orispline::cli {

namespace {

/// What was typed for a task on a skeleton, with how many threads work on its clips.
Expected<jobs::TaskRequest> request_with_threads(const TaskArguments& arguments) {
  return threads_in(arguments.inputs.threads).map([&](std::size_t threads) {
    jobs::TaskRequest request = request_of(arguments);
    request.options.emplace_back("threads", std::uint64_t{threads});
    return request;
  });
}

/// The words of a task on a skeleton, with its options checked by what the name of the file tells.
Expected<TaskJob> understood(std::string_view task, std::string_view input, const TaskArguments& arguments,
                             Expected<jobs::TaskRequest> request) {
  FirstError checked;
  TaskJob job{.input = checked(input_request(arguments.input)), .request = checked(std::move(request))};
  job.writing = checked(scene_writing(arguments.output));
  job.names = Json({{"input", arguments.input.path}});
  auto read = std::move(checked).or_else(std::move(job));
  if (!read) return read;
  const scenes::Scene unread{.name = arguments.input.path, .format = scene_format_of(read->input)};
  read->request.inputs = {{std::string(input), motion_of(unread.name, unread)}};
  return jobs::check_task(task, read->request).and_then([&] { return check_files(arguments); }).map([&] {
    return std::move(*read);
  });
}

Expected<void> read_scene_of(const TaskArguments& arguments, TaskJob& job) {
  auto scene = open_scene(job.input);
  if (!scene) return tl::unexpected(std::move(scene.error()));
  warn(scene->warnings);
  job.request.inputs.front().second = motion_of(arguments.input.path, *scene);
  job.scene = *std::move(scene);
  return {};
}

/// The clips that the task made, in the place of those that were read.
Expected<void> write_clips(const TaskArguments& arguments, const TaskJob& job, const jobs::TaskOutcome& outcome) {
  return write_scene(arguments.output.path, scenes::with_motion(job.scene, outcome.scenes.front()), job.writing);
}

// smooth

Expected<TaskJob> smooth_scene_job(const TaskArguments& arguments) {
  if (const auto given = first_given(arguments.rows); !given.empty())
    return usage_failure(
        formatted("{}: found a file of skeletons, whose keys are smoothed, wanted samples of one track", given));
  if (file_of(arguments, "gyro"))
    return usage_failure("--gyro-file: found a file of skeletons, wanted a recording of one track");
  return understood("smooth", "recording", arguments, request_with_threads(arguments));
}

/// Of smooth and retime.
Expected<WrittenResult> write_changed_scene(const TaskArguments& arguments, TaskJob& job, jobs::TaskOutcome& outcome) {
  return write_clips(arguments, job, outcome).map([&] { return WrittenResult{.text = written_text(arguments, "")}; });
}

// retime

Expected<TaskJob> retime_scene_job(const TaskArguments& arguments) {
  auto request = named_method(arguments.method, arguments.shape).map([&](std::optional<Method> method) {
    jobs::TaskRequest made = request_of(arguments);
    if (method) made.method = jobs::ChosenMethod{.method = *std::move(method)};
    return made;
  });
  return understood("retime", "keys", arguments, std::move(request));
}

// reduce

/// One that is named, or has options.
Expected<std::optional<Method>> scene_method_in(const TaskArguments& arguments) {
  if (!arguments.method && !any_given(arguments.shape)) return std::nullopt;
  const std::string method = arguments.method.value_or(std::string(cubicspline_method));
  if (!is_of_clips_alone(method))
    return method_request(method, arguments.shape).map([](Method named) { return std::optional(std::move(named)); });
  if (any_given(arguments.shape))
    return usage_failure(formatted("{}: found the method {}, which has no such option, wanted another --method",
                                   first_given(arguments.shape), method));
  return std::optional(Method{method});
}

/// What is not for clips.
Expected<void> check_clips(const TaskArguments& arguments) {
  for (const std::string_view name : {"smooth", "noise", "smoothing_time", "position_noise", "cutoff"})
    if (is_given(arguments.fields, name))
      return usage_failure(formatted(
          "{}: found a file of skeletons, wanted keys of one track as the output, or 'orispline smooth' first",
          flag_of(name)));
  if (is_given(arguments.fields, "values"))
    return usage_failure("--refit: found a file of skeletons, wanted keys of one track as the output");
  const scenes::SceneFormat* const format = scenes::scene_format_of(arguments.output.path);
  if (format != &scenes::gltf_format)
    return usage_failure(formatted("{}: found '{}', but {} holds every frame; wanted glTF, such as small.glb",
                                   arguments.output.option, printable(arguments.output.path), format->title));
  if (is_given(arguments.fields, "tolerance") || is_given(arguments.fields, "world_tolerance")) return {};
  return usage_failure(
      "reduce: --tolerance or --world-tolerance is missing; 'orispline help reduce' shows what to type");
}

Expected<TaskJob> reduce_scene_job(const TaskArguments& arguments) {
  return check_clips(arguments)
      .and_then([&] {
        auto request = scene_method_in(arguments).and_then([&](std::optional<Method> method) {
          return request_with_threads(arguments).map([&](jobs::TaskRequest made) {
            if (method) made.methods = {{"", *std::move(method)}};
            return made;
          });
        });
        return understood("reduce", "recording", arguments, std::move(request));
      })
      .and_then([&](TaskJob job) {
        return if_given("--compress", arguments.fields.find("compress")->second, compression_in)
            .map([&](std::optional<KeyCompression> compression) {
              job.writing.compression = compression.value_or(KeyCompression::none);
              return std::move(job);
            });
      });
}

/// 0 where it is not known.
std::size_t bytes_of(const std::string& path) {
  std::error_code none;
  const auto bytes = std::filesystem::file_size(path, none);
  return none ? 0 : static_cast<std::size_t>(bytes);
}

std::string size_text(std::size_t bytes) {
  const bool is_large = bytes >= 1'000'000;
  return formatted("{:.3g} {}", static_cast<double>(bytes) * (is_large ? 1e-6 : 1e-3), is_large ? "MB" : "kB");
}

std::size_t bytes_of_all(const std::vector<Clip>& clips) {
  std::size_t bytes = 0;
  for (const Clip& clip : clips) bytes += bytes_of_keys(clip);
  return bytes;
}

/// Why a file that was written may be larger than the one that was read, though it has fewer keys.
std::string why_larger(const TaskJob& job, const std::vector<Clip>& clips) {
  std::string why = "keys of the input are integers, and cubics and new keys are floats";
  if (!job.scene.has_integer_keys) {
    if (bytes_of_all(clips) <= bytes_of_all(job.scene.clips))
      return "what describes nodes and tracks beside the keys takes more room";
    why = "a key of a cubic has 52 bytes, one of slerp 20";
  }
  const auto& methods = job.request.methods;
  if (job.writing.compression == KeyCompression::none &&
      (methods.empty() || methods.front().method.name != smallest_method))
    why += "; --method smallest writes each track with the fewest bytes that were found for it";
  return why;
}

Warning larger_file(const std::string& output, std::size_t after, std::size_t before, std::string_view why) {
  return {.code = "larger_file",
          .message = formatted("{}: found {} written, more than the {} of the input, for {}", printable(output),
                               size_text(after), size_text(before), why),
          .numbers = {{"bytes", static_cast<double>(after)}, {"bytes_before", static_cast<double>(before)}}};
}

/// With the sizes of the files, of glTF with its buffers, where they are known.
Expected<WrittenResult> write_reduced_scene(const TaskArguments& arguments, TaskJob& job, jobs::TaskOutcome& outcome) {
  const std::size_t before = job.scene.bytes > 0 ? job.scene.bytes : bytes_of(arguments.input.path);
  const std::string why = why_larger(job, outcome.scenes.front().clips);
  return write_clips(arguments, job, outcome).map([&] {
    const std::size_t after = bytes_of(arguments.output.path);
    if (before > 0 && after > before && bytes_of_all(job.scene.clips) > 0)
      warn({larger_file(arguments.output.path, after, before, why)});
    const std::string sizes = before == 0 ? "" : formatted(": {} of {}", size_text(after), size_text(before));
    WrittenResult written{.text = formatted("written to {}{}\n", destination(arguments.output.path), sizes)};
    if (before > 0) written.members.emplace_back("bytes_before", before);
    written.members.emplace_back("bytes", after);
    return written;
  });
}

// difference

/// The chosen clips. The only clip of both files is the one that is compared, whatever its name in the second.
Expected<jobs::TaskValue> motion_in(const TaskArguments& arguments, const std::string& path) {
  return read_scene_as_typed(arguments.input, path)
      .and_then([&](scenes::Scene scene) -> Expected<scenes::Scene> {
        warn(scene.warnings);
        const bool is_second = &path == &arguments.second;
        if (is_second && scene.clips.size() == 1 && arguments.clips.size() == 1) return scene;
        return scenes::with_clips(std::move(scene), arguments.clips);
      })
      .map([&](const scenes::Scene& scene) { return jobs::TaskValue(motion_of(path, scene)); });
}

}  // namespace

const TaskSteps smooth_scene_steps{"smooth", smooth_scene_job, read_scene_of, write_changed_scene};
const TaskSteps retime_scene_steps{"retime", retime_scene_job, read_scene_of, write_changed_scene};
const TaskSteps reduce_scene_steps{"reduce", reduce_scene_job, read_scene_of, write_reduced_scene};

Expected<void> run_difference(const TaskArguments& arguments) {
  const std::string &first = arguments.input.path, &second = arguments.second;
  if (auto apart = check_report(arguments.report, {{"FIRST", first}, {"SECOND", second}}); !apart) return apart;
  auto page = ReportFile::open(arguments.report);
  if (!page) return tl::unexpected(std::move(page.error()));
  jobs::TaskRequest request = request_of(arguments);
  if (auto sound = jobs::check_task("difference", request); !sound) return sound;
  FirstError checked;
  request.inputs = {{"first", checked(motion_in(arguments, first))}, {"second", checked(motion_in(arguments, second))}};
  auto outcome = std::move(checked).or_else(std::move(request)).and_then([](const jobs::TaskRequest& sound) {
    return jobs::run_task("difference", sound);
  });
  if (!outcome) return tl::unexpected(std::move(outcome.error()));
  warn(outcome->warnings);
  return page->write([&](const auto& head) { return page_of(*outcome, head); })
      .and_then([&] { return print_document(arguments.json ? document(outcome->document) : outcome->summary); })
      .and_then([&] { return page->finish(); });
}

}  // namespace orispline::cli
