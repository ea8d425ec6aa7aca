// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include <orispline/math/eigen.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// The square of the chord between two orientations in R⁴, of the signs that are nearer to each other: 4 sin²(θ/4)
/// where their distance is θ, with which it grows, but without an arc tangent.
[[nodiscard]] inline double chord_square(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) noexcept {
  return std::min((a.coeffs() - b.coeffs()).squaredNorm(), (a.coeffs() + b.coeffs()).squaredNorm());
}

}}  // namespace orispline
