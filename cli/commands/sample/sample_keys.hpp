// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "commands/sample/sample.hpp"

namespace orispline::cli {

/// Samples the curve through keys: while they are read where that can be done, else through all of them in memory.
[[nodiscard]] Expected<void> sample_keys(const SampleArguments& options);

}  // namespace orispline::cli
