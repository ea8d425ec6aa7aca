// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include <orispline/scenes/scene_file.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes {

/// The formats that are read through assimp: none where the library is built without it.
[[nodiscard]] std::span<const SceneFormat* const> assimp_formats() noexcept;

}}}  // namespace orispline::scenes
