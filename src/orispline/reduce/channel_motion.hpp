// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include <orispline/clip/clip_motion.hpp>
#include <orispline/reduce/clip_reduction.hpp>
#include <orispline/reduce/cuts.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// The motion that a channel is taken to be: what it says, or the curve `auto` through its keys, which stands still
/// between keys that are the same, as joints do that rest. `auto` predicts left-out frames of recorded animation better
/// than their chords do (docs/skeletons.md). A `cubicspline` and steps are their own motion in any case, and so are
/// keys that `auto` refuses, such as two nearly at one time.
///
/// Cuts, whose ends are keys of the channel, part the curve; what the channel says is the motion within them.
template <CurvePoint P>
[[nodiscard]] ChannelCurve<P> motion_between(const Channel<P>& channel, BetweenSamples between,
                                             std::span<const Cut> cuts = {});

extern template ChannelCurve<Eigen::Quaterniond> motion_between(const RotationChannel&, BetweenSamples,
                                                                std::span<const Cut>);
extern template ChannelCurve<Eigen::Vector3d> motion_between(const VectorChannel&, BetweenSamples,
                                                             std::span<const Cut>);

/// From the first to the last of the channel's keys, both included, the stretches that cuts part, and the cuts between
/// them: `take(first, last)`, in their order. Stretches of one key are left out.
template <CurvePoint P, class Take>
void pass_stretches(const Channel<P>& channel, std::span<const Cut> cuts, const Take& take) {
  const auto key_at = [&](double t) {
    const auto found = std::ranges::lower_bound(channel.times, t);
    return std::min(static_cast<std::size_t>(found - channel.times.begin()), channel.size() - 1);
  };
  std::size_t first = 0;
  const auto pass = [&](std::size_t last) {
    if (last > first) take(first, last);
    first = last;
  };
  for (const Cut& cut : cuts) pass(key_at(cut.before)), pass(key_at(cut.after));
  pass(channel.size() - 1);
}

/// The channel's keys from the first to the last, both included.
template <CurvePoint P>
[[nodiscard]] Channel<P> stretch_of(const Channel<P>& channel, std::size_t first, std::size_t last) {
  const auto part = [&](const auto& all) {
    return all.empty() ? std::decay_t<decltype(all)>()
                       : std::decay_t<decltype(all)>(all.begin() + static_cast<std::ptrdiff_t>(first),
                                                     all.begin() + static_cast<std::ptrdiff_t>(last) + 1);
  };
  return {channel.joint,        channel.interpolation,     part(channel.times),
          part(channel.values), part(channel.in_tangents), part(channel.out_tangents)};
}

}}  // namespace orispline
