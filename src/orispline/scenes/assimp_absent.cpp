// SPDX-License-Identifier: Apache-2.0
#include <orispline/scenes/assimp.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes {

std::span<const SceneFormat* const> assimp_formats() noexcept { return {}; }

}}}  // namespace orispline::scenes
