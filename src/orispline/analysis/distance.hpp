// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include <orispline/curve/curve.hpp>

namespace orispline {

/// Geodesic distances between two motions.
struct DistanceStatistics {
  std::size_t count = 0;                        ///< compared orientations; the figures below are 0 when there are none
  double rms = 0.0, mean = 0.0, largest = 0.0;  ///< [rad]
  std::size_t largest_at = 0;                   ///< index into the reference
};

/// Orientations that were measured or simulated at times [s] of the curve.
struct OrientationSeries {
  std::span<const double> times;
  std::span<const Eigen::Quaterniond> orientations;  ///< unit quaternions, one per time, of any sign
};

/// How far the curve is from the reference, at those of the reference's times that lie in the curve's domain.
[[nodiscard]] DistanceStatistics distance_to_reference(const AnyCurve& curve, OrientationSeries reference);

}  // namespace orispline
