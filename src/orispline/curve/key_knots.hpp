// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/curve/keyframe.hpp>
#include <orispline/curve/knots.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// The knots of an open curve whose segments run from key to key.
[[nodiscard]] inline Knots key_knots(const Keyframes& keys) {
  return Knots({keys.times().begin(), keys.times().end()});
}

/// Those of an open curve whose joints belong to all keys but the first and the last.
[[nodiscard]] inline Knots inner_key_knots(const Keyframes& keys) {
  return Knots({keys.times().begin() + 1, keys.times().end() - 1});
}

}}  // namespace orispline
