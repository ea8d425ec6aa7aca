// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/reduce/channel_motion.hpp>
#include <orispline/reduce/clip_reduction.hpp>
#include <orispline/reduce/cuts.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// A channel, and the motion that it is taken to be.
template <CurvePoint P>
struct TakenChannel {
  const Channel<P>& channel;
  const ChannelCurve<P>& motion;
  const std::vector<Cut>& cuts;  ///< of the channel: stretches between them are reduced by themselves
  std::span<const P> looks{};    ///< the motion at with_looks_between() of the channel's times, if it is known there
};

/// A channel with fewer keys, within the tolerance [rad, or a length] of the motion at and between the keys that it
/// had; itself where that cannot be had with fewer, or only with numbers that are too large for the file.
///
/// Where a curve within the tolerance at its samples is not between two of them, the middle between these becomes a
/// sample too, and the search begins again.
///
/// Errors: those of reduce().
template <CurvePoint P>
[[nodiscard]] Expected<Channel<P>> reduced_channel(const TakenChannel<P>& before, double tolerance,
                                                   const ClipReduceOptions& options);

/// The channel with its values rounded by a part of the tolerance, as compression asks for; else as it is.
template <CurvePoint P>
[[nodiscard]] Channel<P> rounded_channel(const Channel<P>& channel, double tolerance, const ClipReduceOptions& options);

/// The farthest that a channel with fewer keys is from a motion [rad, or a length]: at those times and between them,
/// where it is looked at in `looks_between` places, and beside the farthest of these until nothing rises. `looks` as in
/// TakenChannel; what is not above `known` need not be found.
template <CurvePoint P>
[[nodiscard]] LargestInTime farthest_from(const ChannelCurve<P>& motion, const Channel<P>& after,
                                          std::span<const double> times, std::span<const P> looks = {},
                                          double known = 0.0);
inline constexpr std::size_t looks_between = 8;

/// The times with so many between two of them.
[[nodiscard]] std::vector<double> with_looks_between(std::span<const double> times);

/// Whether one of the cuts begins at the first key or ends at the last: such a channel cannot be closed.
template <CurvePoint P>
[[nodiscard]] bool is_cut_at_ends(const Channel<P>& channel, const std::vector<Cut>& cuts) {
  return !cuts.empty() && (cuts.front().before <= channel.times.front() || cuts.back().after >= channel.times.back());
}

/// How far its last key is from its first one [rad, or a length].
template <CurvePoint P>
[[nodiscard]] double apart_at_ends(const Channel<P>& channel);
/// Whether a channel ends as it begins, but for rounding.
template <CurvePoint P>
[[nodiscard]] bool ends_as_it_begins(const Channel<P>& channel);

extern template RotationChannel rounded_channel(const RotationChannel&, double, const ClipReduceOptions&);
extern template VectorChannel rounded_channel(const VectorChannel&, double, const ClipReduceOptions&);
extern template LargestInTime farthest_from(const ChannelCurve<Eigen::Quaterniond>&, const RotationChannel&,
                                            std::span<const double>, std::span<const Eigen::Quaterniond>, double);
extern template LargestInTime farthest_from(const ChannelCurve<Eigen::Vector3d>&, const VectorChannel&,
                                            std::span<const double>, std::span<const Eigen::Vector3d>, double);
extern template double apart_at_ends(const RotationChannel&);
extern template double apart_at_ends(const VectorChannel&);
extern template bool ends_as_it_begins(const RotationChannel&);
extern template bool ends_as_it_begins(const VectorChannel&);
extern template Expected<RotationChannel> reduced_channel(const TakenChannel<Eigen::Quaterniond>&, double,
                                                          const ClipReduceOptions&);
extern template Expected<VectorChannel> reduced_channel(const TakenChannel<Eigen::Vector3d>&, double,
                                                        const ClipReduceOptions&);

}}  // namespace orispline
