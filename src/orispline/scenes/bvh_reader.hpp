// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/scenes/scene_format.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::bvh {

/// A skeleton with one clip, named by the file, and a `Source`. Errors (bad_data) name the file and the line.
[[nodiscard]] Expected<Scene> read(std::string_view bytes, const std::string& path, const SceneReading& reading);

}}}  // namespace orispline::scenes::bvh
