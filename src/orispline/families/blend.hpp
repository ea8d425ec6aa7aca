// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <concepts>
#include <numeric>
#include <variant>
#include <vector>

#include <orispline/curve/family.hpp>
#include <orispline/curve/keyframe.hpp>
#include <orispline/curve/knots.hpp>
#include <orispline/curve/one_axis.hpp>
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

  /// Where it is at that time, from its key.
  template <Number T>
  [[nodiscard]] Displacement<Point, T> way(const T& t) const noexcept {
    const T tau = t - T(time);
    return (constant<T>(displacement.linear) + constant<T>(displacement.quadratic) * tau) * tau;
  }
  /// What that is made of.
  [[nodiscard]] std::array<Displacement<Point>, 3> ways(double step) const noexcept {
    return {displacement.linear * step, displacement.quadratic * step * step, Displacement<Point>::Zero()};
  }

  template <Number T>
  [[nodiscard]] PointOver<Point, T> operator()(const T& t) const noexcept {
    return displaced<T>(constant<T>(key), way(t));
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

  /// Of R⁴ [rad].
  template <Number T>
  [[nodiscard]] T angle_at(const T& t) const noexcept {
    const T tau = t - T(time);
    return (T(angle.linear) + T(angle.quadratic) * tau) * tau;
  }
  /// Where it is at that time, from its key, on a great circle.
  template <Number T>
  [[nodiscard]] Vector3<T> way(const T& t) const noexcept {
    return constant<T>(tangent) * T(angle_at(t) * Plain<T>(2.0));
  }
  /// What that is made of, with what keeps it from being a great circle.
  [[nodiscard]] std::array<Eigen::Vector3d, 3> ways(double step) const noexcept {
    return {2.0 * angle.linear * step * tangent, 2.0 * angle.quadratic * step * step * tangent, bend};
  }

  template <Number T>
  [[nodiscard]] Quaternion<T> operator()(const T& t) const noexcept {
    T sine, cosine, half_sine, half_cosine;
    const T phi = angle_at(t);
    sin_cos(phi, sine, cosine);
    sin_cos(T(phi * 0.5), half_sine, half_cosine);
    const T across = half_sine * half_sine * (2.0 * radius * radius);  // ρ²(1 - cos φ) without cancellation
    const Vector3<T> v = constant<T>(tangent) * T(sine * radius) + constant<T>(bend) * across;
    return constant<T>(key) * Quaternion<T>(T(1.0) - across, v.x(), v.y(), v.z());
  }
};

/// A circle, or the parabola in its place where two of the keys are too close to tell the circle, or where it would go
/// all round about one axis.
struct CircleOrParabola {
  Eigen::Quaterniond key;
  std::variant<CircularArc, Parabola<Eigen::Quaterniond>> kind;

  template <class Kind>
  CircleOrParabola(const Kind& one) : key(one.key), kind(one) {}  // NOLINT: it is either

  /// What `ask` says of it. `std::visit` might throw.
  template <class Ask>
  [[nodiscard]] auto of_kind(Ask ask) const noexcept {
    const auto* arc = std::get_if<CircularArc>(&kind);
    return arc != nullptr ? ask(*arc) : ask(*std::get_if<Parabola<Eigen::Quaterniond>>(&kind));
  }

  template <Number T>
  [[nodiscard]] Vector3<T> way(const T& t) const noexcept {
    return of_kind([&t](const auto& primitive) { return primitive.way(t); });
  }
  [[nodiscard]] std::array<Eigen::Vector3d, 3> ways(double step) const noexcept {
    return of_kind([step](const auto& primitive) { return primitive.ways(step); });
  }
  template <Number T>
  [[nodiscard]] Quaternion<T> operator()(const T& t) const noexcept {
    return of_kind([&t](const auto& primitive) { return primitive(t); });
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
    for (std::size_t i = 0; i < knots_.segments(); ++i) winding_.push_back(winds_about_one_axis(i));
  }

  [[nodiscard]] const Knots& knots() const noexcept { return knots_; }

  template <Number T>
  [[nodiscard]] PointOver<Point, T> point(const T& t, std::size_t segment) const noexcept {
    const T share = smooth_step(order_, knots_.span(segment).normalised(t));
    const Primitive &from = primitives_[segment], &to = primitives_[segment + 1];
    if (!winding_[segment]) return on_geodesic<T>(from(t), to(t), share);
    const Eigen::Vector3d step = displacement<double>(from.key, to.key);
    const Vector3<T> way = mixed<T>(from.way(t), Vector3<T>(constant<T>(step) + to.way(t)), share);
    return displaced_about_one_axis<T>(from.key, to.key, step, way, share);
  }

 private:
  /// Whether the two primitives of a segment come a full turn apart. About one axis they differ by a parabola that is 0
  /// at either end.
  [[nodiscard]] bool winds_about_one_axis(std::size_t segment) const noexcept {
    if constexpr (std::same_as<Point, Eigen::Vector3d>) return false;
    const KnotSpan span = knots_.span(segment);
    const Primitive &from = primitives_[segment], &to = primitives_[segment + 1];
    const double middle = std::midpoint(span.start(), span.end());
    const Eigen::Vector3d step = displacement<double>(from.key, to.key);
    if (!wraps(step + to.way(middle) - from.way(middle))) return false;
    const auto ahead = from.ways(span.step()), behind = to.ways(-span.step());
    return have_one_axis(std::array{step, ahead[0], ahead[1], ahead[2], behind[0], behind[1], behind[2]});
  }

  Knots knots_;
  std::vector<Primitive> primitives_;
  int order_;
  std::vector<bool> winding_;  ///< by segment; in space nothing winds
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
