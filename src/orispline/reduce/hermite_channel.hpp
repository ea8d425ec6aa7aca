// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/curve/method.hpp>
#include <orispline/reduce/hermite_keys.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Whether the rates of the keys of that method are sought with the keys: those of `hermite-c1` in the chart.
[[nodiscard]] bool seeks_rates(const Method& method);

/// The rate at both ends of a motion that begins again where it ends, of its targets nearest to the seam: the body rate
/// [rad/s], or the velocity.
template <CurvePoint P>
[[nodiscard]] Eigen::Vector3d rate_at_seam(const CubicTargets<P>& targets);

/// Few keys of `hermite-c1` within the tolerance of all targets, as `cubicspline`: of rotations cubics that follow the
/// curve within a small part of the tolerance. `closed`: the tangents at both ends are the same.
template <CurvePoint P>
[[nodiscard]] Expected<Channel<P>> hermite_channel(const CubicSamples<P>& samples, double tolerance,
                                                   const Method& method, bool closed);

extern template Eigen::Vector3d rate_at_seam(const CubicTargets<Eigen::Quaterniond>&);
extern template Eigen::Vector3d rate_at_seam(const CubicTargets<Eigen::Vector3d>&);
extern template Expected<Channel<Eigen::Quaterniond>> hermite_channel(const CubicSamples<Eigen::Quaterniond>&, double,
                                                                      const Method&, bool);
extern template Expected<Channel<Eigen::Vector3d>> hermite_channel(const CubicSamples<Eigen::Vector3d>&, double,
                                                                   const Method&, bool);

}}  // namespace orispline
