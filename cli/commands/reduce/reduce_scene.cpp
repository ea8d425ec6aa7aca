// SPDX-License-Identifier: Apache-2.0
#include "commands/reduce/reduce_scene.hpp"

#include <algorithm>
#include <filesystem>
#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/math/degrees.hpp>
#include <orispline/pages/task_pages.hpp>
#include <orispline/reduce/reduce_fields.hpp>
#include <orispline/scenes/scene_file.hpp>

#include "commands/reduce/reduce_scene_report.hpp"
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
  double metres = 1.0;  ///< in a unit of length of the file
  orispline::ClipReduceOptions reduction{};
  unsigned threads = 1;
};

Expected<Method> scene_method_in(const ReduceOptions& options) {
  if (options.method == smallest_method || options.method == cubicspline_method) {
    if (any_given(options.shape))
      return usage_failure(formatted("{}: found the method {}, which has no such option, wanted another --method",
                                     first_given(options.shape), cubicspline_method));
    return Method{cubicspline_method};
  }
  return method_request(options.method, options.shape);
}

/// What is not for clips.
Expected<void> check_clips(const ReduceOptions& options) {
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

Expected<orispline::ClipReduceOptions> clip_reduction_in(const ReduceOptions& options, double metres) {
  TypedFields typed = options.scene;
  for (const std::string_view name : {"tolerance", "position_tolerance"})
    if (const auto found = options.reduction.find(name); found != options.reduction.end()) typed[name] = found->second;
  return options_in<orispline::ClipReduceOptions>(typed).map([&](orispline::ClipReduceOptions found) {
    for (double* const length : {&found.position_tolerance, &found.world_tolerance, &found.shell}) *length /= metres;
    found.precision = orispline::KeyPrecision::float32;
    found.closed = options.closed;
    return found;
  });
}

Expected<double> metres_in(const ReduceOptions& options, const InputRequest& input) {
  if (options.position_scale) return positive_in({"--position-scale", *options.position_scale});
  const scenes::SceneFormat* const format = scene_format_of(input);
  const bool bounds_world = is_given(options.scene, "world_tolerance");
  if (!format || !format->has_no_unit || !(bounds_world || is_given(options.reduction, "position_tolerance")))
    return 1.0;
  return usage_failure(
      formatted("{}: found {}, which has no unit of length, wanted --position-scale as well, "
                "such as 0.01 for centimetres",
                bounds_world ? "--world-tolerance" : "--position-tolerance", format->file));
}

Expected<SceneRequest> scene_request_in(const ReduceOptions& options) {
  if (auto fits = check_clips(options); !fits) return tl::unexpected(std::move(fits.error()));
  FirstError checked;
  SceneRequest request{.input = checked(input_request(options.input)),
                       .writing = checked(scene_writing(options.output)),
                       .reduction = {},
                       .threads = static_cast<unsigned>(checked(threads_in(options.inputs.threads)))};
  request.metres = checked(metres_in(options, request.input));
  request.reduction = checked(clip_reduction_in(options, request.metres > 0.0 ? request.metres : 1.0));
  request.reduction.method = checked(scene_method_in(options));
  return std::move(checked).or_else(std::move(request)).and_then([&](SceneRequest read) -> Expected<SceneRequest> {
    if (auto apart = check_output_apart(options.output.option, options.output.path, {{"INPUT", options.input.path}});
        !apart)
      return tl::unexpected(std::move(apart.error()));
    return check(read.reduction)
        .and_then([&] { return check_summary(options.summary, options.output.path, "keys"); })
        .and_then([&] {
          return check_report(options.report,
                              {{place_of_output(options.output), options.output.path}, {"INPUT", options.input.path}});
        })
        .map([&] { return std::move(read); });
  });
}

/// 0 where it is not known.
std::size_t bytes_of(const std::string& path) {
  std::error_code none;
  const auto bytes = std::filesystem::file_size(path, none);
  return none ? 0 : static_cast<std::size_t>(bytes);
}

/// Where keys stay that single precision cannot hold within the tolerance.
void warn_of_precision(const SceneRequest& request, const std::vector<ClipReduction>& reductions) {
  double angle = 0.0, distance = 0.0;
  for (const ClipReduction& reduction : reductions) {
    angle = std::max(angle, reduction.angle.largest.value);
    distance = std::max(distance, reduction.distance.largest.value);
  }
  const auto say = [](std::string_view option, double found, double tolerance, std::string_view unit) {
    if (found > tolerance)
      warn(
          formatted("{}: found {:.4g}{} in the file, more than {:.4g}{}: glTF holds times and numbers in single "
                    "precision, and keys that were to be nearer stay as they are",
                    option, found, unit, tolerance, unit));
  };
  say("--tolerance", angle * degrees, request.reduction.tolerance * degrees, "°");
  say("--world-tolerance", distance * request.metres, request.reduction.world_tolerance * request.metres, " m");
}

std::vector<Clip> clips_of(const std::vector<ClipReduction>& reductions) {
  std::vector<Clip> clips;
  for (const ClipReduction& reduction : reductions) clips.push_back(reduction.clip);
  return clips;
}

}  // namespace

Expected<void> check_reduce_scene(const ReduceOptions& options) {
  return scene_request_in(options).map([](const SceneRequest&) {});
}

Expected<void> reduce_scene(const ReduceOptions& options) {
  auto request = scene_request_in(options);
  if (!request) return tl::unexpected(request.error());
  auto page = ReportFile::open(options.report);
  if (!page) return tl::unexpected(std::move(page.error()));
  if (auto able = check_output(options.output.path); !able) return able;
  auto scene = open_scene(request->input);
  if (!scene) return tl::unexpected(std::move(scene.error()));
  warn(scene->warnings);
  const scenes::SceneFormat* const format = scene->format;  // null for keys of a table
  if (format && format->holds_floats) request->reduction.precision_before = orispline::KeyPrecision::float32;
  auto reductions = orispline::reduce_clips(scene->skeleton, scene->clips, request->reduction, request->threads);
  if (!reductions) {
    reductions.error().where.file = options.input.path;
    return tl::unexpected(std::move(reductions.error()));
  }
  warn_of_precision(*request, *reductions);
  const std::vector<Clip> before = std::exchange(scene->clips, clips_of(*reductions));
  ReduceSceneReport report{.input = options.input.path,
                           .output = options.output.path,
                           .skeleton = scene->skeleton,
                           .options = request->reduction,
                           .metres = request->metres,
                           .unit = format && format->has_no_unit && !options.position_scale ? "" : " m",
                           .reductions = *std::move(reductions),
                           .bytes_before = bytes_of(options.input.path)};
  const auto make_page = [&](const auto& head) {
    return pages::reduced_clips_page(
        {report.input, scene->skeleton, before}, report.output, report.reductions, report.options,
        {.metres = report.metres, .are_known = !report.unit.empty(), .shell = report.options.shell}, head,
        request->threads);
  };
  return page->write(make_page)
      .and_then([&] { return write_scene(options.output.path, *scene, request->writing); })
      .and_then([&] { return page->finish(); })
      .and_then([&] {
        report.bytes_after = bytes_of(options.output.path);
        return summarise(options.summary, report);
      });
}

}  // namespace orispline::cli
