// SPDX-License-Identifier: Apache-2.0
#include "commands/inspect/inspect_scene.hpp"

#include <utility>

#include <orispline/jobs/inspect_scene.hpp>

#include "options/scene_input.hpp"
#include "output/json_document.hpp"
#include "output/report_file.hpp"
#include "output/standard_output.hpp"

namespace orispline::cli {

bool is_about_scene(const InspectArguments& options, const InputRequest& input) {
  return is_scene(input) && options.methods.empty() && !input.read.scene.joint;
}

Expected<void> inspect_scene(const InspectArguments& options, const InputRequest& input) {
  if (input.read.scene.space == io::SceneTrack::Space::world)
    return usage_failure("--space: found no joint, wanted --joint NAME as well");
  auto page = ReportFile::open(options.report);
  if (!page) return tl::unexpected(std::move(page.error()));
  auto scene = open_scene(input);
  if (!scene) return tl::unexpected(std::move(scene.error()));
  warn(scene->warnings);
  const auto outcome = jobs::inspect_scene({.file = {.name = scene->name,
                                                     .skeleton = std::move(scene->skeleton),
                                                     .clips = std::move(scene->clips),
                                                     .has_no_unit = scene->format->has_no_unit},
                                            .format = scene->format->title});
  Json json{{"input", outcome.request.file.name}, {"input_format", scene->format->id}};
  json.update(document_of(outcome));
  return page->write([&](const auto& head) { return page_of(outcome, head); })
      .and_then([&] { return print_document(options.json ? document(json) : summary_of(outcome)); })
      .and_then([&] { return page->finish(); });
}

}  // namespace orispline::cli
