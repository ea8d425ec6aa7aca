// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include <orispline/curve/method.hpp>
#include <orispline/reduce/cubic_keys.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Samples that are keys of `hermite-c1`, each with its body rate [rad/s], or of positions with its velocity.
struct HermiteKeys {
  std::vector<std::size_t> samples;
  std::vector<Eigen::Vector3d> rates;
};

/// Rates that the first key and the last one have in any case, if any [rad/s, or lengths per second].
struct RatesAtEnds {
  std::optional<Eigen::Vector3d> first{}, last{};
};

/// Few samples, the first and the last one among them, and rates with which `hermite-c1` is within the tolerance of all
/// targets: an angle [rad] or a length. Between two neighbouring samples that both are keys the targets are not bound.
///
/// `stopped` is asked now and then; the search ends early with keys that hold. Precondition: two samples at least.
/// Source: docs/skeletons.md.
template <CurvePoint P>
[[nodiscard]] HermiteKeys fewest_hermite_keys(const CubicSamples<P>& samples, double tolerance,
                                              const RatesAtEnds& given = {}, const std::function<bool()>& stopped = {});

extern template HermiteKeys fewest_hermite_keys(const CubicSamples<Eigen::Quaterniond>&, double, const RatesAtEnds&,
                                                const std::function<bool()>&);
extern template HermiteKeys fewest_hermite_keys(const CubicSamples<Eigen::Vector3d>&, double, const RatesAtEnds&,
                                                const std::function<bool()>&);

/// Whether the rates of the keys of that method are sought with the keys: those of `hermite-c1` in the chart.
[[nodiscard]] bool seeks_rates(const Method& method);

/// The rate at both ends of a motion that begins again where it ends, of its targets nearest to the seam: the body rate
/// [rad/s], or the velocity.
template <CurvePoint P>
[[nodiscard]] Eigen::Vector3d rate_at_seam(const CubicTargets<P>& targets);

/// Few keys of `hermite-c1` within the tolerance of all targets, as `cubicspline`: of rotations cubics that follow the
/// curve within a small part of the tolerance.
template <CurvePoint P>
[[nodiscard]] Expected<Channel<P>> hermite_channel(const CubicSamples<P>& samples, double tolerance,
                                                   const Method& method, const RatesAtEnds& given = {});

extern template Eigen::Vector3d rate_at_seam(const CubicTargets<Eigen::Quaterniond>&);
extern template Eigen::Vector3d rate_at_seam(const CubicTargets<Eigen::Vector3d>&);
extern template Expected<Channel<Eigen::Quaterniond>> hermite_channel(const CubicSamples<Eigen::Quaterniond>&, double,
                                                                      const Method&, const RatesAtEnds&);
extern template Expected<Channel<Eigen::Vector3d>> hermite_channel(const CubicSamples<Eigen::Vector3d>&, double,
                                                                   const Method&, const RatesAtEnds&);

}}  // namespace orispline
