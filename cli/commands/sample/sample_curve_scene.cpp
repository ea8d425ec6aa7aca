// SPDX-License-Identifier: Apache-2.0
#include "commands/sample/sample_curve_scene.hpp"

#include <string>
#include <string_view>
#include <utility>

#include <orispline/base/file_name.hpp>
#include <orispline/jobs/curve_clip.hpp>

#include "options/scene_input.hpp"
#include "output/scene_output.hpp"
#include "output/standard_output.hpp"
#include "output/summary.hpp"

namespace orispline::cli {

namespace {

/// A curve in a file of skeletons, as jobs::curve_clip() made it, and the names of the files.
struct CurveSceneReport {
  jobs::CurveClipOutcome outcome;
  std::string output{};
};

std::string text_of(const CurveSceneReport& report) { return summary_of(report.outcome); }

Json json_of(const CurveSceneReport& report) {
  Json json{{"input", report.outcome.request.source}, {"output", report.output}};
  json.update(document_of(report.outcome));
  return json;
}

jobs::CurveClipRequest clip_request(const SampleRequest& request, const CurveScene& source) {
  const std::string_view file = file_name_of(request.input.path);
  jobs::CurveClipRequest wanted{.name = std::string(file.substr(0, file.rfind('.'))),
                                .source = request.input.path,
                                .method = request.method.name,
                                .keys = source.keys,
                                .tolerance = request.tolerance,
                                .position_tolerance = request.position_tolerance};
  if (!request.tolerance)
    for (std::size_t k = 0; k < source.times.size(); ++k) wanted.sample_times.push_back(source.times[k].t);
  return wanted;
}

}  // namespace

Expected<void> write_curve_scene(const SampleArguments& options, const SampleRequest& request,
                                 const CurveScene& source) {
  const auto writing = scene_writing(options.output);
  if (!writing) return tl::unexpected(writing.error());
  if (scenes::scene_format_of(request.output) != &scenes::gltf_format)
    return usage_failure(
        "-o: found a file that holds every frame, wanted glTF, such as motion.glb; 'orispline convert "
        "--rate' makes BVH of it");
  if (!request.tolerance)
    if (auto fault = source.times.fault_as_keys()) return tl::unexpected(std::move(*fault));
  CurveSceneReport report{jobs::curve_clip(clip_request(request, source), source.curve), request.output};
  report.outcome.written_to = destination(request.output);
  warn(report.outcome.warnings);
  return Skeleton::make({{.name = "body"}}).and_then([&](Skeleton skeleton) {
    scenes::Scene scene{.skeleton = std::move(skeleton), .clips = {report.outcome.clip}};
    return write_scene(request.output, scene, *writing).and_then([&] { return summarise(options.summary, report); });
  });
}

}  // namespace orispline::cli
