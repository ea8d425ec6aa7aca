// SPDX-License-Identifier: Apache-2.0
#include "commands/reduce/reduce_scene.hpp"

#include <filesystem>
#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/fields.hpp>
#include <orispline/jobs/reduce.hpp>
#include <orispline/scenes/scene_file.hpp>

#include "options/file_places.hpp"
#include "options/scene_input.hpp"
#include "options/threads.hpp"
#include "output/noted_output.hpp"
#include "output/scene_output.hpp"
#include "output/standard_output.hpp"

namespace orispline::cli {

namespace {

/// The command line, understood.
struct SceneRequest {
  InputRequest input{};
  scenes::SceneWriting writing{};
  jobs::ReduceSceneRequest job{};
};

Expected<Method> scene_method_in(const ReduceArguments& options) {
  if (options.method == smallest_method || options.method == cubicspline_method) {
    if (any_given(options.shape))
      return usage_failure(formatted("{}: found the method {}, which has no such option, wanted another --method",
                                     first_given(options.shape), cubicspline_method));
    return Method{cubicspline_method};
  }
  return method_request(options.method, options.shape);
}

/// What is not for clips.
Expected<void> check_clips(const ReduceArguments& options) {
  if (options.smooth || any_given(options.smoothness))
    return usage_failure(
        formatted("{}: found a file of skeletons, wanted keys of one track as the output, or 'orispline smooth' first",
                  options.smooth ? "--smooth" : first_given(options.smoothness)));
  if (is_given(options.reduction, "values"))
    return usage_failure("--refit: found a file of skeletons, wanted keys of one track as the output");
  if (scenes::scene_format_of(options.output.path) != &scenes::gltf_format)
    return usage_failure(formatted("{}: found '{}', but {} holds every frame; wanted glTF, such as small.glb",
                                   options.output.option, printable(options.output.path),
                                   scenes::scene_format_of(options.output.path)->title));
  if (is_given(options.reduction, "tolerance") || is_given(options.scene, "world_tolerance")) return {};
  return usage_failure(
      "reduce: --tolerance or --world-tolerance is missing; 'orispline help reduce' shows what to type");
}

Expected<orispline::ClipReduceOptions> clip_reduction_in(const ReduceArguments& options) {
  TypedFields typed = options.scene;
  for (const std::string_view name : {"tolerance", "position_tolerance"})
    if (const auto found = options.reduction.find(name); found != options.reduction.end()) typed[name] = found->second;
  FirstError checked;
  auto reduction = checked(options_in<orispline::ClipReduceOptions>(typed));
  reduction.method = checked(scene_method_in(options));
  reduction.closed = options.closed;
  return std::move(checked).or_else(std::move(reduction));
}

Expected<std::optional<double>> position_scale_in(const ReduceArguments& options) {
  if (!options.position_scale) return std::optional<double>();
  return positive_in({"--position-scale", *options.position_scale}).map([](double found) {
    return std::optional(found);
  });
}

jobs::ClipFile file_of(const ReduceArguments& options, const scenes::SceneFormat* format) {
  if (!format) return {.name = options.input.path};  // keys of a table
  return {.name = options.input.path,
          .format = format->file,
          .has_no_unit = format->has_no_unit,
          .is_single_precise = format->holds_floats};
}

Expected<SceneRequest> scene_request_in(const ReduceArguments& options) {
  if (auto fits = check_clips(options); !fits) return tl::unexpected(std::move(fits.error()));
  FirstError checked;
  SceneRequest request{.input = checked(input_request(options.input)),
                       .writing = checked(scene_writing(options.output)),
                       .job = {.file = {},
                               .options = checked(clip_reduction_in(options)),
                               .position_scale = checked(position_scale_in(options)),
                               .threads = static_cast<unsigned>(checked(threads_in(options.inputs.threads)))}};
  request.job.file = file_of(options, scene_format_of(request.input));
  auto read = std::move(checked).or_else(std::move(request));
  if (!read) return read;
  return check(read->job).and_then([&] { return check_files(options); }).map([&] { return std::move(*read); });
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

/// The clips with fewer keys, and the sizes of the files that they were read from and written to.
struct ReducedScene : Written<jobs::ReduceSceneOutcome> {
  std::size_t bytes_before = 0, bytes_after = 0;  ///< of a glTF file with its buffers; 0 where that is not known
};

std::string text_of(const ReducedScene& written) {
  const std::string sizes = written.bytes_before == 0 ? ""
                                                      : formatted(": {} of {}", size_text(written.bytes_after),
                                                                  size_text(written.bytes_before));
  return summary_of(written.outcome) + formatted("written to {}{}\n", destination(written.output), sizes);
}

Json json_of(const ReducedScene& written) {
  Json json = cli::json_of<jobs::ReduceSceneOutcome>(written);
  if (written.bytes_before > 0) json["bytes_before"] = written.bytes_before;
  json["bytes"] = written.bytes_after;
  return json;
}

}  // namespace

Expected<void> check_reduce_scene(const ReduceArguments& options) {
  return scene_request_in(options).map([](const SceneRequest&) {});
}

Expected<void> reduce_scene(const ReduceArguments& options) {
  auto request = scene_request_in(options);
  if (!request) return tl::unexpected(request.error());
  auto page = ReportFile::open(options.report);
  if (!page) return tl::unexpected(std::move(page.error()));
  if (auto able = check_output(options.output.path); !able) return able;
  auto scene = open_scene(request->input);
  if (!scene) return tl::unexpected(std::move(scene.error()));
  warn(scene->warnings);
  request->job.file = file_of(options, scene->format);
  request->job.skeleton = scene->skeleton;
  request->job.clips = std::exchange(scene->clips, {});
  ReducedScene report{{options.input.path, options.output.path, "keys", {}},
                      scene->bytes > 0 ? scene->bytes : bytes_of(options.input.path)};
  auto outcome = jobs::reduce_scene(std::move(request->job));
  if (!outcome) return tl::unexpected(std::move(outcome.error()));
  warn(outcome->warnings);
  scene->clips = outcome->clips();
  return page->write([&](const auto& head) { return page_of(*outcome, options.output.path, head); })
      .and_then([&] { return write_scene(options.output.path, *scene, request->writing); })
      .and_then([&] { return page->finish(); })
      .and_then([&] {
        report.outcome = std::move(*outcome);
        report.bytes_after = bytes_of(options.output.path);
        return summarise(options.summary, report);
      });
}

}  // namespace orispline::cli
