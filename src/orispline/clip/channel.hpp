// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <vector>

#include <orispline/math/geodesic.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// How a channel goes from one key to the next. The words are glTF's.
enum class ChannelInterpolation {
  step,         ///< it keeps the value of the key before
  linear,       ///< slerp the shorter way, or a straight line
  cubicspline,  ///< a cubic Hermite polynomial of the components; of rotations normalised
};

/// One property of a joint over time: its rotation, translation or scale. Vectors have one entry per key.
template <CurvePoint P>
struct Channel {
  std::size_t joint = 0;  ///< index in the skeleton
  ChannelInterpolation interpolation = ChannelInterpolation::linear;
  std::vector<double> times{};  ///< [s], finite, strictly increasing; one at least
  std::vector<P> values{};      ///< unit quaternions from joint to parent, or vectors in the frame of the parent
  /// Time derivatives of the values before and after each key, component by component [1/s]; empty unless the
  /// interpolation is `cubicspline`.
  std::vector<P> in_tangents{}, out_tangents{};

  [[nodiscard]] std::size_t size() const noexcept { return times.size(); }
};
using RotationChannel = Channel<Eigen::Quaterniond>;
using VectorChannel = Channel<Eigen::Vector3d>;

/// The channel of that joint; null where there is none.
template <CurvePoint P>
[[nodiscard]] const Channel<P>* channel_of(const std::vector<Channel<P>>& channels, std::size_t joint) noexcept {
  const auto found = std::ranges::find(channels, joint, &Channel<P>::joint);
  return found == channels.end() ? nullptr : &*found;
}

// GCC 12 fails where it meets a list of members by their names before any other use of their defaults.
static_assert(std::is_default_constructible_v<RotationChannel> && std::is_default_constructible_v<VectorChannel>);

}}  // namespace orispline
