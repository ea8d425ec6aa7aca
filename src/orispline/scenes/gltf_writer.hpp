// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <orispline/scenes/scene_format.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::gltf {

/// The scene as a GLB, or as text where the path ends in `.gltf`. Errors (bad_data): what glTF cannot hold.
[[nodiscard]] Expected<SceneWritten> written_scene(const Scene& scene, const std::string& path,
                                                   const SceneWriting& writing);

}}}  // namespace orispline::scenes::gltf
