// SPDX-License-Identifier: Apache-2.0
// Outcomes as pages, where pages are built (ORISPLINE_PAGE).
#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include <orispline/base/counted.hpp>
#include <orispline/base/file_name.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/jobs/compare.hpp>
#include <orispline/jobs/difference.hpp>
#include <orispline/jobs/reduce.hpp>
#include <orispline/jobs/retime.hpp>
#include <orispline/jobs/smooth.hpp>
#include <orispline/pages/task_pages.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

namespace {

std::vector<std::string> notes_on(const DifferenceOutcome& outcome) {
  const DifferenceRequest& request = outcome.request;
  std::vector<std::string> notes{
      formatted("Both motions are compared at every key of {}{}.", file_name_of(request.first.name),
                request.rate ? formatted(", and {:g} times per second as well", *request.rate) : "")};
  for (const auto& [file, clips] :
       {std::pair{&request.first, &outcome.only_in_first}, {&request.second, &outcome.only_in_second}})
    if (!clips->empty())
      notes.push_back(formatted("Only {} has {}, such as {}; not compared.", file_name_of(file->name),
                                counted(clips->size(), "more clip"), in_quotes(clips->front())));
  for (Warning warning : outcome.warnings) {
    warning.where = {};
    notes.push_back(formatted("Warning: {}.", describe(warning)));
  }
  return notes;
}

}  // namespace

report::Page page_of(const CompareOutcome& outcome, const pages::PageHead& head) {
  pages::ComparedCurves curves{.methods = outcome.methods,
                               .recording = outcome.data.recording(),
                               .epoch = outcome.data.epoch,
                               .named = outcome.request.named,
                               .measures = outcome.measures(),
                               .sorted_by = outcome.request.sort,
                               .inertia = outcome.request.inertia()};
  if (!outcome.request.reference) curves.gap = outcome.request.keys->recipe.gap;
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

report::SkeletonPage page_of(const DifferenceOutcome& outcome, const pages::PageHead& head) {
  const auto& [first, second, shell, rate, threads] = outcome.request;
  pages::PageHead with_notes = head;
  std::ranges::move(notes_on(outcome), std::back_inserter(with_notes.notes));
  std::vector<pages::ClipPair> pairs;
  for (const ClipDifference& clip : outcome.clips) pairs.push_back({clip.first, clip.second, clip.times});
  return pages::skeleton_page({first.name, first.skeleton, first.clips}, {second.name, second.skeleton, second.clips},
                              pairs, {.are_known = !first.has_no_unit && !second.has_no_unit, .shell = shell},
                              with_notes, threads);
}

}}}  // namespace orispline::jobs
