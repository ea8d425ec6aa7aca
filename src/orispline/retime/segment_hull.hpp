// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include <orispline/retime/hull_polynomial.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// What the motion is nowhere above: |ω| [rad/s], |α| [rad/s²], the jerk [rad/s³] and the snap, its derivative
/// [rad/s⁴].
struct HullBounds {
  double rate, acceleration, jerk, snap, crackle;
};

/// The segment's polynomials, whose values lie in the hulls of their coefficients. Source: our own derivation,
/// docs/retime.md.
class SegmentHull {
 public:
  /// Nothing for a form that is not of polynomials. `duration` [s].
  [[nodiscard]] static std::optional<SegmentHull> of(const SegmentForm& form, double duration);

  /// Bounds for u from `start` to `end` in [0, 1].
  [[nodiscard]] HullBounds on(double start, double end) const;
  /// By so much evaluated ω, α and jerk may be off; none of the others.
  [[nodiscard]] HullBounds rounding() const;

 private:
  [[nodiscard]] HullBounds product_on(double start, double end) const;
  [[nodiscard]] HullBounds chart_on(double start, double end) const;
  [[nodiscard]] HullBounds rational_on(double start, double end) const;

  enum class Kind { product, chart, rational } kind_ = Kind::product;
  double duration_ = 0.0;
  /// The blending functions of a product, the components of a chart, those of a curve of R⁴.
  std::array<HullDerivatives, 4> parts_{};
  // Of a product: lengths of the increments, and of what they have along the second one and across it.
  std::array<double, 3> lengths_{}, along_{}, across_{};
};

}}  // namespace orispline
