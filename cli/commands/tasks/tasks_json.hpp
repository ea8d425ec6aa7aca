// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "commands/tasks/tasks_info.hpp"

namespace orispline::cli {

/// One JSON document, described in docs/inspect-json.md.
[[nodiscard]] std::string json_of(const std::vector<TaskInfo>& tasks);

}  // namespace orispline::cli
