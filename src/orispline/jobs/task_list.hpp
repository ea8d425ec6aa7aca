// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <orispline/base/progress.hpp>
#include <orispline/base/warning.hpp>
#include <orispline/curve/track.hpp>
#include <orispline/fields/field_info.hpp>
#include <orispline/fields/json.hpp>
#include <orispline/jobs/align.hpp>
#include <orispline/jobs/align_rates.hpp>
#include <orispline/jobs/bake.hpp>
#include <orispline/jobs/clip.hpp>
#include <orispline/jobs/compare.hpp>
#include <orispline/jobs/curve_of_keys.hpp>
#include <orispline/jobs/difference.hpp>
#include <orispline/jobs/inspect.hpp>
#include <orispline/jobs/inspect_scene.hpp>
#include <orispline/jobs/mean.hpp>
#include <orispline/jobs/reduce.hpp>
#include <orispline/jobs/retime.hpp>
#include <orispline/jobs/smooth.hpp>
#include <orispline/jobs/tune.hpp>

// The tasks by their names: the one way by which the command and every binding run them. Recordings, skeletons and
// options go in; a document, sentences, tracks and skeletons come out. No file is read or written here.

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

/// What a task takes and makes: orientations at times, the rates of a gyro on a clock of their own, or the clips of a
/// skeleton.
using TaskValue =
    std::variant<std::shared_ptr<const Track>, std::shared_ptr<const GyroTrack>, std::shared_ptr<const MotionFile>>;

/// The kinds of values that an input takes.
struct TaskKinds {
  bool tracks = true, gyros = false, scenes = false;
};

/// An input, by the name that a task has for it.
struct TaskInput {
  std::string_view name, sentence;
  bool is_required = true;
  bool takes_several = false;
  TaskKinds takes{};
};

/// What a task takes beside the fields of its options.
struct TaskSetting {
  std::string_view name, sentence;
};

/// What only the reader of the inputs knows of them.
struct ReadingNotes {
  std::string mended{};         ///< what was mended, in words that summaries repeat
  KeyFaults faults{};           ///< what was mended for a look at keys
  bool rows_have_times = true;  ///< of their own, else they are numbers of rows
};

/// What somebody states for a task, by names. Options are texts as they are typed, or values in the units of the
/// library.
struct ORISPLINE_EXPORT TaskRequest {
  std::vector<std::pair<std::string, TaskValue>> inputs{};
  std::vector<std::pair<std::string, FieldValue>> options{};
  std::optional<ChosenMethod> method{};   ///< in the place of the option `method`
  std::vector<LabelledMethod> methods{};  ///< in the place of the option `methods`; none: the option holds
  std::vector<std::string> named{};       ///< labels of those of `methods` that are asked for by name, in that order
  std::vector<Decimation> decimations{};  ///< of `compare`, in the place of the options that state one
  ReadingNotes reading{};                 ///< of the inputs

  /// Null where no orientations of that name are stated.
  [[nodiscard]] std::shared_ptr<const Track> input(std::string_view name) const;
  /// Whatever is stated under that name; null where nothing is.
  [[nodiscard]] const TaskValue* value(std::string_view name) const;
  /// Null where none of that name is stated, or not as a text.
  [[nodiscard]] const std::string* option(std::string_view name) const;
  /// Null where none of that name is stated.
  [[nodiscard]] const FieldValue* stated(std::string_view name) const;
};

/// Whether one of the inputs is a skeleton.
[[nodiscard]] ORISPLINE_EXPORT bool has_scene(const TaskRequest& request);

/// What a task found, as its own function gives it. Pointers, so that a program is linked with those alone that it
/// makes.
template <class... Outcomes>
using OneOf = std::variant<std::shared_ptr<Outcomes>...>;
using TaskFinding = OneOf<SmoothOutcome, SmoothClipsOutcome, TuneOutcome, ReduceOutcome, ReduceSceneOutcome,
                          RetimeOutcome, RetimeClipsOutcome, BakeOutcome, MeanOutcome, AlignOutcome, RateAlignOutcome,
                          CompareOutcome, InspectOutcome, InspectSceneOutcome, DifferenceOutcome, ClipOutcome>;

/// What there is to say of a task that was done, and what it made.
struct TaskOutcome {
  Json document{};  ///< described in docs/inspect-json.md, but for the names of files and the warnings
  std::string summary{};
  std::vector<Warning> warnings{};
  std::vector<Track> tracks{};  ///< keys with the recipe of the curve that they are for
  std::string line{};           ///< the summary in one line without an end; empty where a task has none
  std::vector<GyroTrack> gyros{};
  std::vector<MotionFile> scenes{};
  TaskFinding finding{};             ///< null where there are parts
  std::vector<TaskOutcome> parts{};  ///< of several recordings one each, but for its tracks, which are among these
};

/// What the task found. Precondition: it is of that type.
template <class Finding>
[[nodiscard]] Finding& found(const TaskOutcome& outcome) {
  return *std::get<std::shared_ptr<Finding>>(outcome.finding);
}

/// What there is to say of one outcome, and the outcome itself.
template <class Outcome>
[[nodiscard]] TaskOutcome told(Outcome outcome, std::vector<Track> tracks = {}) {
  TaskOutcome all{.document = document_of(outcome), .summary = summary_of(outcome), .tracks = std::move(tracks)};
  if constexpr (requires { outcome.warnings; }) all.warnings = outcome.warnings;
  if constexpr (requires { line_of(outcome); }) all.line = line_of(outcome);
  all.finding = std::make_shared<Outcome>(std::move(outcome));
  return all;
}

/// A task on a skeleton with its clips.
struct TaskOnScene {
  Expected<TaskOutcome> (*run)(const TaskRequest& request,
                               const Progress& progress) = nullptr;  ///< null: there is none
  Expected<void> (*check)(const TaskRequest& request) = nullptr;     ///< as of TaskInfo
  std::vector<FieldInfo> options{};                                  ///< empty: those of the task
};

/// A task: what it takes and what it gives.
struct TaskInfo {
  std::string_view name, sentence;
  std::vector<FieldInfo> options, results;
  std::vector<TaskInput> inputs;
  std::vector<TaskSetting> settings;
  Expected<TaskOutcome> (*run)(const TaskRequest& request, const Progress& progress);
  /// Of the options, whatever the inputs are, of which those that are there may lack what they hold; null: nothing.
  Expected<void> (*check)(const TaskRequest& request) = nullptr;
  std::vector<FieldInfo> results_of_gyros{};  ///< in their place, where an input is of a gyro
  TaskOnScene on_scene{};                     ///< in its place, where an input is a skeleton
};

/// THE list of them.
[[nodiscard]] ORISPLINE_EXPORT std::vector<TaskInfo> tasks_info();

/// The task of that name in a list that lasts. Error (bad_argument): there is none.
[[nodiscard]] ORISPLINE_EXPORT Expected<const TaskInfo*> task_named(std::string_view name);

/// The options that it takes with these inputs: with a skeleton they may be others.
[[nodiscard]] ORISPLINE_EXPORT const std::vector<FieldInfo>& options_for(const TaskInfo& task,
                                                                         const TaskRequest& request);

/// That list, described in docs/inspect-json.md.
[[nodiscard]] ORISPLINE_EXPORT Json tasks_json();

/// Errors: bad_argument, of the option or the input, for a task, an input or an option that there is not or that stands
/// twice, for an input of another kind, and for one that is wanted and missing; those of typed_value(), and of the
/// task.
[[nodiscard]] ORISPLINE_EXPORT Expected<TaskOutcome> run_task(std::string_view name, const TaskRequest& request,
                                                              const Progress& progress = {});

/// What is wrong with the options before there are inputs, with the errors of run_task() about options.
[[nodiscard]] ORISPLINE_EXPORT Expected<void> check_task(std::string_view name, const TaskRequest& request);

/// The page of what was found, as one HTML file. With ORISPLINE_PAGE. `after`: what it calls clips that were changed,
/// such as the name of a file. Error (bad_argument): a task that has no page.
[[nodiscard]] ORISPLINE_EXPORT Expected<std::string> page_of(const TaskOutcome& outcome, const pages::PageHead& head,
                                                             std::string_view after = {});

// What each of them is.
[[nodiscard]] TaskInfo smooth_info();
[[nodiscard]] TaskInfo tune_info();
[[nodiscard]] TaskInfo reduce_info();
[[nodiscard]] TaskInfo reduce_tracks_info();  // without skeletons, for a program that has none
[[nodiscard]] TaskInfo retime_info();
[[nodiscard]] TaskInfo bake_info();
[[nodiscard]] TaskInfo mean_info();
[[nodiscard]] TaskInfo align_info();
[[nodiscard]] TaskInfo compare_info();
[[nodiscard]] TaskInfo inspect_info();
[[nodiscard]] TaskInfo difference_info();
[[nodiscard]] TaskInfo clip_info();

// How their options are checked, and how each of them is run.
[[nodiscard]] Expected<void> check_smooth(const TaskRequest& request);
[[nodiscard]] Expected<void> check_reduce(const TaskRequest& request);
[[nodiscard]] Expected<void> check_retime(const TaskRequest& request);
[[nodiscard]] Expected<void> check_bake(const TaskRequest& request);
[[nodiscard]] Expected<void> check_compare(const TaskRequest& request);
[[nodiscard]] Expected<void> check_reduce_scene(const TaskRequest& request);
[[nodiscard]] Expected<void> check_retime_scene(const TaskRequest& request);
[[nodiscard]] Expected<void> check_clip_edits(const TaskRequest& request);
template <class Options>
[[nodiscard]] Expected<void> check_typed(const TaskRequest& request);
[[nodiscard]] Expected<TaskOutcome> run_smooth(const TaskRequest& request, const Progress& progress);
[[nodiscard]] Expected<TaskOutcome> run_tune(const TaskRequest& request, const Progress& progress);
[[nodiscard]] Expected<TaskOutcome> run_reduce(const TaskRequest& request, const Progress& progress);
[[nodiscard]] Expected<TaskOutcome> run_retime(const TaskRequest& request, const Progress& progress);
[[nodiscard]] Expected<TaskOutcome> run_bake(const TaskRequest& request, const Progress& progress);
[[nodiscard]] Expected<TaskOutcome> run_mean(const TaskRequest& request, const Progress& progress);
[[nodiscard]] Expected<TaskOutcome> run_align(const TaskRequest& request, const Progress& progress);
[[nodiscard]] Expected<TaskOutcome> run_compare(const TaskRequest& request, const Progress& progress);
[[nodiscard]] Expected<TaskOutcome> run_inspect(const TaskRequest& request, const Progress& progress);
[[nodiscard]] Expected<TaskOutcome> run_smooth_scene(const TaskRequest& request, const Progress& progress);
[[nodiscard]] Expected<TaskOutcome> run_reduce_scene(const TaskRequest& request, const Progress& progress);
[[nodiscard]] Expected<TaskOutcome> run_retime_scene(const TaskRequest& request, const Progress& progress);
[[nodiscard]] Expected<TaskOutcome> run_inspect_scene(const TaskRequest& request, const Progress& progress);
[[nodiscard]] Expected<TaskOutcome> run_difference(const TaskRequest& request, const Progress& progress);
[[nodiscard]] Expected<TaskOutcome> run_clip(const TaskRequest& request, const Progress& progress);

}}}  // namespace orispline::jobs
