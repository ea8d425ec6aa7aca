// SPDX-License-Identifier: Apache-2.0
#include "commands/sample/sample_skeleton.hpp"

#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/jobs/task_list.hpp>

#include "options/file_places.hpp"
#include "options/scene_input.hpp"
#include "output/scene_output.hpp"
#include "output/summary.hpp"

namespace orispline::cli {

namespace {

/// What `sample` takes of a whole skeleton.
Expected<void> check_options(const SampleArguments& options) {
  RowOptions others = options.rows;
  others.rate.reset();
  others.include_end = false;  // as every sampled skeleton has it
  if (const auto given = first_given(others); !given.empty())
    return usage_failure(
        formatted("{}: found a skeleton as a whole, which takes --rate alone, wanted --joint NAME and an output of one "
                  "track, such as CSV",
                  given));
  if (any_given(options.shape) || options.truth)
    return usage_failure(
        formatted("{}: found a skeleton as a whole, which keeps the motion of its file, wanted --joint NAME and an "
                  "output of one track, such as CSV",
                  options.truth ? "--truth" : first_given(options.shape)));
  if (!options.rows.rate)
    return usage_failure("--rate is missing for a skeleton as a whole; 'orispline convert' keeps its keys");
  return check_output_apart(options.output.option, options.output.path, {{"INPUT", options.input.path}});
}

}  // namespace

Expected<void> sample_skeleton(const SampleArguments& options) {
  if (auto sound = check_options(options); !sound) return sound;
  FirstError checked;
  const InputRequest input = checked(input_request(options.input));
  const scenes::SceneWriting writing = checked(scene_writing(options.output));
  auto scene = std::move(checked).or_else(input).and_then(open_scene);
  if (!scene) return tl::unexpected(std::move(scene.error()));
  warn(scene->warnings);
  const jobs::TaskRequest request{.inputs = {{"scene", motion_of(options.input.path, *scene)}},
                                  .options = {{"rate", *options.rows.rate}}};
  auto outcome = jobs::run_task("clip", request);
  if (!outcome) return tl::unexpected(std::move(outcome.error()));
  warn(outcome->warnings);
  return write_edited_scene(options.output.path, *std::move(scene), writing, *outcome).and_then([&] {
    return summarise(options.summary,
                     Written{options.input.path, options.output.path, "", jobs::found<jobs::ClipOutcome>(*outcome)});
  });
}

}  // namespace orispline::cli
