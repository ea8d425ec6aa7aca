// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include <orispline/clip/clip.hpp>
#include <orispline/reduce/clip_reduction.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Of the keys of a channel in a glTF file, whose numbers are in single precision [bytes]: of their values, with the
/// tangents of a spline, and of their times.
template <CurvePoint P>
[[nodiscard]] std::size_t bytes_of_values(const Channel<P>& channel) {
  constexpr std::size_t components = std::same_as<P, Eigen::Quaterniond> ? 4 : 3;
  const bool is_spline = channel.interpolation == ChannelInterpolation::cubicspline;
  return channel.size() * components * sizeof(float) * (is_spline ? 3 : 1);
}
template <CurvePoint P>
[[nodiscard]] std::size_t bytes_of_keys(const Channel<P>& channel) {
  return bytes_of_values(channel) + channel.size() * sizeof(float);
}

/// The clip after with those channels as they were before that then take fewer bytes: channels with the same times
/// hold these once, which may outweigh fewer keys with times of their own. Precondition: the channels are those of the
/// clip before, in their order.
[[nodiscard]] Clip with_shared_times(const Clip& before, Clip after);

}}  // namespace orispline
