// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/online/online_curve.hpp>
#include <support/tracks.hpp>

namespace orispline::testing_support {

/// A posed walk as sensors send it: norms that are not quite 1, signs at random.
[[nodiscard]] inline KeyframeData raw_walk(std::uint64_t seed, std::size_t count, Spacing spacing = Spacing::uneven) {
  KeyframeData data = posed_walk(seed, count, spacing, 1.5);
  Dice dice(seed + 2);
  for (Eigen::Quaterniond& q : data.orientations)
    q.coeffs() *= (dice() < 0.5 ? -1.0 : 1.0) * dice.between(0.9995, 1.0005);
  return data;
}

/// Appends keys first … last - 1 of the data.
[[nodiscard]] inline Expected<void> append(OnlineCurve& curve, const KeyframeData& data, std::size_t first,
                                           std::size_t last) {
  for (std::size_t i = first; i < last; ++i) {
    auto taken = data.positions.empty() ? curve.append(data.times[i], data.orientations[i])
                                        : curve.append(data.times[i], data.orientations[i], data.positions[i]);
    if (!taken) return taken;
  }
  return {};
}

}  // namespace orispline::testing_support
