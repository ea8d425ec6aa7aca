// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "commands/reduce/reduce.hpp"

namespace orispline::cli {

/// All clips of a file of skeletons, or the motion of a file of keys, with fewer keys into a glTF file.
[[nodiscard]] Expected<void> reduce_scene(const ReduceArguments& options);
/// Whether these options are good for that. Error: bad_argument.
[[nodiscard]] Expected<void> check_reduce_scene(const ReduceArguments& options);

}  // namespace orispline::cli
