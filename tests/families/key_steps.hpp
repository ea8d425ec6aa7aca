// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/curve/keyframe.hpp>
#include <orispline/math/so3.hpp>

namespace orispline::testing_support {

[[nodiscard]] inline Eigen::Vector3d step(const Keyframes& keys, std::size_t from, std::size_t to) {
  return increment<double>(keys.orientations()[from], keys.orientations()[to]);
}

/// To the next key.
[[nodiscard]] inline Eigen::Vector3d step(const Keyframes& keys, std::size_t from) {
  return step(keys, from, from + 1);
}

}  // namespace orispline::testing_support
