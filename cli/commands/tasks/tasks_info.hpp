// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

#include <orispline/fields/field_info.hpp>

namespace orispline::cli {

/// A task of the library: the fields that it takes and those that it gives.
struct TaskInfo {
  std::string_view name, sentence;
  std::vector<FieldInfo> options, results;
  std::vector<FieldInfo> results_of_gyros{};  ///< in their place, where the task takes such recordings too
};

/// THE list of them.
[[nodiscard]] std::vector<TaskInfo> tasks_info();

}  // namespace orispline::cli
