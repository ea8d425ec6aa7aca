// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/scenes/scene_file.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes {

/// The scene with its lengths in metres, as in_metres() of its clips.
[[nodiscard]] Expected<Scene> in_metres(const Scene& scene, double metres);

}}}  // namespace orispline::scenes
