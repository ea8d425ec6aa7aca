// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include <orispline/base/first_error.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/jobs/task_request.hpp>

// The tasks on skeletons with their clips.

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

namespace {

/// Of that name. Precondition: it is one.
const MotionFile& scene_in(const TaskRequest& request, std::string_view name) {
  return *std::get<std::shared_ptr<const MotionFile>>(*request.value(name));
}

/// With the clips that the task made.
TaskOutcome with_scene(TaskOutcome outcome, MotionFile made) {
  outcome.scenes.push_back(std::move(made));
  return outcome;
}

/// The usual method for a skeleton, unless another one is stated.
Expected<Method> clip_method_in(const TaskRequest& request, const ClipReduceOptions& options) {
  if (const std::string* const text = request.option("methods"); text && is_of_clips_alone(*text)) return Method{*text};
  return methods_in(request).and_then([&](const auto& stated) -> Expected<Method> {
    if (!stated) return Method{usual_method(options)};
    if (stated->size() == 1) return stated->front().method;
    return bad_option("methods", formatted("found {} methods for a skeleton, wanted one", stated->size()));
  });
}

/// All but the clips.
Expected<ReduceSceneRequest> reduce_scene_request_in(const TaskRequest& request) {
  if (request.inputs.size() > 1)
    return bad_option("recording",
                      formatted("found {} inputs with a skeleton among them, wanted it alone", request.inputs.size()));
  constexpr std::string_view smooth_first = "found the clips of a skeleton, wanted the task `smooth` first";
  for (const FieldInfo& field : fields_of<SmoothOptions>())
    if (is_stated(request, field.name)) return bad_option(field.name, std::string(smooth_first));
  if (auto fits = check_unset(request, {"smooth", "cutoff"}, smooth_first); !fits)
    return tl::unexpected(std::move(fits.error()));
  const MotionFile& file = scene_in(request, "recording");
  FirstError checked;
  ReduceSceneRequest job{.file = {file.name, file.format, file.next_tool},
                         .options = checked(options_in<ClipReduceOptions>(request)),
                         .position_scale = checked(positive_in(request, "position_scale")),
                         .threads = checked(threads_in(request))};
  if (file.format.is_sampled && !is_stated(request, "between")) job.options.between = BetweenSamples::smooth;
  job.options.method = checked(clip_method_in(request, job.options));
  job.options.closed = checked(flag(request, "closed"));
  return std::move(checked).or_else(std::move(job));
}

}  // namespace

Expected<TaskOutcome> run_smooth_scene(const TaskRequest& request, const Progress&) {
  if (request.value("gyro"))
    return bad_option("gyro", "found the rates of a gyro for the clips of a skeleton, wanted orientations at times");
  const MotionFile& file = scene_in(request, "recording");
  FirstError checked;
  SmoothClipsRequest job{.name = file.name,
                         .skeleton = file.skeleton,
                         .clips = file.clips,
                         .options = checked(smoothing_options_in(request)),
                         .threads = checked(threads_in(request)),
                         .has_no_unit = file.format.has_no_unit};
  return std::move(checked)
      .or_else(std::move(job))
      .and_then([](SmoothClipsRequest sound) { return smooth_clips(std::move(sound)); })
      .map_error([&](Error error) { return with_cutoff(request, std::move(error)); })
      .map([&](SmoothClipsOutcome outcome) {
        std::vector<Clip> clips;
        for (const ClipSmoothing& smoothed : outcome.clips) clips.push_back(smoothed.clip);
        return with_scene(told(std::move(outcome)), {file.name, file.skeleton, std::move(clips), file.format});
      });
}

Expected<void> check_reduce_scene(const TaskRequest& request) {
  return reduce_scene_request_in(request).and_then([](const ReduceSceneRequest& job) { return check(job); });
}

Expected<TaskOutcome> run_reduce_scene(const TaskRequest& request, const Progress&) {
  return reduce_scene_request_in(request).and_then([&](ReduceSceneRequest job) {
    const MotionFile& file = scene_in(request, "recording");
    job.skeleton = file.skeleton;
    job.clips = file.clips;
    return reduce_scene(std::move(job)).map([&](ReduceSceneOutcome outcome) {
      MotionFile made{file.name, outcome.request.skeleton, outcome.clips(), outcome.request.file.format};
      return with_scene(told(std::move(outcome)), std::move(made));
    });
  });
}

namespace {

/// All but the clips.
Expected<RetimeClipsRequest> retime_clips_request_in(const TaskRequest& request) {
  const MotionFile& file = scene_in(request, "keys");
  FirstError checked;
  RetimeClipsRequest job{.file = {.name = file.name, .format = file.format},
                         .options = checked(options_in<RetimeOptions>(request))};
  if (request.method) job.method = request.method->method;
  else if (const std::string* const text = request.option("method")) job.method = checked(method_from_text(*text));
  return std::move(checked).or_else(std::move(job));
}

}  // namespace

Expected<void> check_retime_scene(const TaskRequest& request) {
  return retime_clips_request_in(request).and_then([](const RetimeClipsRequest& job) { return check(job); });
}

Expected<TaskOutcome> run_retime_scene(const TaskRequest& request, const Progress& progress) {
  return retime_clips_request_in(request).and_then([&](RetimeClipsRequest job) {
    job.file = scene_in(request, "keys");
    return retime_clips(std::move(job), progress).map([](RetimeClipsOutcome outcome) {
      MotionFile made = outcome.request.file;
      for (std::size_t i = 0; i < made.clips.size(); ++i) made.clips[i] = outcome.clips[i].clip;
      return with_scene(told(std::move(outcome)), std::move(made));
    });
  });
}

Expected<TaskOutcome> run_inspect_scene(const TaskRequest& request, const Progress&) {
  return check_unset(request, {"methods"}, "found the clips of a skeleton, wanted orientations at times").map([&] {
    const MotionFile& file = scene_in(request, "keys");
    return told(inspect_scene({.file = file}));
  });
}

Expected<TaskOutcome> run_difference(const TaskRequest& request, const Progress&) {
  FirstError checked;
  DifferenceRequest job{.first = scene_in(request, "first"),
                        .second = scene_in(request, "second"),
                        .shell = checked(options_in<ClipReduceOptions>(request)).shell,
                        .rate = checked(positive_in(request, "rate")),
                        .threads = checked(threads_in(request))};
  return std::move(checked)
      .or_else(std::move(job))
      .and_then([](DifferenceRequest sound) { return difference(std::move(sound)); })
      .map([](DifferenceOutcome outcome) { return told(std::move(outcome)); });
}

Expected<void> check_clip_edits(const TaskRequest& request) {
  return options_in<ClipEdits>(request).and_then([](const ClipEdits& edits) { return check(edits); });
}

Expected<TaskOutcome> run_clip(const TaskRequest& request, const Progress&) {
  FirstError checked;
  const auto text = [&](std::string_view name) { return request.option(name) ? *request.option(name) : std::string(); };
  ClipRequest job{.file = scene_in(request, "scene"),
                  .edits = checked(options_in<ClipEdits>(request)),
                  .root = text("root"),
                  .extract_root = text("extract_root"),
                  .root_node = text("root_node"),
                  .in_place = text("in_place"),
                  .append_clip = text("append_clip"),
                  .threads = checked(threads_in(request))};
  if (request.value("append")) job.appended = scene_in(request, "append");
  return std::move(checked)
      .or_else(std::move(job))
      .and_then([](ClipRequest sound) { return clip(std::move(sound)); })
      .map([&](ClipOutcome outcome) {
        std::vector<Clip> clips;
        for (const ClipEdit& edit : outcome.clips) clips.push_back(edit.clip);
        MotionFile made = outcome.request.file;
        made.clips = std::move(clips);
        return with_scene(told(std::move(outcome)), std::move(made));
      });
}

}}}  // namespace orispline::jobs
