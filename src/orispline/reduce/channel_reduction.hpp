// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/reduce/clip_reduction.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// A channel with fewer keys, within the tolerance [rad, or a length] at every key that it had; itself where that
/// cannot be had with fewer, or only with numbers that are too large for the file.
///
/// Errors: those of reduce().
template <CurvePoint P>
[[nodiscard]] Expected<Channel<P>> reduced_channel(const Channel<P>& channel, double tolerance,
                                                   const ClipReduceOptions& options);

/// One key in the place of those of a channel that moves no farther than that [rad, or a length]: the joint's rest pose
/// where all keys are as near to it, else the first of them. The channel itself where it moves farther, or would with
/// the key in that precision.
template <CurvePoint P>
[[nodiscard]] Channel<P> resting_channel(const Channel<P>& channel, const P& rest, double farthest,
                                         KeyPrecision precision);

/// The farthest that a channel with fewer keys is from the keys before [rad, or a length].
template <CurvePoint P>
[[nodiscard]] LargestInTime farthest_at_keys(const Channel<P>& before, const Channel<P>& after);

/// The farthest that a channel with fewer keys is from what the motion before is taken to be: at the keys that it had
/// and between them, beside the farthest of three points there until nothing rises [rad, or a length].
template <CurvePoint P>
[[nodiscard]] LargestInTime farthest_between(const Channel<P>& before, const Channel<P>& after, BetweenSamples between);

/// Whether a channel ends as it begins, but for rounding.
template <CurvePoint P>
[[nodiscard]] bool ends_as_it_begins(const Channel<P>& channel);

extern template RotationChannel resting_channel(const RotationChannel&, const Eigen::Quaterniond&, double,
                                                KeyPrecision);
extern template VectorChannel resting_channel(const VectorChannel&, const Eigen::Vector3d&, double, KeyPrecision);
extern template LargestInTime farthest_at_keys(const RotationChannel&, const RotationChannel&);
extern template LargestInTime farthest_at_keys(const VectorChannel&, const VectorChannel&);
extern template LargestInTime farthest_between(const RotationChannel&, const RotationChannel&, BetweenSamples);
extern template LargestInTime farthest_between(const VectorChannel&, const VectorChannel&, BetweenSamples);
extern template bool ends_as_it_begins(const RotationChannel&);
extern template bool ends_as_it_begins(const VectorChannel&);
extern template Expected<RotationChannel> reduced_channel(const RotationChannel&, double, const ClipReduceOptions&);
extern template Expected<VectorChannel> reduced_channel(const VectorChannel&, double, const ClipReduceOptions&);

}}  // namespace orispline
