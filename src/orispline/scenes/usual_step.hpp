// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/clip/clip.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes {

/// From key to key [s], of most keys of the channel of rotations or translations where these are farthest apart; 0
/// where none has three.
[[nodiscard]] ORISPLINE_EXPORT double usual_step_of(const Clip& clip);

}}}  // namespace orispline::scenes
