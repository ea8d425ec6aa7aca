// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <orispline/clip/clip.hpp>
#include <orispline/reduce/channel_motion.hpp>
#include <orispline/reduce/cubic_span.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Targets of which every `stride`-th, from the first to the last, is a sample that may become a key.
template <CurvePoint P>
struct CubicSamples {
  CubicTargets<P> targets{};
  std::size_t stride = 1;
  std::vector<std::size_t> parted_at{};  ///< samples that no span goes over, rising: the ends of cuts

  [[nodiscard]] std::size_t size() const noexcept { return (targets.times.size() - 1) / stride + 1; }
};

/// Few samples that are keys of cubics with free tangents, within the tolerance of all targets, as `cubicspline`: an
/// angle [rad] or a length. Two neighbouring samples are joined in any case, by the nearest cubic.
///
/// Since the spans do not depend on each other, spans are made as long as they go, from the first sample on; and where
/// an earlier end of the span before lets the next one go farther, it is taken. Precondition: two samples at least.
///
/// `closed`: the last sample is the first one again, and the tangents at the first key are those at the last one, for
/// which a key more may be needed. Precondition: no cut begins at the first sample or ends at the last.
template <CurvePoint P>
[[nodiscard]] Channel<P> fewest_cubics(const CubicSamples<P>& samples, double tolerance, bool closed = false);

extern template Channel<Eigen::Quaterniond> fewest_cubics(const CubicSamples<Eigen::Quaterniond>&, double, bool);
extern template Channel<Eigen::Vector3d> fewest_cubics(const CubicSamples<Eigen::Vector3d>&, double, bool);

/// Keys of a motion as samples, and three points of it between two of them: a fit of as many unknowns as samples would
/// swing between them; the points hold it. Cuts, whose ends are keys if they are within them, part the samples.
/// Precondition: two keys at least.
template <CurvePoint P>
[[nodiscard]] CubicSamples<P> cubic_samples(const Channel<P>& keys, const ChannelCurve<P>& motion,
                                            std::span<const Cut> cuts = {});
/// Those of a channel, of the motion that it is taken to be.
template <CurvePoint P>
[[nodiscard]] CubicSamples<P> cubic_samples(const Channel<P>& channel, BetweenSamples between);

extern template CubicSamples<Eigen::Quaterniond> cubic_samples(const RotationChannel&,
                                                               const ChannelCurve<Eigen::Quaterniond>&,
                                                               std::span<const Cut>);
extern template CubicSamples<Eigen::Vector3d> cubic_samples(const VectorChannel&, const ChannelCurve<Eigen::Vector3d>&,
                                                            std::span<const Cut>);
extern template CubicSamples<Eigen::Quaterniond> cubic_samples(const RotationChannel&, BetweenSamples);
extern template CubicSamples<Eigen::Vector3d> cubic_samples(const VectorChannel&, BetweenSamples);

}}  // namespace orispline
