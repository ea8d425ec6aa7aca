// SPDX-License-Identifier: Apache-2.0
#include "commands/smooth/smooth_scene.hpp"

#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/jobs/smooth.hpp>

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
  orispline::SmoothOptions smoothing{};
  unsigned threads = 1;
};

Expected<void> check_clips(const SmoothArguments& options) {
  const std::string_view given = first_given(options.rows);
  if (given.empty()) return {};
  return usage_failure(
      formatted("{}: found a file of skeletons, whose keys are smoothed, wanted samples of one track", given));
}

Expected<SceneRequest> scene_request_in(const SmoothArguments& options) {
  if (auto fits = check_clips(options); !fits) return tl::unexpected(std::move(fits.error()));
  FirstError checked;
  SceneRequest request{.input = checked(input_request(options.input)),
                       .writing = checked(scene_writing(options.output)),
                       .smoothing = checked(smoothing_in(options.smoothness)),
                       .threads = static_cast<unsigned>(checked(threads_in(options.inputs.threads)))};
  return std::move(checked).or_else(std::move(request)).and_then([&](SceneRequest read) -> Expected<SceneRequest> {
    return check_files(options).map([&] { return std::move(read); });
  });
}

}  // namespace

Expected<void> check_smooth_scene(const SmoothArguments& options) {
  return scene_request_in(options).map([](const SceneRequest&) {});
}

Expected<void> smooth_scene(const SmoothArguments& options) {
  const auto request = scene_request_in(options);
  if (!request) return tl::unexpected(request.error());
  auto page = ReportFile::open(options.report);
  if (!page) return tl::unexpected(std::move(page.error()));
  if (auto able = check_output(options.output.path); !able) return able;
  auto scene = open_scene(request->input);
  if (!scene) return tl::unexpected(std::move(scene.error()));
  warn(scene->warnings);
  auto outcome = jobs::smooth_clips({.name = options.input.path,
                                     .skeleton = scene->skeleton,
                                     .clips = std::exchange(scene->clips, {}),
                                     .options = request->smoothing,
                                     .threads = request->threads,
                                     .has_no_unit = scene->format && scene->format->has_no_unit});
  if (!outcome) return tl::unexpected(said_of_cutoff(options.smoothness, std::move(outcome.error())));
  warn(outcome->warnings);
  for (const ClipSmoothing& smoothed : outcome->clips) scene->clips.push_back(smoothed.clip);
  return page->write([&](const auto& head) { return page_of(*outcome, options.output.path, head); })
      .and_then([&] { return write_scene(options.output.path, *scene, request->writing); })
      .and_then([&] { return page->finish(); })
      .and_then([&] {
        return summarise(options.summary, Written{options.input.path, options.output.path, "", std::move(*outcome)});
      });
}

}  // namespace orispline::cli
