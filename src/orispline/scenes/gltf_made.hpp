// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/scenes/gltf_source.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::gltf {

/// A document without animations for a skeleton that no glTF file had, one node per joint.
[[nodiscard]] Source made_source(const Skeleton& skeleton, const SceneWriting& writing);

}}}  // namespace orispline::scenes::gltf
