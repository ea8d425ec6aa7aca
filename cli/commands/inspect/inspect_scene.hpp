// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "commands/inspect/inspect.hpp"

namespace orispline::cli {

/// Whether what is asked for is about the whole file of skeletons, not about the curves of one joint.
[[nodiscard]] bool is_about_scene(const InspectArguments& options, const InputRequest& input);

/// Says what a file of skeletons holds: clips, joints, tracks, keys, sign flips, widest steps.
[[nodiscard]] Expected<void> inspect_scene(const InspectArguments& options, const InputRequest& input);

}  // namespace orispline::cli
