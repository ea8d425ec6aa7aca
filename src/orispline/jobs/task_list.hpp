// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <orispline/base/progress.hpp>
#include <orispline/base/warning.hpp>
#include <orispline/curve/track.hpp>
#include <orispline/fields/field_info.hpp>
#include <orispline/fields/json.hpp>

// The tasks by their names, for faces that know none of them: recordings and texts go in, a document, sentences and
// tracks come out.

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

/// Keys or recordings, by the name that a task has for them.
struct TaskInput {
  std::string_view name, sentence;
  bool is_required = true;
  bool takes_several = false;
};

/// What a task takes beside the fields of its options.
struct TaskSetting {
  std::string_view name, sentence;
};

/// What somebody states for a task, by names; texts as they are typed.
struct ORISPLINE_EXPORT TaskRequest {
  std::vector<std::pair<std::string, std::shared_ptr<const Track>>> inputs{};
  std::vector<std::pair<std::string, std::string>> options{};

  /// Null where nothing of that name is stated.
  [[nodiscard]] std::shared_ptr<const Track> input(std::string_view name) const;
  [[nodiscard]] const std::string* option(std::string_view name) const;
};

/// What there is to say of a task that was done, and what it made.
struct TaskOutcome {
  Json document{};  ///< described in docs/inspect-json.md, but for the names of files and the warnings
  std::string summary{};
  std::vector<Warning> warnings{};
  std::vector<Track> tracks{};  ///< keys with the recipe of the curve that they are for
};

/// A task: what it takes and what it gives.
struct TaskInfo {
  std::string_view name, sentence;
  std::vector<FieldInfo> options, results;
  std::vector<TaskInput> inputs;
  std::vector<TaskSetting> settings;
  Expected<TaskOutcome> (*run)(const TaskRequest& request, const Progress& progress);
  std::vector<FieldInfo> results_of_gyros{};  ///< in their place, where a face lets the task take such recordings too
};

/// THE list of them.
[[nodiscard]] ORISPLINE_EXPORT std::vector<TaskInfo> tasks_info();

/// That list, described in docs/inspect-json.md.
[[nodiscard]] ORISPLINE_EXPORT Json tasks_json();

/// Errors: bad_argument, of the option or the input, for a task, an input or an option that there is not or that stands
/// twice, and for one that is wanted and missing; those of typed_value(), and of the task.
[[nodiscard]] ORISPLINE_EXPORT Expected<TaskOutcome> run_task(std::string_view name, const TaskRequest& request,
                                                              const Progress& progress = {});

// What each of them is.
[[nodiscard]] TaskInfo smooth_info();
[[nodiscard]] TaskInfo tune_info();
[[nodiscard]] TaskInfo reduce_info();
[[nodiscard]] TaskInfo retime_info();
[[nodiscard]] TaskInfo bake_info();
[[nodiscard]] TaskInfo mean_info();
[[nodiscard]] TaskInfo align_info();
[[nodiscard]] TaskInfo compare_info();

// How each of them is run.
[[nodiscard]] Expected<TaskOutcome> run_smooth(const TaskRequest& request, const Progress& progress);
[[nodiscard]] Expected<TaskOutcome> run_tune(const TaskRequest& request, const Progress& progress);
[[nodiscard]] Expected<TaskOutcome> run_reduce(const TaskRequest& request, const Progress& progress);
[[nodiscard]] Expected<TaskOutcome> run_retime(const TaskRequest& request, const Progress& progress);
[[nodiscard]] Expected<TaskOutcome> run_bake(const TaskRequest& request, const Progress& progress);
[[nodiscard]] Expected<TaskOutcome> run_mean(const TaskRequest& request, const Progress& progress);
[[nodiscard]] Expected<TaskOutcome> run_align(const TaskRequest& request, const Progress& progress);
[[nodiscard]] Expected<TaskOutcome> run_compare(const TaskRequest& request, const Progress& progress);

}}}  // namespace orispline::jobs
