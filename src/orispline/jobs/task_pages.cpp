// SPDX-License-Identifier: Apache-2.0
// Outcomes as pages, where pages are built (ORISPLINE_PAGE).
#include <optional>
#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/jobs/compare.hpp>
#include <orispline/jobs/reduce.hpp>
#include <orispline/jobs/reduce_scene.hpp>
#include <orispline/jobs/retime.hpp>
#include <orispline/jobs/smooth.hpp>
#include <orispline/pages/task_pages.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

report::Page page_of(const CompareOutcome& outcome, const pages::PageHead& head) {
  pages::ComparedCurves curves{.methods = outcome.methods,
                               .recording = outcome.data.recording(),
                               .epoch = outcome.data.epoch,
                               .named = outcome.request.named,
                               .measures = outcome.measures(),
                               .sorted_by = outcome.request.sort,
                               .inertia = outcome.request.inertia()};
  for (const ComparedKeys& keys : outcome.data.key_sets)
    curves.key_sets.push_back(keys.decimation ? name_of(*keys.decimation) : "");
  pages::PageHead titled = head;
  if (titled.title.empty()) titled.title = title_of(outcome, 0);
  return pages::compare_page(curves, titled, outcome.request.threads);
}

report::Page page_of(const ReduceOutcome& outcome, const pages::PageHead& head) {
  const auto& smoothed = outcome.smoothed;
  return pages::reduce_page(outcome.reduced(), outcome.reductions, outcome.options, head,
                            smoothed ? std::optional(smoothed->smoothing.smoothing_time) : std::nullopt);
}

report::SkeletonPage page_of(const ReduceSceneOutcome& outcome, std::string after, const pages::PageHead& head) {
  const ReduceSceneRequest& request = outcome.request;
  return pages::reduced_clips_page(
      {request.file.name, request.skeleton, request.clips}, std::move(after), outcome.reductions, outcome.options,
      {.metres = outcome.metres(), .are_known = outcome.knows_metres(), .shell = outcome.options.shell}, head,
      request.threads);
}

report::Page page_of(const RetimeOutcome& outcome, const pages::PageHead& head) {
  return pages::retime_page(*outcome.request.keys, outcome.retiming, outcome.request.options.limits, head);
}

report::Page page_of(const SmoothOutcome& outcome, pages::PageHead head) {
  for (Warning warning : outcome.warnings) {
    warning.where = {};
    head.notes.push_back(formatted("Warning: {}.", describe(warning)));
  }
  return pages::smooth_page(*outcome.request.recording, outcome.smoothing, head);
}

}}}  // namespace orispline::jobs
