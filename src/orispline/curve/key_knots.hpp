// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/curve/keyframe.hpp>
#include <orispline/curve/knots.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// The knots of an open curve whose segments run from key to key.
[[nodiscard]] inline Knots key_knots(const Keyframes& keys) {
  return Knots({keys.times().begin(), keys.times().end()});
}

}}  // namespace orispline
