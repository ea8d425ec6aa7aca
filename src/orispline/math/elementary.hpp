// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include <orispline/base/abi.hpp>

/// Elementary functions with the same bits on every processor and from every compiler: IEEE operations alone, where the
/// system's library takes other paths on processors with fused multiply-add.
///
/// Each result is within 1 ulp of the true value, for every argument; zeros, infinities and NaN are answered as by
/// `<cmath>`. The formulas: docs/conventions.md, "The same bits everywhere".
namespace orispline { inline namespace ORISPLINE_ABI { namespace elementary {

struct SineCosine {
  double sine, cosine;
};

/// Sine and cosine of an angle [rad] of any size.
[[nodiscard]] ORISPLINE_EXPORT SineCosine sine_cosine(double angle) noexcept;

/// Of three angles at once: none waits for another.
[[nodiscard]] ORISPLINE_EXPORT std::array<SineCosine, 3> sines_cosines(const std::array<double, 3>& angles) noexcept;

/// Angle of the vector (x, y) from the x axis [rad], in [-π, π], with the sign of y.
[[nodiscard]] ORISPLINE_EXPORT double arctangent(double y, double x) noexcept;

/// Logarithm to the base e.
[[nodiscard]] ORISPLINE_EXPORT double natural_logarithm(double x) noexcept;

}}}  // namespace orispline::elementary
