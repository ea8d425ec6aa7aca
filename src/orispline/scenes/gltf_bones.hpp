// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/clip/skeleton.hpp>
#include <orispline/scenes/gltf_document.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::gltf {

/// A document of one node per joint and of nothing else, with a few triangles at each joint, so that a viewer shows it:
/// a bone to the farthest child, and a small craft where there is but one joint.
[[nodiscard]] Document with_bones(Document document, const Skeleton& skeleton);

}}}  // namespace orispline::scenes::gltf
