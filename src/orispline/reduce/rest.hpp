// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/reduce/clip_reduction.hpp>

// Channels that stand still.

namespace orispline { inline namespace ORISPLINE_ABI {

/// One key in the place of those of a channel that moves no farther than that [rad, or a length]: the joint's rest pose
/// where all keys are as near to it, else the first of them. The channel itself where it moves farther, or would with
/// the key in that precision.
template <CurvePoint P>
[[nodiscard]] Channel<P> resting_channel(const Channel<P>& channel, const P& rest, double farthest,
                                         KeyPrecision precision);

/// Whether all of a channel is one key that is the rest pose of its joint, which is there without it.
template <CurvePoint P>
[[nodiscard]] bool is_rest(const Channel<P>& channel, const P& rest);

/// How many channels a clip was rid of.
struct RidOfRest {
  std::size_t rotations = 0, translations = 0, scales = 0;

  [[nodiscard]] std::size_t all() const noexcept { return rotations + translations + scales; }
};

/// Takes out the channels of one key that is the rest pose of their joint. The clip begins
/// and ends when it did, for which one of them may stay, and has a channel where it had one.
RidOfRest take_out_resting(const Skeleton& skeleton, Clip& clip);

extern template RotationChannel resting_channel(const RotationChannel&, const Eigen::Quaterniond&, double,
                                                KeyPrecision);
extern template bool is_rest(const RotationChannel&, const Eigen::Quaterniond&);
extern template bool is_rest(const VectorChannel&, const Eigen::Vector3d&);
extern template VectorChannel resting_channel(const VectorChannel&, const Eigen::Vector3d&, double, KeyPrecision);

}}  // namespace orispline
