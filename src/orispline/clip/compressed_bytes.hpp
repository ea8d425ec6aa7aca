// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include <orispline/clip/clip.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// How many bytes the codec of EXT_meshopt_compression makes of elements of `stride` bytes that follow each other in a
/// longer stream, in its mode ATTRIBUTES: it packs the differences of each byte from that before, sixteen at a time.
/// Source: the specification of the extension.
[[nodiscard]] std::size_t compressed_size(std::span<const unsigned char> bytes, std::size_t stride);

/// Of the values of a channel in such a file, with the tangents of a spline, and of times [bytes], as the filters hold
/// them.
template <CurvePoint P>
[[nodiscard]] std::size_t compressed_bytes(const Channel<P>& channel);
[[nodiscard]] std::size_t compressed_bytes(std::span<const double> times);

extern template std::size_t compressed_bytes(const RotationChannel&);
extern template std::size_t compressed_bytes(const VectorChannel&);

}}  // namespace orispline
