// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include <orispline/curve/curve_through.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// A polynomial of u in [0, 1], in Bernstein form: its values lie in the hull of its coefficients.
struct HullPolynomial {
  BernsteinForm form;
  std::size_t degree;
};
using HullDerivatives = std::array<HullPolynomial, 6>;  ///< in time, of orders 0 to 5
using HullVector = std::array<HullPolynomial, 3>;       ///< components, of one degree

/// `duration` [s], of u from 0 to 1.
[[nodiscard]] HullDerivatives derivatives_of(const BernsteinForm& form, std::size_t degree, double duration);

/// The polynomial over a part of [0, 1], by de Casteljau's algorithm.
[[nodiscard]] HullPolynomial restricted(HullPolynomial p, double start, double end);

/// The size that no value exceeds.
[[nodiscard]] double largest(const HullPolynomial& p);

[[nodiscard]] Eigen::Vector3d coefficient(const HullVector& components, std::size_t i);

/// The length that no vector of these components exceeds.
[[nodiscard]] double longest(const HullVector& components);

/// What the motion is nowhere above: |ω| [rad/s], |α| [rad/s²], the jerk [rad/s³] and the snap, its derivative
/// [rad/s⁴].
struct HullBounds {
  double rate, acceleration, jerk, snap, crackle;
};

/// Bounds on a whole segment, and by how much evaluated ω, α and jerk may be off.
struct CoarseBounds {
  HullBounds all, rounding;
};

/// Those that cost the least, by the differences of the coefficients alone; nothing for a form that is not of
/// polynomials. `duration` [s].
[[nodiscard]] std::optional<CoarseBounds> coarse_bounds(const SegmentForm& form, double duration);

/// What an inertia tensor makes of such bounds.
class MomentBounds {
 public:
  explicit MomentBounds(const Eigen::Matrix3d& inertia);

  /// Of the torque Iα + ω × Iω [N m].
  [[nodiscard]] double torque(const HullBounds& b) const {
    return moment_ * b.acceleration + spread_ * b.rate * b.rate;
  }
  /// Of its second derivative [N m/s²].
  [[nodiscard]] double bend(const HullBounds& b) const {
    return moment_ * b.snap + 2.0 * spread_ * (b.jerk * b.rate + b.acceleration * b.acceleration);
  }
  /// By so much a torque may be off where ω, nowhere above `rate`, and α are off by so much.
  [[nodiscard]] double rounding(double rate, double off_rate, double off_acceleration) const {
    return weight_ * (off_acceleration + 2.0 * rate * off_rate);
  }

 private:
  double weight_, moment_;  ///< the norm, and the largest moment
  double spread_;           ///< what |ω × Iω| is at most for |ω| = 1, half of what the moments differ by
};

/// The segment's polynomials, whose values lie in the hulls of their coefficients.
///
/// For q = ∏ exp(X_k) of pure quaternions X_k, all exponentials are of norm 1, so that with A_n = Σ_k |X_k^(n)|,
/// bounded by the Bernstein coefficients of the derivatives, |q^(n)| ≤ Q_n with Q_1 = A_1, Q_2 = A_2 + A_1², Q_3 = A_3
/// + 3 A_1 A_2 + A_1³, Q_4 = A_4 + 4 A_1 A_3 + 3 A_2² + 6 A_1² A_2 + A_1⁴, and from ω = 2 q̄ q' the snap is at most 2
/// (Q_4 + 4 Q_1 Q_3 + 3 Q_2²). A bound that does not depend on where in its turns the body is counts where it is lower.
/// Source: our own derivation, docs/retime.md.
class SegmentHull {
 public:
  /// Nothing for a form that is not of polynomials. `duration` [s].
  [[nodiscard]] static std::optional<SegmentHull> of(const SegmentForm& form, double duration);

  /// Bounds for u from `start` to `end` in [0, 1].
  [[nodiscard]] HullBounds on(double start, double end) const;
  /// By so much evaluated ω, α and jerk may be off; none of the others. `whole`: the bounds of all of the segment.
  [[nodiscard]] HullBounds rounding(const HullBounds& whole) const;

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

/// The shortest step [s] of those that shape a segment: its own, and three on either side.
[[nodiscard]] double shortest_step_near(const Knots& knots, std::size_t segment);

}}  // namespace orispline
