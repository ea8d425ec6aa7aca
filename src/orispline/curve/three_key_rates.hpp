// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include <orispline/math/eigen.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Rates at the keys from the increments between them: that of the parabola through a key and its two neighbours, at
/// the ends that of the first and the last increment. The same for rotation vectors and for displacements.
///
/// n times and n-1 increments give n rates [increment/s]; exact for a constant rate on any key times.
[[nodiscard]] std::vector<Eigen::Vector3d> three_key_rates(std::span<const double> times,
                                                           std::span<const Eigen::Vector3d> increments);

}}  // namespace orispline
