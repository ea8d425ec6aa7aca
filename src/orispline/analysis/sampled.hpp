// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include <orispline/curve/curve.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// A curve at the times of something else.
struct SampledCurve {
  std::vector<Eigen::Quaterniond> orientations;
  std::vector<Eigen::Vector3d>
      angular_velocities;  ///< [rad/s], body frame; where ω jumps at a key, the mean of both sides
};

enum class Sampled { orientations, orientations_and_rates };

/// Samples in bulk at times that increase; the end orientation, at rest, outside the domain. Two times may be equal
/// where the motion jumps: the first one is before the jump.
[[nodiscard]] SampledCurve sampled(const AnyCurve& curve, std::span<const double> times, Sampled what);

/// Those of rising times that lie in the domain: `count` of them from `first` on.
struct TimesWithin {
  std::size_t first = 0, count = 0;
};
[[nodiscard]] TimesWithin times_within(std::span<const double> times, Domain domain);

}}  // namespace orispline
