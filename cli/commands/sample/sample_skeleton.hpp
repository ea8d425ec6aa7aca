// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "commands/sample/sample.hpp"

namespace orispline::cli {

/// A skeleton as a whole with even keys, from a file of skeletons to another one: the task `clip` with a rate alone.
[[nodiscard]] Expected<void> sample_skeleton(const SampleArguments& options);

}  // namespace orispline::cli
