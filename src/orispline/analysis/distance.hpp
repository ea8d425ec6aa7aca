// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include <orispline/curve/curve.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Distances between two motions: of their orientations [rad] or of their angular velocities [rad/s].
struct DistanceStatistics {
  std::size_t count = 0;                        ///< compared pairs; the figures below are 0 when there are none
  double rms = 0.0, mean = 0.0, largest = 0.0;  ///< in the unit of the distances
  std::size_t largest_at = 0;                   ///< index into the reference
  /// Half, 95 % and 99 % of the distances are not greater: linear between neighbouring ones in rising order.
  double median = 0.0, percentile_95 = 0.0, percentile_99 = 0.0;

  /// Of the full rotation angle [rad²]; what the 6th degree's table 1 has may be that of half of it, which is a fourth.
  [[nodiscard]] double mean_square() const noexcept { return rms * rms; }
};

/// On the sphere of unit quaternions: arccos |p·q|, half the angle of the rotation from one to the other [rad]. The 6th
/// degree's figure 3 has this or the angle itself; it does not say which.
[[nodiscard]] inline double spherical_distance(const Eigen::Quaterniond& p, const Eigen::Quaterniond& q) noexcept {
  return 0.5 * angular_distance(p, q);
}

/// Of distances, the first of them at index `first` of the reference. Those that are NaN, such as in gaps, do not
/// count.
[[nodiscard]] ORISPLINE_EXPORT DistanceStatistics distance_statistics(std::vector<double> distances,
                                                                      std::size_t first = 0);

/// Orientations that were measured or simulated at times [s] of the curve.
struct OrientationSeries {
  std::span<const double> times;                     ///< they do not decrease
  std::span<const Eigen::Quaterniond> orientations;  ///< unit quaternions, one per time, of any sign
};

/// How far the curve is from the reference, at those of the reference's times that lie in the curve's domain: the full
/// angle of the rotation from one to the other [rad].
[[nodiscard]] ORISPLINE_EXPORT DistanceStatistics distance_to_reference(const AnyCurve& curve,
                                                                        OrientationSeries reference);
/// How far the curve is from the reference on another stretch, such as from the first key to the last: methods that
/// begin later or end earlier hold their end orientation there, as their samples do. That is what compare() measures.
[[nodiscard]] ORISPLINE_EXPORT DistanceStatistics distance_to_reference(const AnyCurve& curve,
                                                                        OrientationSeries reference, Domain stretch);

/// How far angular velocities are from the logged ones [rad/s], one each, where those are not free; the first of them
/// at index `first` of the reference.
[[nodiscard]] ORISPLINE_EXPORT DistanceStatistics rate_statistics(std::span<const Eigen::Vector3d> found,
                                                                  std::span<const Eigen::Vector3d> logged,
                                                                  std::size_t first);

/// Angular velocities that were logged at times [s] of the curve. Free ones are not compared.
struct RateSeries {
  std::span<const double> times;                        ///< they do not decrease
  std::span<const Eigen::Vector3d> angular_velocities;  ///< [rad/s], body frame, one per time
};

/// How far ω of the curve is from the logged one, at those of its times that lie in the curve's domain [rad/s]. Where ω
/// jumps at a key, the mean of both sides counts.
[[nodiscard]] ORISPLINE_EXPORT DistanceStatistics rate_error(const AnyCurve& curve, RateSeries logged);

}}  // namespace orispline
