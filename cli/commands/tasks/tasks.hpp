// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/base/expected.hpp>

namespace orispline::cli {

/// `orispline tasks`, as typed.
struct TasksArguments {
  bool json = false;
};

/// Lists the tasks of the library with the fields of their options and results.
[[nodiscard]] Expected<void> tasks(const TasksArguments& options);

}  // namespace orispline::cli
