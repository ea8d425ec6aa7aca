// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <orispline/base/abi.hpp>
#include <orispline/math/eigen.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// The speed at a key, by the mean speeds before and after it and how long they last: their weighted harmonic mean,
/// less than three times either; 0 where one is 0.
///
/// Source: Fritsch & Butland 1984, as in SciPy's PchipInterpolator.
[[nodiscard]] double harmonic_speed(double before, double time_before, double after, double time_after) noexcept;

/// Rates at the joints from the increments between them and how long these last, such that a cubic with these rates at
/// its ends goes on along its increment and never back. The same for rotation vectors and for displacements.
///
/// Between two increments the harmonic speed along the mean of their directions, which is a rest where one is zero or
/// the two are opposite. At an end the rate is along the increment there: by three points, between 0 and three times
/// the mean rate. n increments give n+1 rates [increment/s]; those of a loop have no ends, and its last one is its
/// first one.
[[nodiscard]] std::vector<Eigen::Vector3d> monotone_rates(std::span<const Eigen::Vector3d> increments,
                                                          std::span<const double> steps, bool is_loop);

}}  // namespace orispline
