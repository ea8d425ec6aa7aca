// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include <orispline/clip/clip.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

[[nodiscard]] inline bool is_finite(const Eigen::Quaterniond& value) noexcept { return value.coeffs().allFinite(); }
[[nodiscard]] inline bool is_finite(const Eigen::Vector3d& value) noexcept { return value.allFinite(); }

/// Whether the times, values and tangents of a channel are finite numbers.
template <CurvePoint P>
[[nodiscard]] bool is_finite(const Channel<P>& channel) {
  const auto are_finite = [](const SharedList<P>& points) {
    return std::ranges::all_of(points, [](const P& point) { return is_finite(point); });
  };
  return std::ranges::all_of(channel.times, [](double time) { return std::isfinite(time); }) &&
         are_finite(channel.values) && are_finite(channel.in_tangents) && are_finite(channel.out_tangents);
}

}}  // namespace orispline
