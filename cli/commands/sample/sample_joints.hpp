// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "commands/sample/sample.hpp"

namespace orispline::cli {

/// Samples every joint that moves, or the one that is named, into a file CLIP/JOINT for each clip: in the output folder
/// where the input is the only one, else in a folder there that has the name of the input. Where a joint cannot be
/// sampled nothing is written.
[[nodiscard]] Expected<void> sample_joints(const SampleArguments& options);

}  // namespace orispline::cli
