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
#include <orispline/families/registry.hpp>
#include <orispline/jobs/clip.hpp>
#include <orispline/jobs/compare.hpp>
#include <orispline/jobs/curve_of_keys.hpp>
#include <orispline/jobs/difference.hpp>
#include <orispline/jobs/inspect.hpp>
#include <orispline/jobs/inspect_scene.hpp>
#include <orispline/jobs/reduce.hpp>
#include <orispline/jobs/retime.hpp>
#include <orispline/jobs/smooth.hpp>
#include <orispline/jobs/task_list.hpp>
#include <orispline/pages/task_pages.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

namespace {

/// As notes, without the file that the page is about anyway.
void add_warnings(std::vector<std::string>& notes, const std::vector<Warning>& warnings) {
  for (Warning warning : warnings) {
    warning.where = {};
    notes.push_back(formatted("Warning: {}.", describe(warning)));
  }
}

std::vector<std::string> notes_on(const DifferenceOutcome& outcome) {
  const DifferenceRequest& request = outcome.request;
  std::vector<std::string> notes{formatted(
      "Both motions are compared at every key of {}{}.", file_name_of(request.first.name),
      request.rate ? formatted(", {:g} times per second, and where they differ most between these times", *request.rate)
                   : "")};
  for (const auto& [file, clips] :
       {std::pair{&request.first, &outcome.only_in_first}, {&request.second, &outcome.only_in_second}})
    if (!clips->empty())
      notes.push_back(formatted("Only {} has {}, such as {}; not compared.", file_name_of(file->name),
                                counted(clips->size(), "more clip"), in_quotes(clips->front())));
  add_warnings(notes, outcome.warnings);
  return notes;
}

/// At which a clip was compared, and at which its joints differ most, which may be between these.
std::vector<double> times_of(const ClipDifference& clip) {
  std::vector<double> times = clip.times;
  for (const JointDifference& worst : clip.worst)
    for (const LargestInTime& largest : {worst.angle, worst.translation, worst.distance}) times.push_back(largest.time);
  std::ranges::sort(times);
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

Seam seam_of(const Method& method) { return method.options.loop ? Seam::closed : Seam::open; }

/// Of the method that the keys are for, else of the default one. Its warnings become notes.
pages::MethodOnKeys usual_curve(const Track& keys, std::vector<std::string>& notes) {
  auto chosen = chosen_method(std::nullopt, keys, {});
  if (!chosen) return {std::string(default_method), tl::unexpected(std::move(chosen.error()))};
  auto curve = curve_of_keys(chosen->method, keys);
  if (!curve) return {chosen->method.name, tl::unexpected(std::move(curve.error()))};
  add_warnings(notes, curve->warnings);
  return {chosen->method.name, std::move(curve->curve), seam_of(chosen->method)};
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

report::Page page_of(const InspectOutcome& outcome, pages::PageHead head) {
  const Track& keys = *outcome.request.keys;
  if (const auto& defect = outcome.request.faults.defect)
    head.notes.push_back(formatted("Warning: the keys were mended for this page; other commands say: {}.", *defect));
  add_warnings(head.notes, outcome.warnings);
  std::vector<pages::MethodOnKeys> shown;
  for (std::size_t i = 0; i < outcome.methods.size(); ++i)
    shown.push_back({outcome.methods[i].label, outcome.curves[i], seam_of(outcome.request.methods[i])});
  if (shown.empty()) shown.push_back(usual_curve(keys, head.notes));
  return pages::keys_page(keys, shown, head);
}

report::SkeletonPage page_of(const InspectSceneOutcome& outcome, const pages::PageHead& head) {
  const MotionFile& file = outcome.request.file;
  return pages::scene_page({file.name, file.skeleton, file.clips}, {.are_known = !file.format.has_no_unit}, head);
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
      {.are_known = !request.file.format.has_no_unit, .shell = outcome.options.shell}, head, request.threads);
}

report::Page page_of(const RetimeOutcome& outcome, const pages::PageHead& head) {
  return pages::retime_page(*outcome.request.keys, outcome.retiming, outcome.request.options.limits, head);
}

report::Page page_of(const SmoothOutcome& outcome, pages::PageHead head) {
  add_warnings(head.notes, outcome.warnings);
  return pages::smooth_page(*outcome.request.recording, outcome.smoothing, head);
}

report::SkeletonPage page_of(const SmoothClipsOutcome& outcome, std::string after, pages::PageHead head) {
  const SmoothClipsRequest& request = outcome.request;
  add_warnings(head.notes, outcome.warnings);
  return pages::smoothed_clips_page({request.name, request.skeleton, request.clips}, std::move(after), outcome.clips,
                                    {.are_known = !request.has_no_unit}, head, request.threads);
}

report::SkeletonPage page_of(const DifferenceOutcome& outcome, const pages::PageHead& head) {
  const auto& [first, second, shell, rate, threads] = outcome.request;
  pages::PageHead with_notes = head;
  std::ranges::move(notes_on(outcome), std::back_inserter(with_notes.notes));
  std::vector<pages::ClipPair> pairs;
  for (const ClipDifference& clip : outcome.clips) pairs.push_back({clip.first, clip.second, times_of(clip)});
  return pages::skeleton_page(
      {first.name, first.skeleton, first.clips}, {second.name, second.skeleton, second.clips}, pairs,
      {.are_known = !first.format.has_no_unit && !second.format.has_no_unit, .shell = shell}, with_notes, threads);
}

namespace {

/// Of clips that a task made of those of a file.
template <class Outcome>
report::SkeletonPage page_of_made(const Outcome& outcome, std::string after, pages::PageHead head) {
  const MotionFile& file = outcome.request.file;
  add_warnings(head.notes, outcome.warnings);
  std::vector<Clip> clips;
  for (const auto& made : outcome.clips) clips.push_back(made.clip);
  return pages::scene_page({after.empty() ? file.name : std::move(after), file.skeleton, clips},
                           {.are_known = !file.format.has_no_unit}, head, outcome.request.threads);
}

}  // namespace

report::SkeletonPage page_of(const ClipOutcome& outcome, std::string after, pages::PageHead head) {
  return page_of_made(outcome, std::move(after), std::move(head));
}

report::SkeletonPage page_of(const RetimeClipsOutcome& outcome, std::string after, pages::PageHead head) {
  return page_of_made(outcome, std::move(after), std::move(head));
}

namespace {

/// The document of the page of one finding; of a task without a page none.
struct PageOfFinding {
  const pages::PageHead& head;
  std::string_view after;

  [[nodiscard]] static std::string html(const report::Page& page) { return report::document(page); }
  [[nodiscard]] static std::string html(const report::SkeletonPage& page) { return report::skeleton_document(page); }

  template <class Outcome>
  [[nodiscard]] std::optional<std::string> operator()(const std::shared_ptr<Outcome>& found) const {
    const Outcome& outcome = *found;
    if constexpr (requires { page_of(outcome, head); }) return html(page_of(outcome, head));
    else if constexpr (requires { page_of(outcome, std::string(after), head); })
      return html(page_of(outcome, std::string(after), head));
    else return std::nullopt;
  }
};

}  // namespace

Expected<std::string> page_of(const TaskOutcome& outcome, const pages::PageHead& head, std::string_view after) {
  if (!outcome.parts.empty())
    return failure(ErrorCode::bad_argument,
                   formatted("found {} results, wanted one: a page shows one", outcome.parts.size()));
  auto page = std::visit(PageOfFinding{head, after}, outcome.finding);
  if (!page) return failure(ErrorCode::bad_argument, "found a task without a page, wanted one that has a page");
  return *std::move(page);
}

}}}  // namespace orispline::jobs
