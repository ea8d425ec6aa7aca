// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <orispline/curve/curve.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// The angle ∫|ω| dt that a curve has travelled [rad]: the arc length of orientations, and its inverse.
///
/// Made once per curve by adaptive Gauss quadrature, to 1e-10 relative in each segment (less where |ω| touches zero and
/// has a kink).
class ORISPLINE_EXPORT AngleTravelled {
 public:
  explicit AngleTravelled(AnyCurve curve);

  /// Of the whole curve [rad].
  [[nodiscard]] double total() const noexcept { return at_knots_.back(); }
  /// From the start to the time t [s], which is held to the domain [rad].
  [[nodiscard]] double at(double t) const;
  /// The first time [s] at which the curve has travelled that angle [rad], which is held to 0 … total().
  [[nodiscard]] double time_at(double angle) const;

 private:
  [[nodiscard]] double within(std::size_t segment, double start, double end) const;

  AnyCurve curve_;
  std::vector<double> at_knots_;  // [rad]
};

}}  // namespace orispline
