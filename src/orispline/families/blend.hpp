// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>
#include <variant>
#include <vector>

#include <orispline/curve/family.hpp>
#include <orispline/curve/keyframe.hpp>
#include <orispline/curve/knots.hpp>
#include <orispline/math/geodesic.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

/// Where a parabola through 0 at its own key is, `time` after it: linear · time + quadratic · time².
template <class Value>
struct ParabolaThroughZero {
  Value linear, quadratic;
};

/// The parabola through three points in the chart at the middle one: q exp(a τ + b τ²), or p + a τ + b τ².
template <CurvePoint Point>
struct Parabola {
  Point key;
  double time;
  ParabolaThroughZero<Displacement<Point>> displacement;

  template <Number T>
  [[nodiscard]] PointOver<Point, T> operator()(const T& t) const noexcept {
    const T tau = t - T(time);
    return displaced<T>(constant<T>(key),
                        (constant<T>(displacement.linear) + constant<T>(displacement.quadratic) * tau) * tau);
  }
};

/// The circle of S³ through three keys, its arc angle a parabola in time, by what it is at the middle key: tangent and
/// bend make it up, so that no centre is needed and a great circle is nothing special.
///
/// q exp of the arc angle φ: 1 - ρ²(1 - cos φ) + ρ sin φ · tangent + ρ²(1 - cos φ) · bend, with ρ² = 1/(1 + bend²).
struct CircularArc {
  Eigen::Quaterniond key;
  double time;
  Eigen::Vector3d tangent;  ///< unit, in the body frame of the key
  Eigen::Vector3d bend;     ///< curvature in S³, across the tangent: zero on a great circle
  double radius;            ///< in R⁴: ρ
  ParabolaThroughZero<double> angle;

  template <Number T>
  [[nodiscard]] Quaternion<T> operator()(const T& t) const noexcept {
    const T tau = t - T(time);
    T sine, cosine, half_sine, half_cosine;
    const T phi = (T(angle.linear) + T(angle.quadratic) * tau) * tau;
    sin_cos(phi, sine, cosine);
    sin_cos(T(phi * 0.5), half_sine, half_cosine);
    const T across = half_sine * half_sine * (2.0 * radius * radius);  // ρ²(1 - cos φ) without cancellation
    const Vector3<T> v = constant<T>(tangent) * T(sine * radius) + constant<T>(bend) * across;
    return constant<T>(key) * Quaternion<T>(T(1.0) - across, v.x(), v.y(), v.z());
  }
};

/// A circle, or the parabola in its place where two of the keys are too close to tell the circle.
struct CircleOrParabola {
  std::variant<CircularArc, Parabola<Eigen::Quaterniond>> kind;

  template <Number T>
  [[nodiscard]] Quaternion<T> operator()(const T& t) const noexcept {
    return std::visit([&t](const auto& arc) { return arc(t); }, kind);
  }
};

/// The polynomial from 0 to 1 with `order` - 1 vanishing derivatives at either end, order 1 to 3.
template <Number T>
[[nodiscard]] T smooth_step(int order, const T& u) noexcept {
  if (order == 1) return u;
  if (order == 2) return u * u * (T(3.0) - T(2.0) * u);
  return u * u * u * (T(10.0) - u * (T(15.0) - T(6.0) * u));
}

/// Two neighbouring primitives, each a curve through three points, blended along the geodesic between them.
///
/// C^order in time on any knots: near a key the two differ by O(u) and the blending moves by O(u^order).
template <class Primitive, CurvePoint Point>
class BlendedCurve {
 public:
  /// One primitive per point.
  BlendedCurve(Knots knots, std::vector<Primitive> primitives, int order)
      : knots_(std::move(knots)), primitives_(std::move(primitives)), order_(order) {
    ORISPLINE_EXPECT(primitives_.size() == knots_.segments() + 1);
  }

  [[nodiscard]] const Knots& knots() const noexcept { return knots_; }

  template <Number T>
  [[nodiscard]] PointOver<Point, T> point(const T& t, std::size_t segment) const noexcept {
    const T u = knots_.span(segment).normalised(t);
    return on_geodesic<T>(primitives_[segment](t), primitives_[segment + 1](t), smooth_step(order_, u));
  }

 private:
  Knots knots_;
  std::vector<Primitive> primitives_;
  int order_;
};

template <CurvePoint Point>
using BlendedParabolas = BlendedCurve<Parabola<Point>, Point>;
inline constexpr std::array blend_parameters{Parameter{"order", 2.0, 1.0, 3.0, false}};
inline constexpr std::array blend_ends{EndRule::natural};

/// Blended parabolas in the rotation-vector chart at each key.
struct LogParabola {
  static constexpr FamilyInfo info{.name = "log-parabola",
                                   .title = "Two parabolas in the logarithm, blended",
                                   .source = "derived, docs/families/log-parabola.md; after Kim & Nam 1995",
                                   .continuity_uniform = 2,
                                   .continuity_uneven = 2,
                                   .keeps_constant_rate_uniform = true,
                                   .keeps_constant_rate_uneven = true,
                                   .support_keys = 4,
                                   .parameters = blend_parameters,
                                   .ends = blend_ends};
  template <CurvePoint P = Eigen::Quaterniond>
  [[nodiscard]] static Expected<BlendedParabolas<P>> curve(const Keyframes& keys, const FamilySettings& settings);
};

/// Blended circular arcs, their arc angle a parabola in time.
struct Circular {
  using Curve = BlendedCurve<CircleOrParabola, Eigen::Quaterniond>;
  static constexpr FamilyInfo info{.name = "circular",
                                   .title = "Two circles blended",
                                   .source = "Kim & Nam 1995; made C^k in time, docs/families/circular.md",
                                   .continuity_uniform = 2,
                                   .continuity_uneven = 2,
                                   .keeps_constant_rate_uniform = true,
                                   .keeps_constant_rate_uneven = true,
                                   .support_keys = 4,
                                   .parameters = blend_parameters,
                                   .ends = blend_ends};
  [[nodiscard]] static Expected<Curve> curve(const Keyframes& keys, const FamilySettings& settings);
  /// The parabolas of log-parabola: a circle through three positions knows nothing of time, and may be a line.
  [[nodiscard]] static Expected<BlendedParabolas<Eigen::Vector3d>> path(const Keyframes& keys,
                                                                        const FamilySettings& settings) {
    return LogParabola::curve<Eigen::Vector3d>(keys, settings);
  }
};

}}}  // namespace orispline::families
