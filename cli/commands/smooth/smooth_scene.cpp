// SPDX-License-Identifier: Apache-2.0
#include "commands/smooth/smooth_scene.hpp"

#include <algorithm>
#include <utility>

#include <orispline/base/counted.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/math/degrees.hpp>
#include <orispline/smooth/clip_smoothing.hpp>

#include "options/file_places.hpp"
#include "options/scene_input.hpp"
#include "options/threads.hpp"
#include "output/noted_output.hpp"
#include "output/scene_output.hpp"
#include "output/smoothing_text.hpp"
#include "output/standard_output.hpp"

namespace orispline::cli {

namespace {

/// The command line, understood.
struct SceneRequest {
  InputRequest input{};
  scenes::SceneWriting writing{};
  orispline::SmoothOptions smoothing{};
  unsigned threads = 1;
};

/// What `orispline smooth` did to the clips of a scene.
struct SmoothSceneReport {
  std::string input{}, output{};
  const Skeleton& skeleton;
  const std::vector<ClipSmoothing>& clips;
};

std::size_t joints_in(const SmoothSceneReport& report) {
  std::size_t joints = 0;
  for (const ClipSmoothing& clip : report.clips) joints += clip.joints.size();
  return joints;
}

std::string line_of(const SmoothSceneReport& report, const ClipSmoothing::OfJoint& joint) {
  const orispline::Smoothing& found = joint.smoothing;
  return formatted("  {:<24}{:>12.4g} s{:>12.4g}°{:>10}{:>14.4g}°\n", printable(report.skeleton[joint.joint].name),
                   found.smoothing_time, found.noise * degrees, found.rejected.size(), joint.largest_change * degrees);
}

/// Where a rotation was changed most: motion that counts as an outlier is seen there.
std::string changes_text(const SmoothSceneReport& report) {
  const ClipSmoothing* clip = nullptr;
  const ClipSmoothing::OfJoint* worst = nullptr;
  for (const ClipSmoothing& other : report.clips)
    for (const ClipSmoothing::OfJoint& joint : other.joints)
      if (!worst || joint.largest_change > worst->largest_change) clip = &other, worst = &joint;
  if (!worst) return "";
  return formatted("largest change  {:.4g}° at {:.6g} s, {}\n", worst->largest_change * degrees, worst->change_at,
                   place_of(report.skeleton, clip->clip, worst->joint));
}

std::string text_of(const SmoothSceneReport& report) {
  std::size_t left = 0;
  for (const ClipSmoothing& clip : report.clips) left += clip.left;
  std::string text = formatted("{} of {} from {} smoothed; {} left as they are: they rest or have too few keys\n",
                               counted(joints_in(report), "rotation"), counted(report.clips.size(), "clip"),
                               printable(report.input), left);
  if (report.clips.size() == 1 && joints_in(report) > 0) {
    text += formatted("  {:<24}{:>14}{:>13}{:>10}{:>15}\n", "joint", "smoothing time", "noise", "rejected",
                      "largest change");
    for (const ClipSmoothing::OfJoint& joint : report.clips.front().joints) text += line_of(report, joint);
  }
  return text + changes_text(report) + formatted("written to {}\n", destination(report.output));
}

Json json_of(const SmoothSceneReport& report) {
  Json clips = Json::array();
  for (const ClipSmoothing& clip : report.clips) {
    Json joints = Json::array();
    for (const auto& [joint, found, change, at] : clip.joints)
      joints.push_back({{"joint", report.skeleton[joint].name},
                        {"smoothing_time_s", found.smoothing_time},
                        {"noise_deg", found.noise * degrees},
                        {"rejected", found.rejected.size()},
                        {"change_max_deg", change * degrees},
                        {"change_max_time_s", at}});
    Json json{{"clip", clip.clip.name}, {"left", clip.left}, {"refused", clip.refused.size()}};
    json["joints"] = std::move(joints);
    clips.push_back(std::move(json));
  }
  Json json{{"input", report.input}, {"output", report.output}};
  json["clips"] = std::move(clips);
  return json;
}

/// One line for all rotations that cannot be smoothed.
void warn_of_refused(const std::vector<ClipSmoothing>& clips, const SmoothOptions& options) {
  std::size_t refused = 0;
  const Error* first = nullptr;
  for (const ClipSmoothing& clip : clips) {
    refused += clip.refused.size();
    if (!first && !clip.refused.empty()) first = &clip.refused.front();
  }
  if (first)
    warn(formatted("left as it is what cannot be smoothed: {}; {}", counted(refused, "rotation"),
                   describe(said_of_cutoff(options.smoothness, *first))));
}

Expected<void> check_clips(const SmoothOptions& options) {
  if (options.rate || options.include_end)
    return usage_failure(
        formatted("{}: found a file of skeletons, whose keys are smoothed, wanted samples of one track",
                  options.rate ? "--rate" : "--include-end"));
  if (options.report.path)
    return usage_failure("--report: found a file of skeletons, wanted keys of one track as the output");
  if (is_given(options.smoothness.fields, "sigma"))
    return usage_failure(
        "--sigma: found a file of skeletons, which has no room for standard deviations, wanted a CSV file");
  return {};
}

Expected<SceneRequest> scene_request_in(const SmoothOptions& options) {
  if (auto fits = check_clips(options); !fits) return tl::unexpected(std::move(fits.error()));
  FirstError checked;
  SceneRequest request{.input = checked(input_request(options.input)),
                       .writing = checked(scene_writing(options.output)),
                       .smoothing = checked(smoothing_in(options.smoothness)),
                       .threads = static_cast<unsigned>(checked(threads_in(options.inputs.threads)))};
  return std::move(checked).or_else(std::move(request)).and_then([&](SceneRequest read) -> Expected<SceneRequest> {
    if (auto apart = check_output_apart(options.output.option, options.output.path, {{"INPUT", options.input.path}});
        !apart)
      return tl::unexpected(std::move(apart.error()));
    return check_summary(options.summary, options.output.path, "keys").map([&] { return std::move(read); });
  });
}

}  // namespace

Expected<void> check_smooth_scene(const SmoothOptions& options) {
  return scene_request_in(options).map([](const SceneRequest&) {});
}

Expected<void> smooth_scene(const SmoothOptions& options) {
  const auto request = scene_request_in(options);
  if (!request) return tl::unexpected(request.error());
  if (auto able = check_output(options.output.path); !able) return able;
  auto scene = open_scene(request->input);
  if (!scene) return tl::unexpected(std::move(scene.error()));
  warn(scene->warnings);
  auto clips = orispline::smooth_clips(scene->skeleton, scene->clips, request->smoothing, request->threads);
  if (!clips) {
    clips.error().where.file = options.input.path;
    return tl::unexpected(said_of_cutoff(options.smoothness, std::move(clips.error())));
  }
  warn_of_refused(*clips, options);
  for (std::size_t i = 0; i < clips->size(); ++i) scene->clips[i] = (*clips)[i].clip;
  return write_scene(options.output.path, *scene, request->writing).and_then([&] {
    return summarise(options.summary,
                     SmoothSceneReport{options.input.path, options.output.path, scene->skeleton, *clips});
  });
}

}  // namespace orispline::cli
