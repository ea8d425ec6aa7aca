// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "commands/smooth/smooth.hpp"

namespace orispline::cli {

/// All joints of a file of skeletons, smoothed, in a file of skeletons.
[[nodiscard]] Expected<void> smooth_scene(const SmoothArguments& options);
/// Whether these options are good for that. Error: bad_argument.
[[nodiscard]] Expected<void> check_smooth_scene(const SmoothArguments& options);

}  // namespace orispline::cli
