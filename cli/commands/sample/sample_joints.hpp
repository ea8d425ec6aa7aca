// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "commands/sample/sample.hpp"

// Joints of files of skeletons, sampled as their files say that they move.

namespace orispline::cli {

/// Samples the one joint that is chosen.
[[nodiscard]] Expected<void> sample_joint(const SampleArguments& options);

/// Samples every joint that moves, or the one that is named, into a file CLIP/JOINT for each clip: in the output folder
/// where the input is the only one, else in a folder there that has the name of the input. Where a joint cannot be
/// sampled nothing is written.
[[nodiscard]] Expected<void> sample_joints(const SampleArguments& options);

}  // namespace orispline::cli
