// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include <orispline/reduce/cubic_keys.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Samples that are keys of `hermite-c1`, each with its body rate [rad/s], or of positions with its velocity.
struct HermiteKeys {
  std::vector<std::size_t> samples;
  std::vector<Eigen::Vector3d> rates;
};

/// Few samples, the first and the last one among them, and rates with which `hermite-c1` is within the tolerance of all
/// targets: an angle [rad] or a length. Between two neighbouring samples that both are keys the targets are not bound.
///
/// `seam`: the rate that both ends have, of a motion that begins again where it ends. `stopped` is asked now and then;
/// the search ends early with keys that hold. Precondition: two samples at least. Source: docs/skeletons.md.
template <CurvePoint P>
[[nodiscard]] HermiteKeys fewest_hermite_keys(const CubicSamples<P>& samples, double tolerance,
                                              const std::optional<Eigen::Vector3d>& seam = {},
                                              const std::function<bool()>& stopped = {});

extern template HermiteKeys fewest_hermite_keys(const CubicSamples<Eigen::Quaterniond>&, double,
                                                const std::optional<Eigen::Vector3d>&, const std::function<bool()>&);
extern template HermiteKeys fewest_hermite_keys(const CubicSamples<Eigen::Vector3d>&, double,
                                                const std::optional<Eigen::Vector3d>&, const std::function<bool()>&);

}}  // namespace orispline
