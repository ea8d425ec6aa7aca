// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <initializer_list>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <orispline/fields/typed_options.hpp>
#include <orispline/jobs/task_list.hpp>

// What is stated for a task by names, read as what it stands for.

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

/// The options that are stated, all others at their defaults.
template <class Options>
[[nodiscard]] Expected<Options> options_in(const TaskRequest& request) {
  return stated_options<Options>([&request](std::string_view name) { return request.stated(name); });
}

[[nodiscard]] bool is_stated(const TaskRequest& request, std::string_view name);
[[nodiscard]] Expected<bool> flag(const TaskRequest& request, std::string_view name);
[[nodiscard]] Expected<unsigned> threads_in(const TaskRequest& request);
/// A number that is greater than 0; absent where none is stated.
[[nodiscard]] Expected<std::optional<double>> positive_in(const TaskRequest& request, std::string_view name,
                                                          std::string_view unit = {});
/// Absent where none are stated.
[[nodiscard]] Expected<std::optional<std::vector<LabelledMethod>>> methods_in(const TaskRequest& request);
/// The options of smoothing, with what is wrong whatever the recording is.
[[nodiscard]] Expected<SmoothOptions> smoothing_options_in(const TaskRequest& request);
/// An error about the smoothing time, which the user stated as a cut-off frequency, in terms of that; any other as it
/// is.
[[nodiscard]] Error with_cutoff(const TaskRequest& request, Error error);
/// Error (bad_argument, of the option): one of these is set, which inputs of another kind take.
[[nodiscard]] Expected<void> check_unset(const TaskRequest& request, std::initializer_list<std::string_view> names,
                                         std::string_view message);

}}}  // namespace orispline::jobs
