// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include <orispline/math/eigen.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Median of the length of a vector of three normal variables of variance 1: of a chi variable with 3 degrees of
/// freedom.
inline constexpr double median_length = 1.5381722544550522;

/// The standard deviation of vectors about 0, of which outliers are few, in the direction where it is largest, if that
/// is more than twice the one where it is least; else 0. Of the vectors within three medians of the length: noise in
/// one direction alone is taken for 0.88 of itself.
[[nodiscard]] double lopsided_deviation(std::span<const Eigen::Vector3d> vectors);

/// Rounding of orientations in single precision [rad]: noise below it is not told apart.
inline constexpr double least_noise = 1e-7;
/// Residuals of this size per axis [rad] are those of no motion at all.
inline constexpr double largest_noise = 0.5;

/// The noise of a recording per axis [rad], from the difference of the steps to its two neighbours that every
/// orientation has: the median, so that outliers and quick turns do not count. It holds the bends of the motion too,
/// but not orientations that differ from their neighbours' mean by less than `least_noise`.
///
/// Times [s] increase; 0 for fewer than three.
[[nodiscard]] double local_noise(std::span<const double> times, std::span<const Eigen::Quaterniond> orientations);

/// The lengths of these differences, each as that of one sample [rad], of every orientation but the first and the last;
/// 0 where they tell nothing.
[[nodiscard]] std::vector<double> local_noises(std::span<const double> times,
                                               std::span<const Eigen::Quaterniond> orientations);

/// The noise per axis of vectors, such as rates, in their unit: from the straight line between the neighbours. Those
/// nearer to it than `least` tell nothing.
[[nodiscard]] double local_noise(std::span<const double> times, std::span<const Eigen::Vector3d> vectors,
                                 double least = least_noise);

}}  // namespace orispline
