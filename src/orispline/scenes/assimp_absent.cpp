// SPDX-License-Identifier: Apache-2.0
#include <orispline/scenes/assimp.hpp>

namespace orispline::inline ORISPLINE_ABI::scenes {

std::span<const SceneFormat* const> assimp_formats() noexcept { return {}; }

}  // namespace orispline::inline ORISPLINE_ABI::scenes
