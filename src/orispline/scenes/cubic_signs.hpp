// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/scenes/scene_file.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes {

/// The scene with its `cubicspline` rotations as the signs say: a spline of components goes through quaternions with
/// the signs of the file, and so the long way round where a key is more than 90° in R⁴ from the one before. `shortest`
/// gives such keys, with their tangents, the other sign. Absent, one warning names the first that hardly can be meant:
/// by more than 270°, where the other sign turns by less than 90°, with tangents that lead the other way.
[[nodiscard]] Scene with_cubic_signs(Scene scene, std::optional<Signs> signs);

}}}  // namespace orispline::scenes
