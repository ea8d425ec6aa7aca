// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/scenes/scene_file.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes {

/// The scene with its lengths in metres: of the rest pose and of all clips.
///
/// `metres`: in the unit of length of its file. Errors (bad_argument): a number that is not finite and above 0, a file
/// whose lengths are in metres already.
[[nodiscard]] Expected<Scene> in_metres(Scene scene, double metres);

}}}  // namespace orispline::scenes
