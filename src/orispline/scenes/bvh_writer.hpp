// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/scenes/scene_format.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::bvh {

/// A file with the one clip of the scene. Errors: bad_data for a scene without a joint, with another number of clips or
/// with keys at uneven times; bad_argument for the options.
[[nodiscard]] Expected<SceneWritten> write(const Scene& scene, const std::string& path, const SceneWriting& writing);

}}}  // namespace orispline::scenes::bvh
