// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <span>
#include <vector>

#include <orispline/curve/curve_through.hpp>
#include <orispline/curve/knots.hpp>
#include <orispline/curve/motion.hpp>
#include <orispline/curve/two_point_blending.hpp>
#include <orispline/math/geodesic.hpp>
#include <orispline/math/jet.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Cumulative blending functions: what a family of the form q(t) = q₀ ∏ exp(β̃_k(t) φ_k) states about itself.
///
/// On the knot span i, `b(span, t)` gives β̃_1…β̃_m at time t [s] over any Number; knot spacing enters by the chain
/// rule, so that a Jet in t yields time derivatives. `increments` is m, `stride` the number of control points that the
/// next span moves on, `degree` the largest polynomial degree in t, 0 for other functions.
template <class B>
concept CumulativeBasis = requires(const B& b, KnotSpan span, double t, Jet<double, 3> jet) {
  { B::increments } -> std::convertible_to<std::size_t>;
  { B::stride } -> std::convertible_to<std::size_t>;
  { B::degree } -> std::convertible_to<int>;
  { b(span, t) } -> std::same_as<std::array<double, B::increments>>;
  { b(span, jet) } -> std::same_as<std::array<Jet<double, 3>, B::increments>>;
};

/// What a cumulative curve multiplies together, or in space adds up: segment i is
/// bases[i] ∏ exp(β̃_k increments[i·stride + k - 1]).
///
/// Increments are kept, not recomputed from control points: those of ghost keys may be longer than 2π.
template <CurvePoint P = Eigen::Quaterniond>
struct ControlPolygon {
  std::vector<P> bases;                     ///< one per segment
  std::vector<Displacement<P>> increments;  ///< from each control point to the next
};

/// The polygon through control points: segment i begins at point i · stride.
template <CurvePoint P>
[[nodiscard]] ControlPolygon<P> polygon_through(std::span<const P> points, std::size_t increments, std::size_t stride) {
  ControlPolygon<P> polygon{.bases = {}, .increments = increments_between(points)};
  polygon.bases.reserve((points.size() - increments) / stride + 1);
  for (std::size_t i = 0; i + increments < points.size(); i += stride) polygon.bases.push_back(points[i]);
  return polygon;
}

/// The motion after one more factor exp(b(t) φ), b as a jet in t.
///
/// ω ← Rᵀω + b'φ, α ← Rᵀα + b'(ω×φ) + b''φ, and the jerk in the same way. Cross products with φ leave out the parts
/// along φ: they are zero, and exactly so for a single factor.
template <Number T>
[[nodiscard]] MotionOver<T> with_factor(const MotionOver<T>& m, const Vector3<T>& phi, const Jet<T, 3>& b) noexcept {
  using Vector = Vector3<T>;
  const T b1 = b.derivative(1), b2 = b.derivative(2), b3 = b.derivative(3);
  const Quaternion<T> factor = exp<T>(b.c[0] * phi);
  const Vector carried_velocity = to_body<T>(factor, m.angular_velocity);
  const Vector turn = carried_velocity.cross(phi);
  const Vector carried_acceleration = to_body<T>(factor, m.angular_acceleration) + b1 * turn;
  return {.orientation = m.orientation * factor,
          .angular_velocity = carried_velocity + b1 * phi,
          .angular_acceleration = carried_acceleration + b2 * phi,
          .angular_jerk = to_body<T>(factor, m.angular_jerk) + b2 * turn +
                          T(2.0) * b1 * carried_acceleration.cross(phi) - b1 * b1 * turn.cross(phi) + b3 * phi};
}

/// base ∏ exp(β̃_k(t) φ_k), in space base + Σ β̃_k(t) d_k, over any Number on one knot span.
template <CumulativeBasis B, CurvePoint P, Number T>
[[nodiscard]] PointOver<P, T> cumulative_point(const B& basis, KnotSpan span, const T& t, const P& base,
                                               std::span<const Displacement<P>, B::increments> increments) noexcept {
  const std::array<T, B::increments> b = basis(span, t);
  std::array<Displacement<P, T>, B::increments> parts;
  for (std::size_t k = 0; k < B::increments; ++k) parts[k] = constant<T>(increments[k]) * b[k];
  return displaced_in_turn(constant<T>(base), parts);
}

/// The orientation of cumulative_point() with body rates, at t [s].
template <CumulativeBasis B>
[[nodiscard]] Motion cumulative_motion(const B& basis, KnotSpan span, double t, const Eigen::Quaterniond& base,
                                       std::span<const Eigen::Vector3d, B::increments> increments) noexcept {
  const auto b = basis(span, Jet<double, 3>::variable(t));
  Motion m{.orientation = base};
  for (std::size_t k = 0; k < B::increments; ++k) m = with_factor(m, increments[k], b[k]);
  return m;
}

/// THE evaluator: any cumulative basis over control orientations becomes orientation, ω, α and jerk, and over control
/// positions a curve in space.
///
/// q(t) = q₀ ∏ exp(β̃_k(t) φ_k) and p(t) = p₀ + Σ β̃_k(t) (p_k - p_{k-1}). Each factor carries the rates of the product
/// before it into its own frame and adds its own.
/// Source: Kim, Kim & Shin 1995 (the form); Sommer et al. 2020 (the recurrence), here with the jerk, derived in
/// docs/conventions.md; the papers' curves in R^d (Tan 2018, (3.1); 003 §3.1.1).
template <CumulativeBasis B, CurvePoint P = Eigen::Quaterniond>
class CumulativeCurve {
 public:
  static constexpr int degree = B::degree;

  CumulativeCurve(Knots knots, B basis, ControlPolygon<P> polygon)
      : knots_(std::move(knots)), basis_(std::move(basis)), polygon_(std::move(polygon)) {
    ORISPLINE_EXPECT(polygon_.bases.size() >= knots_.segments());
    ORISPLINE_EXPECT(polygon_.increments.size() >= (knots_.segments() - 1) * B::stride + B::increments);
  }
  /// From the control points themselves.
  CumulativeCurve(Knots knots, B basis, std::span<const P> points)
      : CumulativeCurve(std::move(knots), std::move(basis), polygon_through(points, B::increments, B::stride)) {}

  [[nodiscard]] const Knots& knots() const noexcept { return knots_; }
  [[nodiscard]] const B& basis() const noexcept { return basis_; }
  [[nodiscard]] const ControlPolygon<P>& polygon() const noexcept { return polygon_; }

  /// The point over any Number; of an orientation, with jets in t, this is the whole-quaternion oracle of the
  /// recurrence.
  template <Number T>
  [[nodiscard]] PointOver<P, T> point(const T& t, std::size_t segment) const noexcept {
    return cumulative_point<B, P, T>(basis_, knots_.span(segment), t, polygon_.bases[segment], increments_of(segment));
  }

  /// Orientation and body rates at t [s] of the given segment.
  [[nodiscard]] Motion motion(double t,
                              std::size_t segment) const noexcept requires std::same_as<P, Eigen::Quaterniond> {
    return cumulative_motion(basis_, knots_.span(segment), t, polygon_.bases[segment], increments_of(segment));
  }

  /// The segment as polynomials, where it is of at most three factors of degree 7 at most.
  [[nodiscard]] SegmentForm form(std::size_t segment) const noexcept requires std::same_as<P, Eigen::Quaterniond> {
    constexpr bool is_stored = requires { basis_.forms(segment); };
    if constexpr (B::increments > 3 || (!is_stored && B::degree < 1) || B::degree > static_cast<int>(form_degree))
      return {};
    else {
      CumulativeForm form{.degree = static_cast<std::size_t>(B::degree),
                          .base = polygon_.bases[segment],
                          .increments = {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()},
                          .blending = {}};
      if constexpr (is_stored) {
        form.degree = basis_.stored_degree();
        if (form.degree > form_degree) return {};
        form.blending = basis_.forms(segment);
      } else if constexpr (requires { basis_.coefficients(knots_.span(segment)); }) {
        const auto rows = basis_.coefficients(knots_.span(segment));
        for (std::size_t k = 0; k < rows.size(); ++k) std::ranges::copy(rows[k], form.blending[k].coefficients.begin());
      } else {
        form.degree = two_point_degree<B::degree>;
        form.blending = two_point_forms<B::increments, B::degree>(knots_.span(segment), basis_);
      }
      for (std::size_t k = 0; k < B::increments; ++k) form.increments[k] = polygon_.increments[segment * B::stride + k];
      return form;
    }
  }

 private:
  [[nodiscard]] std::span<const Displacement<P>, B::increments> increments_of(std::size_t segment) const noexcept {
    return std::span<const Displacement<P>, B::increments>(polygon_.increments.data() + segment * B::stride,
                                                           B::increments);
  }

  Knots knots_;
  [[no_unique_address]] B basis_;
  ControlPolygon<P> polygon_;
};

/// The Euclidean curve of the same blending functions.
template <CumulativeBasis B>
using CumulativePath = CumulativeCurve<B, Eigen::Vector3d>;

}}  // namespace orispline
