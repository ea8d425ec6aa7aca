// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "commands/convert/convert.hpp"

namespace orispline::cli {

/// A file of skeletons, or of keys as the motion of one joint, as a file of skeletons.
[[nodiscard]] Expected<void> convert_scene(const ConvertArguments& options, const InputRequest& input);

}  // namespace orispline::cli
