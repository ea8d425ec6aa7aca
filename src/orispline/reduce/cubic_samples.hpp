// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/clip/channel.hpp>
#include <orispline/reduce/between_samples.hpp>
#include <orispline/reduce/cubic_keys.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// The keys of a channel as samples, and three points between two of them. A `cubicspline` is its own motion in any
/// case.
///
/// A fit of as many unknowns as samples would swing between them; the points hold it. `auto` predicts left-out frames
/// of recorded animation better than their chords do (docs/skeletons.md). Precondition: two keys at least.
template <CurvePoint P>
[[nodiscard]] CubicSamples<P> cubic_samples(const Channel<P>& channel, BetweenSamples between);

extern template CubicSamples<Eigen::Quaterniond> cubic_samples(const Channel<Eigen::Quaterniond>&, BetweenSamples);
extern template CubicSamples<Eigen::Vector3d> cubic_samples(const Channel<Eigen::Vector3d>&, BetweenSamples);

}}  // namespace orispline
