// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include <orispline/clip/clip.hpp>
#include <orispline/clip/compressed_bytes.hpp>
#include <orispline/clip/key_compression.hpp>
#include <orispline/reduce/clip_reduction.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Of an accessor of values, and of one of times, in a document that gzip packs [bytes].
inline constexpr std::size_t text_of_values = 14, text_of_times = 26;

/// Of the keys of a channel in a glTF file, whose numbers are in single precision [bytes]: of their values, with the
/// tangents of a spline, and of their times. Compressed, with the text of their accessors.
template <CurvePoint P>
[[nodiscard]] std::size_t bytes_of_values(const Channel<P>& channel,
                                          KeyCompression compression = KeyCompression::none) {
  if (compression != KeyCompression::none) return compressed_bytes(channel) + text_of_values;
  constexpr std::size_t components = std::same_as<P, Eigen::Quaterniond> ? 4 : 3;
  const bool is_spline = channel.interpolation == ChannelInterpolation::cubicspline;
  return channel.size() * components * sizeof(float) * (is_spline ? 3 : 1);
}
[[nodiscard]] inline std::size_t bytes_of_times(std::span<const double> times,
                                                KeyCompression compression = KeyCompression::none) {
  return compression == KeyCompression::none ? times.size() * sizeof(float) : compressed_bytes(times) + text_of_times;
}
template <CurvePoint P>
[[nodiscard]] std::size_t bytes_of_keys(const Channel<P>& channel, KeyCompression compression = KeyCompression::none) {
  return bytes_of_values(channel, compression) + bytes_of_times(channel.times, compression);
}

/// The clip after with those channels as they were before that then take fewer bytes: channels with the same times
/// hold these once, which may outweigh fewer keys with times of their own. Precondition: the channels are those of the
/// clip before, in their order.
[[nodiscard]] Clip with_shared_times(const Clip& before, Clip after);

}}  // namespace orispline
