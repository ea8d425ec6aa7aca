// SPDX-License-Identifier: Apache-2.0
#include "commands/difference/difference.hpp"

#include <utility>

#include <orispline/fields.hpp>
#include <orispline/jobs/difference.hpp>
#include <orispline/scenes/scene_file.hpp>
#include <orispline/scenes/scene_tracks.hpp>

#include "options/option_text.hpp"
#include "output/json_document.hpp"
#include "output/report_file.hpp"
#include "output/standard_output.hpp"

namespace orispline::cli {

namespace {

Expected<scenes::Scene> opened(const std::string& path) {
  return scenes::read_scene(path).map([](scenes::Scene scene) {
    warn(scene.warnings);
    return scene;
  });
}

/// The chosen clips. The only clip of both files is the one that is compared, whatever its name in the second.
Expected<scenes::Scene> with_chosen(scenes::Scene scene, const std::vector<std::string>& clips, bool is_second) {
  if (is_second && scene.clips.size() == 1 && clips.size() == 1) return scene;
  return scenes::with_clips(std::move(scene), clips);
}

Expected<jobs::MotionFile> motion_in(const DifferenceArguments& options, const std::string& path, bool is_second) {
  return opened(path)
      .and_then([&](scenes::Scene scene) { return with_chosen(std::move(scene), options.clips, is_second); })
      .map([&](scenes::Scene scene) {
        return jobs::MotionFile{.name = path,
                                .skeleton = std::move(scene.skeleton),
                                .clips = std::move(scene.clips),
                                .has_no_unit = scene.format->has_no_unit};
      });
}

Expected<jobs::DifferenceRequest> request_in(const DifferenceArguments& options) {
  FirstError checked;
  jobs::DifferenceRequest request;
  request.shell = checked(options_in<ClipReduceOptions>(options.shell)).shell;
  if (options.rate) request.rate = checked(positive_in({"--rate", *options.rate}));
  request.first = checked(motion_in(options, options.first, false));
  request.second = checked(motion_in(options, options.second, true));
  return std::move(checked).or_else(std::move(request));
}

}  // namespace

Expected<void> difference(const DifferenceArguments& options) {
  if (auto apart = check_report(options.report, {{"FIRST", options.first}, {"SECOND", options.second}}); !apart)
    return apart;
  auto page = ReportFile::open(options.report);
  if (!page) return tl::unexpected(std::move(page.error()));
  auto outcome = request_in(options).and_then(
      [](jobs::DifferenceRequest request) { return jobs::difference(std::move(request)); });
  if (!outcome) return tl::unexpected(std::move(outcome.error()));
  warn(outcome->warnings);
  return page->write([&](const auto& head) { return page_of(*outcome, head); })
      .and_then([&] { return print_document(options.json ? document(document_of(*outcome)) : summary_of(*outcome)); })
      .and_then([&] { return page->finish(); });
}

}  // namespace orispline::cli
