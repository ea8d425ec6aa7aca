// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <support/specimens.hpp>

namespace orispline::testing_support {

/// The keys with inner quaternions on both sides, each turned by less than 1 rad from its key.
[[nodiscard]] inline KeyframeData with_inner_quaternions(KeyframeData data, std::uint64_t seed) {
  Dice dice(seed);
  for (const Eigen::Quaterniond& q : data.orientations) {
    const Eigen::Vector3d leaving = 0.5 * dice.vector(), arriving = 0.5 * dice.vector();
    data.inner_leaving.push_back(q * exp<double>(leaving));
    data.inner_arriving.push_back(q * exp<double>(arriving));
  }
  return data;
}

}  // namespace orispline::testing_support
